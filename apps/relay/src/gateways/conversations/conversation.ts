/**
 * Protocol of one connection after its first message, as a page, a script or a member of a class.
 * Independent of the transport.
 */
import { closeReasons, type CloseReason, type SocketPort } from "@corridor/protocol";
import type { OverReason, ReaderFlow } from "../../robots/readers/feed.ts";
import { scriptIsBlocked } from "../../robots/access/callers.ts";
import { keyRevoked } from "../../robots/access/key-ring.ts";
import type { CarriedSnapshot } from "../../bus/carried-snapshot.ts";

export interface Conversation {
  /**
   * Handles one client message, JSON in UTF-8. The conversation owns the bytes. The robot
   * serialises the effects of calls.
   * @returns a promise for completion, or undefined if already complete. Most messages are
   * snapshots and acknowledgements of them, tens of thousands a second, which never wait
   * @throws Refusal if the client may not send the message
   */
  received(bytes: Buffer): Promise<void> | undefined;
  /** Sends a heartbeat, as evidence for the client that the connection works. */
  heartbeat(): void;
  /**
   * Called once when the connection is closed.
   * @param isClosedByClient the client closed it, so all of its messages were received
   */
  closed(isClosedByClient: boolean): void;
}

/** Handles a message. @param onError receives synchronous and asynchronous errors */
export function handleMessage(
  conversation: Conversation,
  bytes: Buffer,
  onError: (error: unknown) => void,
): void {
  try {
    conversation.received(bytes)?.catch(onError);
  } catch (error) {
    onError(error);
  }
}

/** Closes a connection with a standard reason and a text that a student can act on. */
export function closeWith(
  port: { close(code: number, reason: string): void },
  reason: CloseReason,
  detail?: string,
): void {
  port.close(reason.code, shortReason(detail ?? `${reason.cause}. ${reason.remedy}`));
}

/** Closes the connection of a reader with the reason. */
export function closeReader(port: Parameters<typeof closeWith>[0], reason: OverReason): void {
  if (reason === "revoked") {
    return closeWith(port, closeReasons.notAuthorised, keyRevoked().problem.detail);
  }
  if (reason === "blocked") {
    return closeWith(port, closeReasons.forbidden, scriptIsBlocked().problem.detail);
  }
  closeWith(port, closeReasons[reason]);
}

/** A close reason is limited to 123 bytes of UTF-8. */
function shortReason(text: string): string {
  const bytes = new TextEncoder().encode(text);
  if (bytes.length <= 123) return text;
  return new TextDecoder().decode(bytes.slice(0, 120)).replace(/\uFFFD+$/, "") + "…";
}

export interface ClientConnection extends SocketPort {
  readonly transport: "websocket" | "long-poll-connection";
  readonly flow: ReaderFlow;
  /** Sends messages in one write. Does nothing once the connection is closed. */
  send(...texts: string[]): void;
  /** Forwards a snapshot in its encoded form. */
  sendSnapshot(snapshot: CarriedSnapshot): void;
}
