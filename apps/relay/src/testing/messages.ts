/** Messages as a page sends them, for tests. */
import type { Ending } from "@corridor/protocol";

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
