/** A script's line as its conversation needs it: a socket that also knows what was taken on the other side. */
import type { SocketPort } from "@corridor/protocol";
import type { CarriedSnapshot } from "../sessions/carried-snapshot.ts";
import type { ReaderFlow } from "../sessions/reader-feed.ts";

export interface ReaderLine extends SocketPort {
  readonly door: "websocket" | "line";
  readonly flow: ReaderFlow;
  /** Sends messages, several in one go; does nothing once the line is closed. */
  send(...texts: string[]): void;
  /** Sends a snapshot as it came. */
  pass(snapshot: CarriedSnapshot): void;
}
