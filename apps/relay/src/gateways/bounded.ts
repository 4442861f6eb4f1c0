/**
 * A bound on the messages of one page that are taken but not finished. They wait for the store one after
 * the other, so whoever sends without end would fill the memory of the relay.
 */
import { closeReasons } from "@corridor/protocol";
import { limits } from "../sessions/limits.ts";
import { closeWith, type Conversation } from "./conversation.ts";
import type { ReaderLine } from "./reader-line.ts";

/** The same conversation, closed once too many of its messages are unfinished. */
export function bounded(
  conversation: Conversation,
  line: Pick<ReaderLine, "isOpen" | "close">,
): Conversation {
  let unfinished = 0;
  let isLooking = false;
  const isOver = (): boolean => unfinished > limits.unfinishedMessages;
  // Only after this turn: snapshots that a network held up come all at once, and wait for nothing.
  const look = (): void => {
    isLooking = false;
    if (!isOver() || !line.isOpen) return;
    const detail = "Too many messages came before the first were done. Wait for the answers.";
    closeWith(line, closeReasons.badFrame, detail);
  };
  return {
    received: (bytes) => {
      const work = conversation.received(bytes);
      if (work === undefined) return undefined;
      unfinished += 1;
      if (isOver() && !isLooking) {
        isLooking = true;
        setImmediate(look);
      }
      return work.finally(() => (unfinished -= 1));
    },
    heartbeat: () => conversation.heartbeat(),
    closed: (saidGoodbye) => conversation.closed(saidGoodbye),
  };
}
