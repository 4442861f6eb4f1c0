import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { lastTick, poseAt, raceSpeed } from "./race-motion.ts";

const run = {
  poses: new Float32Array([50, 50, 350, 110, 50, 10, 110, 80, 90]),
  ticks: 9,
  isSolved: true,
};

describe("a robot of a race", () => {
  it.each([
    { tick: 0, pose: { x: 50, y: 50, heading: 350 }, says: "starts at its first pose" },
    { tick: 3, pose: { x: 80, y: 50, heading: 0 }, says: "turns the shorter way round" },
    { tick: 6, pose: { x: 110, y: 50, heading: 10 }, says: "is at its second pose after 6 ticks" },
    { tick: 7.5, pose: { x: 110, y: 65, heading: 50 }, says: "has a shorter step at its end" },
    { tick: 9, pose: { x: 110, y: 80, heading: 90 }, says: "reaches its last pose" },
    { tick: 500, pose: { x: 110, y: 80, heading: 90 }, says: "stays at its end" },
    { tick: -1, pose: { x: 50, y: 50, heading: 350 }, says: "waits for the start" },
  ])("$says (tick $tick)", ({ tick, pose }) => {
    expect(poseAt(run, tick)).toEqual(pose);
  });

  it("that never moves has one pose", () => {
    const still = { poses: new Float32Array([50, 50, 0]), ticks: 0, isSolved: false };
    expect(poseAt(still, 10)).toEqual({ x: 50, y: 50, heading: 0 });
  });
});

it("a race of any length is over within 45 seconds", () => {
  fc.assert(
    fc.property(fc.integer({ min: 1, max: 216_000 }), (ticks) => {
      const runs = [{ ...run, ticks }];
      const seconds = lastTick(runs) / 60 / raceSpeed(runs);
      expect(seconds).toBeLessThanOrEqual(45);
      expect(raceSpeed(runs) === 1 || seconds > 22).toBe(true);
    }),
  );
});
