import { ROBOT_RADIUS } from "@corridor/simulation";
import { describe, expect, it } from "vitest";
import { GHOST_BADGES } from "../drawing/frame.ts";
import { BADGE_RADIUS, badgeOffset } from "./race-ghosts.ts";

describe("the badges of ghosts", () => {
  it.each([0.1, 0.3, 0.6, 1, 2])(
    "at one position and scale %d cover neither the robot nor each other",
    (scale) => {
      const places = GHOST_BADGES.map((badge) => badgeOffset(badge, scale));
      for (const [at, { x, y }] of places.entries()) {
        expect(Math.hypot(x, y)).toBeGreaterThan(ROBOT_RADIUS * scale + BADGE_RADIUS - 1e-9);
        for (const other of places.slice(at + 1)) {
          expect(Math.hypot(x - other.x, y - other.y)).toBeGreaterThan(2 * BADGE_RADIUS);
        }
      }
    },
  );

  it("touch a robot that has room for them, if they are one of the first four", () => {
    for (const badge of GHOST_BADGES.slice(0, 4)) {
      const { x, y } = badgeOffset(badge, 1);
      expect(Math.hypot(x, y)).toBeCloseTo(ROBOT_RADIUS + BADGE_RADIUS, 9);
    }
  });
});
