/** What is wrong with a copy of the example, and the promise whose check is the first to fail. */
import type { Edit } from "./physical-robot.ts";
import type { BridgeFault } from "./websocket-bridge.ts";

export interface InjectedFault {
  fault: string;
  edits: readonly Edit[];
  caughtBy: string;
  /** for a WebSocket, which the example has by a bridge alone */
  bridge?: BridgeFault;
}
