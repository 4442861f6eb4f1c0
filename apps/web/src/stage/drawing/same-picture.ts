/** Whether a frame looks like the one before, so that it need not be drawn. */
import type { Snapshot } from "@corridor/protocol";
import type { Frame } from "./frame.ts";

/** Whether a frame adds nothing to the picture of an earlier one: only time has passed. */
export function isSamePicture(before: Frame, frame: Frame): boolean {
  return (
    !frame.trailReset &&
    frame.corners.length === 0 &&
    frame.bumps.length === 0 &&
    before.view === frame.view &&
    before.marks === frame.marks &&
    isSameSnapshot(before.snapshot, frame.snapshot) &&
    isSame(before.progress, frame.progress) &&
    isSame(before.ghosts, frame.ghosts)
  );
}

/** Whether two snapshots differ at most in their tick and number, which the stage does not draw. */
export function isSameSnapshot(a: Snapshot, b: Snapshot): boolean {
  // The pose first: while the robot moves, it decides without a copy of the snapshot.
  return a === b || (isSame(a.pose, b.pose) && isSame(a, { ...b, tick: a.tick, seq: a.seq }));
}

/** Whether two JSON values are equal. */
function isSame(a: unknown, b: unknown): boolean {
  if (a === b) return true;
  if (typeof a !== "object" || typeof b !== "object" || a === null || b === null) return false;
  const [ofA, ofB] = [Object.entries(a), Object.entries(b)];
  return (
    ofA.length === ofB.length && ofA.every(([key, value]) => isSame(value, Reflect.get(b, key)))
  );
}
