/** A script's line as its conversation needs it: a socket that also knows what was taken on the other side. */
import type { SocketPort } from "@corridor/protocol";
import type { ReaderFlow } from "../sessions/reader-feed.ts";

export interface ReaderLine extends SocketPort {
  readonly door: "websocket" | "line";
  readonly flow: ReaderFlow;
  /** Sends a message that is UTF-8 already; nobody changes it any more. */
  pass(message: Buffer): void;
}
