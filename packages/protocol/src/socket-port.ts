/**
 * The smallest socket that both ends of the line need, so that neither the client nor the relay's
 * sessions know which WebSocket they run on. Messages are text; order is kept.
 */
export interface SocketPort {
  /** Sends one message; does nothing once the socket is closed. */
  send(text: string): void;
  /** Closes with a code (1000 or 4000 to 4999) and a reason of at most 123 bytes. */
  close(code: number, reason: string): void;
  readonly isOpen: boolean;
  /** bytes that were sent but have not left this machine */
  readonly waitingBytes: number;
}

/** What the holder of a socket hears from it. `closed` comes exactly once, and last. */
export interface SocketEvents {
  opened(): void;
  received(text: string): void;
  closed(code: number): void;
}

/** Opens a socket. Nothing is reported before the call has returned. */
export type SocketFactory = (url: string, events: SocketEvents) => SocketPort;
