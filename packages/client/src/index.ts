export { ClientError, type ClientErrorCode } from "./client-error.ts";
export { RobotClient, type RobotClientOptions } from "./robot-client.ts";
