/**
 * What is said on one socket after its first message: a page's or a script's part of the protocol.
 * Knows the messages, not the WebSocket.
 */
import { closeReasons, type CloseReason } from "@corridor/protocol";
import type { OverReason } from "../sessions/reader-feed.ts";
import { scriptIsAway } from "../sessions/script-gate.ts";

export interface Conversation {
  /**
   * One message of the client, JSON as UTF-8; the bytes are the conversation's from then on. Calls do not overlap in effect: the session puts them in order.
   * @returns once it is done; undefined where it is already: most are snapshots and what readers have
   *   seen of them, tens of thousands a second, which wait for nothing
   * @throws Refusal when it may not be said
   */
  received(bytes: Buffer): Promise<void> | undefined;
  /** Keeps the client sure that the line is alive. */
  heartbeat(): void;
  /**
   * The socket is closed.
   * @param saidGoodbye the other side closed it, so all that it had to say was heard
   */
  closed(saidGoodbye: boolean): void;
}

/** Passes a message on. @param failed is told why it could not be served, now or later */
export function hear(
  conversation: Conversation,
  bytes: Buffer,
  failed: (error: unknown) => void,
): void {
  try {
    conversation.received(bytes)?.catch(failed);
  } catch (error) {
    failed(error);
  }
}

/** Closes a socket with a known reason, in words that a student can act on. */
export function closeWith(
  port: { close(code: number, reason: string): void },
  reason: CloseReason,
  detail?: string,
): void {
  port.close(reason.code, shortReason(detail ?? `${reason.cause}. ${reason.remedy}`));
}

/** Tells a reader why it gets nothing more. */
export function sayGoodbye(port: Parameters<typeof closeWith>[0], reason: OverReason): void {
  if (reason === "revoked") {
    const detail = "This key was revoked. Copy the robot's new address from its page.";
    return closeWith(port, closeReasons.notAuthorised, detail);
  }
  if (reason === "sentAway") {
    return closeWith(port, closeReasons.forbidden, scriptIsAway().problem.detail);
  }
  closeWith(port, closeReasons[reason]);
}

/** A close reason may have 123 bytes of UTF-8. */
function shortReason(text: string): string {
  const bytes = new TextEncoder().encode(text);
  if (bytes.length <= 123) return text;
  return new TextDecoder().decode(bytes.slice(0, 120)).replace(/\uFFFD+$/, "") + "…";
}
