/**
 * Limits the number of unfinished messages of one page. They wait for the store, so a page that
 * sends without waiting could exhaust the relay's memory.
 */
import { closeReasons } from "@corridor/protocol";
import { limits } from "../../platform/limits/limits.ts";
import { closeWith, type Conversation, type ClientConnection } from "./conversation.ts";

/** Wraps a conversation and closes its connection when too many messages are unfinished. */
export function withBoundedQueue(
  conversation: Conversation,
  connection: Pick<ClientConnection, "isOpen" | "close">,
): Conversation {
  let unfinished = 0;
  let isCheckScheduled = false;
  const isExceeded = (): boolean => unfinished > limits.unfinishedMessages;
  // Checked after this turn, because snapshots that a network delayed arrive together and finish
  // immediately.
  const check = (): void => {
    isCheckScheduled = false;
    if (!isExceeded() || !connection.isOpen) return;
    const detail = "Too many unfinished messages. Wait for the responses.";
    closeWith(connection, closeReasons.badFrame, detail);
  };
  return {
    received: (bytes) => {
      const pending = conversation.received(bytes);
      if (pending === undefined) return undefined;
      unfinished += 1;
      if (isExceeded() && !isCheckScheduled) {
        isCheckScheduled = true;
        setImmediate(check);
      }
      return pending.finally(() => (unfinished -= 1));
    },
    heartbeat: () => conversation.heartbeat(),
    closed: (isClosedByClient) => conversation.closed(isClosedByClient),
  };
}
