/**
 * The run as the panels show it: the newest snapshot at a throttled rate, the speed, and the newest
 * event. The stage does not read this store; the worker draws the stage from the run itself.
 */
import type { MazeDocument } from "@corridor/maze";
import type { DriverName, Snapshot } from "@corridor/protocol";
import type { Progress } from "@corridor/simulation";
import { createStore } from "zustand/vanilla";
import type { RunEvent, Speed } from "../../simulator/protocol/worker-messages.ts";
import type { RunView } from "../../stage/drawing/frame.ts";

export interface RunState {
  /** at the displayed tick; null before the worker's first frame */
  snapshot: Snapshot | null;
  /** whether the displayed tick was cut from the run; the next frame shows the run as it is now */
  isCut: boolean;
  /** whether the run ended at the displayed tick, so that no line decides on the readings there */
  hasEnded: boolean;
  /** progress of the running manoeuvre at the displayed tick; null if none runs */
  progress: Progress | null;
  /** whether the newest or an earlier tick is displayed */
  view: RunView;
  /** the run's last tick; the displayed tick is the snapshot's */
  nowTick: number;
  /** ticks up to the displayed one in which a script made the robot wait; in the others it drove */
  waited: number;
  /**
   * the driver at the newest tick, null before the first frame; the driver at the displayed tick is
   * the snapshot's
   */
  nowDriver: DriverName | null;
  /** the maze at the displayed tick if it differs from the workspace's; otherwise null */
  pastMaze: MazeDocument | null;
  speed: Speed;
  /** the newest bump or goal since the last reset; null without one */
  event: RunEvent | null;
  /** why the simulator stopped for good, in its own words; null while it works */
  fault: string | null;
}

export function createRunStore() {
  return createStore<RunState>()(() => ({
    snapshot: null,
    isCut: false,
    hasEnded: false,
    progress: null,
    view: "now",
    nowTick: 0,
    waited: 0,
    nowDriver: null,
    pastMaze: null,
    speed: 1,
    event: null,
    fault: null,
  }));
}
export type RunStore = ReturnType<typeof createRunStore>;

/** The ticks after this one (-1: all) are no longer part of the run. */
export function truncateRun(run: RunStore, after: number): void {
  const { snapshot } = run.getState();
  if (snapshot !== null && snapshot.tick > after) run.setState({ isCut: true });
}
