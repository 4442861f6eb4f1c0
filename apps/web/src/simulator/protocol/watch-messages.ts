/** Messages between the page of a viewer and its worker. */
import type { WatchStatus } from "@corridor/client/watch";
import type { MazeDocument } from "@corridor/maze";
import type { Snapshot } from "@corridor/protocol";
import type { StageFromWorker, StageToWorker } from "../../stage/stage-messages.ts";

/** The watched robot, and its watch key. */
export interface WatchedRobot {
  id: string;
  key: string;
}

export type ToWatcher =
  | StageToWorker
  /** watches only this robot from now on; null: none */
  | { type: "watch"; robot: WatchedRobot | null }
  /** the device is online again */
  | { type: "watch-again" }
  /** whether marks of scripts are drawn over the maze */
  | { type: "hide-marks"; isHidden: boolean };

export type FromWatcher =
  | StageFromWorker
  | { type: "watch-status"; status: WatchStatus }
  /** a few times a second, and at once if more than numbers have changed */
  | { type: "watch-snapshot"; snapshot: Snapshot }
  /** a script has marked cells; sent once for each robot */
  | { type: "watch-marks" }
  /** null: unknown */
  | { type: "watch-maze"; maze: MazeDocument | null };
