export { ClientError, type ClientErrorCode } from "./client-error.ts";
export type { RobotEvent } from "./event-inbox.ts";
export type { MazeCell, RobotMaze } from "./robot-maze.ts";
export type {
  CommandOptions,
  DriveOptions,
  MotionOptions,
  RobotClientOptions,
} from "./robot-client-options.ts";
export { RobotClient } from "./robot-client.ts";
export type {
  CommandRecord,
  Pose,
  SensorReadings,
  Snapshot,
  UntilCondition,
} from "@corridor/protocol";
