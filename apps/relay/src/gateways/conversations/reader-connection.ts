/**
 * A connection as its conversation needs it: a socket that also reports what the client has
 * received.
 */
import type { SocketPort } from "@corridor/protocol";
import type { CarriedSnapshot } from "../../bus/carried-snapshot.ts";
import type { ReaderFlow } from "../../robots/readers/feed.ts";

export interface ReaderConnection extends SocketPort {
  readonly transport: "websocket" | "long-poll-connection";
  readonly flow: ReaderFlow;
  /** Sends messages in one write. Does nothing once the connection is closed. */
  send(...texts: string[]): void;
  /** Forwards a snapshot in its encoded form. */
  sendSnapshot(snapshot: CarriedSnapshot): void;
}
