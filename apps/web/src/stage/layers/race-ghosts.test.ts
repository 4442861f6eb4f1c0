import { ROBOT_RADIUS } from "@corridor/simulation";
import { describe, expect, it } from "vitest";
import { BADGE_RADIUS, badgeOffset } from "./race-ghosts.ts";

describe("the badges of ghosts", () => {
  it.each([0.3, 0.6, 1, 2])(
    "at one position and scale %d cover neither the robot nor each other",
    (scale) => {
      const places = ["A", "B", "C", "D"].map((badge) => badgeOffset(badge, scale));
      for (const [at, { x, y }] of places.entries()) {
        expect(Math.hypot(x, y)).toBeCloseTo(ROBOT_RADIUS * scale + BADGE_RADIUS, 9);
        for (const other of places.slice(at + 1)) {
          expect(Math.hypot(x - other.x, y - other.y)).toBeGreaterThan(2 * BADGE_RADIUS);
        }
      }
    },
  );
});
