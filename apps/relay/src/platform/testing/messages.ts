/** Messages of a page, for tests. */
import type { Ending } from "@corridor/protocol";

/** The ending of a completed command. */
export function completed(seq: number): Ending {
  return {
    seq,
    state: "completed",
    reason: null,
    pose: { x: 250, y: 150, heading: 90 },
    distance: 100,
  };
}
