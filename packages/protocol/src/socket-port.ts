/**
 * The socket operations that clients and relay need, independent of the WebSocket implementation.
 * Messages are text and arrive in order.
 */
export interface SocketPort {
  /** Sends one message; does nothing once the socket is closed. */
  send(text: string): void;
  /** Closes with a code (1000 or 4000 to 4999) and a reason of at most 123 bytes. */
  close(code: number, reason: string): void;
  readonly isOpen: boolean;
  /** bytes that were sent and are still buffered on this machine */
  readonly waitingBytes: number;
}

/** Callbacks of a socket. `closed` is called exactly once, as the last one. */
export interface SocketEvents {
  opened(): void;
  received(text: string): void;
  closed(code: number): void;
}

/** Opens a socket. Calls no callback before it has returned. */
export type SocketFactory = (url: string, events: SocketEvents) => SocketPort;
