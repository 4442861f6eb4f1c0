/**
 * What the panels show of the run: the newest snapshot at a calm rate, the speed, and what happened.
 * The stage does not read this store; the worker draws it from the run itself.
 */
import type { MazeDocument } from "@corridor/maze";
import type { DriverName, Snapshot } from "@corridor/protocol";
import type { Progress } from "@corridor/simulation";
import { createStore } from "zustand/vanilla";
import type { Moment, RunView, Speed } from "../worker/worker-messages.ts";

export interface RunState {
  /** of the shown moment; null until the worker has sent its first frame */
  snapshot: Snapshot | null;
  /** how far the running manoeuvre is at the shown moment; null when none runs */
  progress: Progress | null;
  /** which moment is shown */
  view: RunView;
  /** the run's last tick; the shown one is the snapshot's */
  nowTick: number;
  /** ticks up to the shown moment in which a script let the robot wait; the others it drove */
  waited: number;
  /** who drives the newest moment, null before the first frame; the driver of the shown one is the snapshot's */
  nowDriver: DriverName | null;
  /** the maze of the shown moment where it is not the workspace's; null when it is */
  shownMaze: MazeDocument | null;
  speed: Speed;
  /** the newest bump or goal since the robot was last put at its start; null when there is none */
  moment: Moment | null;
  /** why the simulator stopped for good, in its own words; null while it works */
  fault: string | null;
}

export function createRunStore() {
  return createStore<RunState>()(() => ({
    snapshot: null,
    progress: null,
    view: "now",
    nowTick: 0,
    waited: 0,
    nowDriver: null,
    shownMaze: null,
    speed: 1,
    moment: null,
    fault: null,
  }));
}
export type RunStore = ReturnType<typeof createRunStore>;
