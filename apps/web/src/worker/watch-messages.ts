/** What crosses between the page of an onlooker and its worker; both ends are our own code. */
import type { WatchStatus } from "@corridor/client/watch";
import type { MazeDocument } from "@corridor/maze";
import type { Snapshot } from "@corridor/protocol";
import type { StageToWorker } from "./stage-messages.ts";
import type { FromWorker } from "./worker-messages.ts";

/** The robot that is watched, and the key that allows it. */
export interface WatchedRobot {
  id: string;
  key: string;
}

export type ToWatcher =
  | StageToWorker
  /** looks on at this robot, at no other from now on; null: at none */
  | { type: "watch"; robot: WatchedRobot | null }
  /** the device has a network again */
  | { type: "watch-again" };

export type FromWatcher =
  | Extract<FromWorker, { type: "picture" | "stage-scroll-to" }>
  | { type: "watch-status"; status: WatchStatus }
  /** a few times a second, and at once when more than numbers have changed */
  | { type: "watch-snapshot"; snapshot: Snapshot }
  /** null: nobody knows it */
  | { type: "watch-maze"; maze: MazeDocument | null };
