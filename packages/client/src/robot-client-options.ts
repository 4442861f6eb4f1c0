import type { UntilCondition } from "@corridor/protocol";
import type { Platform } from "./platform.ts";

/** Options of a command. */
export interface CommandOptions {
  /**
   * time to live: ms within which the command must start, or it ends as `expired`. 200 to 60000;
   * default: `ttl` of the robot. It must be longer than the round trip to the robot
   */
  ttl?: number;
  /** `true` ends all earlier commands as `superseded`, and starts this one at once */
  replace?: boolean;
}

/** Options of `forward` and `reverse`. */
export interface MotionOptions extends CommandOptions {
  /**
   * conditions that end the motion as `completed`: up to 200, such as `{ sensor: "front", is: "<=",
   * than: 60 }` or `{ goal: true }`. The robot checks them before the motion and after every tick
   */
  until?: UntilCondition | readonly UntilCondition[];
}

/** Options of `drive`. */
export interface DriveOptions extends MotionOptions {
  /** ms after which the robot stops unless another `drive` follows: 100 to 2000; default 500 */
  lease?: number;
}

/** Options of `connect` and `pair`. */
export interface RobotClientOptions {
  /** default `ttl` of commands except `stop`, in ms; default 10 s */
  ttl?: number;
  /** name of this script, which the robot's owner sees; at most 40 characters are displayed */
  name?: string;
  /** timeout for responses of the relay in ms, including reconnects; default 30 s */
  answerTimeout?: number;
  /** timeout for the robot to finish a command in ms; default 10 minutes */
  finishTimeout?: number;
  /**
   * WebSocket, HTTP, clock and random numbers, to replace in tests; default: those of the browser
   * or Node
   */
  platform?: Platform;
}
