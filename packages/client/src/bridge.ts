/** Entry "@corridor/client/bridge": for bridges to other protocols. Not part of the npm package. */
export type { MarkingPort } from "./client-port.ts";
export { connectPort, type BridgeClientOptions } from "./connect-port.ts";
export { parseRobotAddress } from "./robot-address.ts";
