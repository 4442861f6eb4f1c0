import type { MazeDocument } from "@corridor/maze";
import { snapshotOf } from "@corridor/protocol/testing";
import { sensorNames, type Pose, type SensorName } from "@corridor/protocol";
import { Simulation } from "@corridor/simulation";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { beamDirection } from "../layers/beams.ts";
import { hitSensor } from "../layers/hit.ts";
import { contactSensor } from "./contact-sensor.ts";

const maze: MazeDocument = {
  format: "corridor/maze",
  version: 1,
  name: "",
  blocks: [".......", ".......", "..#.#..", "...#...", "......."],
  start: { column: 1, row: 1, heading: "east" },
  goals: [],
};

type Move = "forward" | "reverse";

/** Drives these moves until the robot bumps at the end. */
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

/**
 * The nearest point of each block and of each outer wall that touches the robot, or almost does.
 */
function touchedPoints({ x, y }: Pose): { x: number; y: number }[] {
  const [width, height] = [700, 500];
  const blocks = maze.blocks.flatMap((line, row) =>
    Array.from(line, (square, column) => ({ square, column })).flatMap(({ square, column }) =>
      square === "#"
        ? [
            {
              x: Math.max(column * 100, Math.min(x, column * 100 + 100)),
              y: Math.max(row * 100, Math.min(y, row * 100 + 100)),
            },
          ]
        : [],
    ),
  );
  const walls = [
    { x: 0, y },
    { x: width, y },
    { x, y: 0 },
    { x, y: height },
  ];
  return [...blocks, ...walls].filter((at) => Math.hypot(at.x - x, at.y - y) <= 25.5);
}

describe("the sensor that measures the contact", () => {
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
    expect(contactSensor(snapshot)).toBe(sensor);
  });

  it("is null while the robot touches nothing, and before the first snapshot", () => {
    expect(contactSensor({ ...bumped([], "forward"), bumping: false })).toBeNull();
    expect(contactSensor(null)).toBeNull();
  });

  it("has a beam that ends at a contact point, the same as on the stage", () => {
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
          const touched = touchedPoints(pose);
          const red = contactSensor(snapshot);
          const apart = (sensor: SensorName): number => {
            const { dx, dy } = beamDirection(sensor, pose.heading);
            const end = { x: pose.x + dx * sensors[sensor], y: pose.y + dy * sensors[sensor] };
            return Math.min(...touched.map(({ x, y }) => Math.hypot(x - end.x, y - end.y)));
          };
          // Between the two limits a beam ends near a contact point, and either result is right.
          const missed = red === null ? sensorNames.filter((each) => apart(each) < 0.3) : [];
          expect(missed).toEqual([]);
          expect(red === null ? 0 : apart(red)).toBeLessThan(8);
          fc.pre(touched.length === 1);
          expect(hitSensor(maze, { pose, wanted: null }, snapshot)).toBe(red);
        },
      ),
      { numRuns: 500 },
    );
  });
});
