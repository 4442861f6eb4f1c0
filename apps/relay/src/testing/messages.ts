/** Messages as a page sends them, for tests. */
import type { Ending, Snapshot } from "@corridor/protocol";

/** A snapshot of a robot that stands in a corridor. */
export function snapshot(change: Partial<Snapshot> = {}): Snapshot {
  return {
    seq: 1,
    tick: 60,
    state: "running",
    driver: "remote",
    sensors: { front: 250.5, right: 50, back: 49.5, left: 50 },
    pose: { x: 150, y: 150, heading: 90 },
    motion: "stop",
    bumps: 0,
    bumping: false,
    goalReached: false,
    line: null,
    command: null,
    ...change,
  };
}

/** A command that was done as asked. */
export function completed(seq: number): Ending {
  return {
    seq,
    state: "completed",
    reason: null,
    pose: { x: 250, y: 150, heading: 90 },
    distance: 100,
  };
}
