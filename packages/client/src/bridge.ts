/** Entry "@corridor/client/bridge": for bridges to other protocols. Not part of the npm package. */
export { connectPort, type BridgeClientOptions } from "./connect-port.ts";
export { parseRobotAddress, type RobotAddress } from "./robot-address.ts";
