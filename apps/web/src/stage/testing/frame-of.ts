/** A frame for tests: the newest state of a robot at its start, with changes. */
import { snapshotOf } from "@corridor/protocol/testing";
import type { Frame } from "../drawing/frame.ts";

export function frameOf(changes: Partial<Frame> = {}): Frame {
  const snapshot = changes.snapshot ?? snapshotOf();
  return {
    snapshot,
    hasEnded: false,
    progress: null,
    view: "now",
    nowTick: snapshot.tick,
    waited: 0,
    nowDriver: snapshot.driver,
    revision: 0,
    startedAt: 0,
    corners: [],
    bumps: [],
    trailReset: false,
    ...changes,
  };
}
