import type { MazeDocument } from "@corridor/maze";
import { describe, expect, it } from "vitest";
import { touchOf } from "./bumps.ts";
import { recoilDirection, hitSensor, isAtHit, type Hit } from "./hit.ts";

const maze: MazeDocument = {
  format: "corridor/maze",
  version: 1,
  name: "",
  blocks: ["..#", "...", "..."],
  start: { column: 0, row: 0, heading: "east" },
  goals: [],
};
/** At the west side of the block. */
const hit: Hit = { pose: { x: 175, y: 50, heading: 90 }, wanted: 26 };

const allAt = (cm: number) => ({ front: cm, right: cm, back: cm, left: cm });

const seen = (heading: number) => ({
  pose: { ...hit.pose, heading },
  sensors: heading % 90 === 0 ? allAt(25) : allAt(35.4),
});

describe("a displayed bump", () => {
  it.each([
    { name: "stays while the robot stands at it", pose: hit.pose, isShown: true },
    { name: "stays while the robot turns there", pose: { ...hit.pose, heading: 0 }, isShown: true },
    { name: "ends once the robot has driven away", pose: { ...hit.pose, x: 173 }, isShown: false },
  ])("$name", ({ pose, isShown }) => {
    expect(isAtHit(hit, pose)).toBe(isShown);
    expect(isAtHit(null, pose)).toBe(false);
  });

  it.each([
    { heading: 90, sensor: "front" },
    { heading: 0, sensor: "right" },
    { heading: 270, sensor: "back" },
    { heading: 180, sensor: "left" },
    { heading: 45, sensor: null },
  ])(
    "names the sensor that measures the wall: $sensor at heading $heading",
    ({ heading, sensor }) => {
      expect(hitSensor(maze, hit, seen(heading))).toBe(sensor);
    },
  );

  it("names no sensor where the beam misses the corner that was hit", () => {
    // 4 units beside the block, so the beam ahead continues for 225 units.
    const corner: Hit = { pose: { x: 175.3, y: 104, heading: 90 }, wanted: null };
    const sensors = { front: 225, right: 196, back: 175, left: 104 };
    expect(hitSensor(maze, corner, { pose: corner.pose, sensors })).toBeNull();
    expect(touchOf(maze, corner.pose)).toEqual({
      x: 200,
      y: 100,
      cell: { column: 2, row: 0 },
      isCorner: true,
    });
  });

  it("names no sensor where the wall has been removed since", () => {
    expect(hitSensor({ ...maze, blocks: ["...", "...", "..."] }, hit, seen(90))).toBeNull();
  });

  it("recoils away from the wall", () => {
    const { dx, dy } = recoilDirection(maze, hit);
    expect(dx).toBeCloseTo(-1, 6);
    expect(dy).toBeCloseTo(0, 6);
  });
});
