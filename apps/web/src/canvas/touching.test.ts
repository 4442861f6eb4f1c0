import type { MazeDocument } from "@corridor/maze";
import { snapshotOf } from "@corridor/protocol/testing";
import { sensorNames } from "@corridor/protocol";
import { Simulation } from "@corridor/simulation";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { beamDirection } from "./layers/beams.ts";
import { touchOf } from "./layers/bumps.ts";
import { hitSensor } from "./layers/hit.ts";
import { touchingSensor } from "./touching.ts";

const maze: MazeDocument = {
  format: "corridor/maze",
  version: 1,
  name: "",
  blocks: [".......", ".......", "..#.#..", "...#...", "......."],
  start: { column: 1, row: 1, heading: "east" },
  goals: [],
};

type Move = "forward" | "reverse";

/** Drives as told until the robot bumps at the end. */
function bumped(moves: readonly (readonly [degrees: number, distance: number])[], last: Move) {
  const simulation = new Simulation(maze);
  for (const [degrees, distance] of moves) {
    for (const command of [
      { action: "turn", degrees },
      { action: "move", distance },
    ] as const) {
      simulation.apply(command);
      while (simulation.isManoeuvring) simulation.step();
    }
  }
  const before = simulation.bumps;
  simulation.apply({ action: last });
  for (let tick = 0; tick < 1200 && simulation.bumps === before; tick++) simulation.step();
  const [front = 0, right = 0, back = 0, left = 0] = simulation.readings;
  const pose = { ...simulation.pose };
  return snapshotOf({
    pose,
    sensors: { front, right, back, left },
    motion: last,
    bumping: simulation.bumps > before,
  });
}

describe("the sensor that touches", () => {
  it.each([
    { name: "the wall ahead", moves: [[0, 0]], last: "forward", sensor: "front" },
    { name: "the wall behind", moves: [[0, 0]], last: "reverse", sensor: "back" },
    { name: "a wall at a slant", moves: [[-45, 0]], last: "forward", sensor: null },
    {
      name: "a wall almost at its side",
      moves: [
        [180, 110],
        [-82, 0],
      ],
      last: "forward",
      sensor: "right",
    },
    {
      name: "a wall after driving along another",
      moves: [
        [-90, 200],
        [90, 0],
      ],
      last: "forward",
      sensor: "front",
    },
    {
      name: "a corner that its beam passes",
      moves: [
        [90, 35],
        [-90, 0],
      ],
      last: "forward",
      sensor: null,
    },
  ] as const)("is $sensor at $name", ({ moves, last, sensor }) => {
    const snapshot = bumped(moves, last);
    expect(snapshot.bumping).toBe(true);
    expect(touchingSensor(snapshot)).toBe(sensor);
  });

  it("is none while nothing is touched, and before the first snapshot", () => {
    expect(touchingSensor({ ...bumped([], "forward"), bumping: false })).toBeNull();
    expect(touchingSensor(null)).toBeNull();
  });

  it("is the one whose beam ends at the touched point, the same as on the stage", () => {
    const turn = fc.oneof(fc.constantFrom(-90, 0, 90), fc.integer({ min: -180, max: 180 }));
    const move = fc.tuple(turn, fc.integer({ min: -250, max: 250 }));
    fc.assert(
      fc.property(
        fc.array(move, { minLength: 1, maxLength: 4 }),
        fc.constantFrom<Move>("forward", "reverse"),
        (moves, last) => {
          const snapshot = bumped(moves, last);
          fc.pre(snapshot.bumping);
          const { pose, sensors } = snapshot;
          const touched = touchOf(maze, pose);
          const ends = sensorNames.map((sensor) => {
            const { dx, dy } = beamDirection(sensor, pose.heading);
            const length = sensors[sensor];
            return {
              sensor,
              apart: Math.hypot(
                pose.x + dx * length - (touched?.x ?? 0),
                pose.y + dy * length - (touched?.y ?? 0),
              ),
            };
          });
          const red = touchingSensor(snapshot);
          for (const { sensor, apart } of ends) {
            // Between the two a beam ends near the touched point, and either is right.
            const isNear = apart < (sensor === red ? 8 : 0.4);
            expect(isNear).toBe(sensor === red);
          }
          expect(hitSensor(maze, { pose, wanted: null }, snapshot)).toBe(red);
        },
      ),
      { numRuns: 500 },
    );
  });
});
