/** A fault in a copy of the physical robot example, and the check that must fail first. */
import type { Edit } from "./source-edits.ts";
import type { BridgeFault } from "./websocket-bridge.ts";

export interface InjectedFault {
  fault: string;
  edits: readonly Edit[];
  /** the promise whose check must fail first */
  caughtBy: string;
  /** a fault of the WebSocket, which only the bridge adds to the example */
  bridge?: BridgeFault;
}

export const BODY = "physical_robot/body.py";
export const HOST = "robot_host.py";
export const COMMAND_STORE = "physical_robot/command_store.py";
export const CONDITIONS = "physical_robot/conditions.py";
export const LONG_POLL = "physical_robot/long_poll.py";
export const COMMAND_REQUESTS = "physical_robot/command_requests.py";
export const CONTROLLER = "physical_robot/controller.py";
export const VALIDATION = "physical_robot/validation.py";
export const SERVER = "physical_robot/server.py";

/** A fault that replaces one text of the source. */
export function fault(
  caughtBy: string,
  what: string,
  file: string,
  before: string,
  after: string,
): InjectedFault {
  return { fault: what, caughtBy, edits: [{ file, before, after }] };
}

export function bridgeFault(caughtBy: string, what: string, bridge: BridgeFault): InjectedFault {
  return { fault: what, caughtBy, edits: [], bridge };
}
