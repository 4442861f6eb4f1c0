/** The state of the robot that the stage draws. */
import type { CellMark, DriverName, Snapshot } from "@corridor/protocol";
import type { Progress } from "@corridor/simulation";

/**
 * Largest number of corners that are drawn, the newest. A corner costs two numbers, and one line when
 * the trail is redrawn. A jump brings no more of them.
 */
export const MAX_CORNERS = 20_000;
/** Largest number of bumps that are marked, the newest. */
export const MAX_BUMPS = 100;

/** Which tick is displayed: the newest, an earlier one, or a playback towards the newest. */
export type RunView = "now" | "past" | "playing";

/**
 * The drawn state: the snapshot at the displayed tick, and changes of the trail since the last
 * frame.
 */
export interface Frame {
  snapshot: Snapshot;
  /**
   * whether the run ended at the displayed tick: by a bump, at the goal, or with the time of the
   * challenge. The snapshot then names the line that drove last, and no line decides on its readings
   */
  hasEnded: boolean;
  /** progress of the running manoeuvre at the displayed tick; null if none runs */
  progress: Progress | null;
  view: RunView;
  /** the run's last tick; the displayed tick is the snapshot's */
  nowTick: number;
  /** ticks up to the displayed one in which a script made the robot wait */
  waited: number;
  /** the driver at the newest tick; the driver at the displayed tick is the snapshot's */
  nowDriver: DriverName;
  /** increases with each added or discarded input: a run saved before is outdated then */
  revision: number;
  /** when the run began or was opened, in ms since 1970; 0 for a viewer, who does not know it */
  startedAt: number;
  /**
   * New corners of the trail, x and y alternating, in units; its end is the pose. Packed when sent
   * to the page: a jump has 40,000 numbers, and as many objects cost 15 ms of garbage collection.
   */
  corners: readonly number[] | Float64Array;
  /** positions of the robot's centre at new bumps, x and y alternating, in units */
  bumps: number[];
  /** true if the trail and the bumps start again: discard those drawn so far */
  trailReset: boolean;
  /** the ghosts of a race at the displayed tick; absent without a race */
  ghosts?: readonly GhostPose[];
  /** marks of scripts over the maze; absent without any */
  marks?: readonly CellMark[] | undefined;
}

/** The letters of a race's ghosts. With the student's robot, a race has up to eight robots. */
export const GHOST_BADGES = ["A", "B", "C", "D", "E", "F", "G"];
/** More ghosts would hide each other. */
export const MAX_GHOSTS = GHOST_BADGES.length;

/** A ghost of a race: its letter, its centre in units and its heading in degrees. */
export interface GhostPose {
  badge: string;
  x: number;
  y: number;
  heading: number;
}
