import { MAX_RACERS } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { racePlaces } from "./race-places.ts";

describe("the robots of a race", () => {
  const counts = Array.from({ length: MAX_RACERS }, (_, at) => at + 1);

  it.each(counts)("all have their middle in sight where %i of them are in one place", (count) => {
    const places = racePlaces(count);
    expect(places).toHaveLength(count);
    for (const [at, one] of places.entries()) {
      for (const other of places.slice(at + 1)) {
        const apart = Math.hypot(one.x - other.x, one.y - other.y);
        expect(apart).toBeGreaterThan(one.radius);
      }
    }
  });

  it.each(counts)("are about as wide as their cell if there are %i", (count) => {
    for (const { x, y, radius } of racePlaces(count)) {
      expect(Math.hypot(x, y) + radius).toBeLessThan(0.56);
    }
  });
});
