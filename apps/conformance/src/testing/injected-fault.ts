/** A fault in a copy of the example, and the promise whose check must fail first. */
import type { Edit } from "./physical-robot.ts";
import type { BridgeFault } from "./websocket-bridge.ts";

export interface InjectedFault {
  fault: string;
  edits: readonly Edit[];
  caughtBy: string;
  /** a fault of the WebSocket, which only the bridge adds to the example */
  bridge?: BridgeFault;
}
