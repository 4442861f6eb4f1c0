import type { MazeDocument } from "@corridor/maze";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { contactOf } from "./contact.ts";
import { ROBOT_RADIUS } from "./settings.ts";
import { Simulation } from "./simulation.ts";

const room = (...blocks: string[]): MazeDocument => ({
  format: "corridor/maze",
  version: 1,
  name: "",
  blocks,
  start: { column: 1, row: 1, heading: "east" },
  goals: [],
});

/** Drives until the first bump. */
function bumped(maze: MazeDocument, degrees: number, action: "forward" | "reverse"): Simulation {
  const simulation = new Simulation(maze);
  simulation.apply({ action: "turn", degrees });
  while (simulation.isManoeuvring) simulation.step();
  simulation.apply({ action });
  while (simulation.bumps === 0) simulation.step();
  return simulation;
}

describe("contactOf", () => {
  it("returns the flat side of the wall ahead", () => {
    const maze = room("#####", "#...#", "#####");
    const { pose } = bumped(maze, 0, "forward");
    const { x, y, cell, isCorner } = contactOf(maze, pose, "front");
    expect({ x, y, cell, isCorner }).toEqual({
      x: 400,
      y: 150,
      cell: { column: 4, row: 1 },
      isCorner: false,
    });
  });

  it("returns the wall behind a robot that drives backward", () => {
    const maze = room("#####", "#...#", "#####");
    const { pose } = bumped(maze, 0, "reverse");
    expect(contactOf(maze, pose, "back")).toMatchObject({ x: 100, isCorner: false });
  });

  it("returns the corner of a block that the sensor ray misses", () => {
    const maze = room("#######", "#.....#", "#.....#", "#..#..#", "#.....#", "#######");
    const simulation = new Simulation(maze);
    for (const command of [
      { action: "turn", degrees: 90 },
      { action: "move", distance: 130 },
      { action: "turn", degrees: -90 },
    ] as const) {
      simulation.apply(command);
      while (simulation.isManoeuvring) simulation.step();
    }
    simulation.apply({ action: "forward" });
    while (simulation.bumps === 0) simulation.step();
    const contact = contactOf(maze, simulation.pose, "front");
    expect(contact).toMatchObject({ x: 300, y: 300, cell: { column: 3, row: 3 }, isCorner: true });
    expect(simulation.readings[0]).toBeGreaterThan(300);
  });

  it.each([
    { name: "meets the touched block, although its corner is touched", x: 300.5, isCorner: false },
    { name: "runs along the side of the touched block", x: 300, isCorner: false },
    { name: "passes beside the touched block", x: 299, isCorner: true },
  ])("returns a corner only where the sensor ray misses it: the ray $name", ({ x, isCorner }) => {
    const maze = room("#####", "##.##", "##.##", "#...#", "#####");
    const corner = { x: 300, y: 300 };
    const y = corner.y + Math.sqrt(ROBOT_RADIUS ** 2 - Math.max(0, corner.x - x) ** 2);
    const contact = contactOf(maze, { x, y, heading: 0 }, "front");
    expect(contact).toMatchObject({ y: 300, cell: { column: 3, row: 2 }, isCorner });
  });

  it("returns no corner where the sensor ray meets the touched block aslant", () => {
    const maze = room("#######", "#.....#", "#.....#", "#..#..#", "#.....#", "#######");
    const pose = { x: 300 - 15, y: 300 - 20, heading: 135 };
    expect(contactOf(maze, pose, "front")).toMatchObject({ x: 300, y: 300, isCorner: false });
    expect(contactOf(maze, { ...pose, heading: 90 }, "front").isCorner).toBe(true);
    expect(contactOf(maze, { ...pose, heading: 270 }, "back").isCorner).toBe(true);
  });

  it("returns a corner only where the sensor reads clearly more than the robot's radius", () => {
    const maze = room("#######", "#.....#", "#.#.#.#", "#..#..#", "#.....#", "#######");
    fc.assert(
      fc.property(
        fc.integer({ min: 0, max: 359 }),
        fc.constantFrom("forward" as const, "reverse" as const),
        (degrees, action) => {
          const { pose, readings } = bumped(maze, degrees, action);
          const reading = readings[action === "forward" ? 0 : 2] ?? 0;
          const { isCorner } = contactOf(maze, pose, action === "forward" ? "front" : "back");
          expect(!isCorner || reading > ROBOT_RADIUS + 1).toBe(true);
        },
      ),
      { numRuns: 200 },
    );
  });

  it("returns a point one radius from the centre, for any heading", () => {
    const maze = room("#######", "#.....#", "#.#.#.#", "#..#..#", "#.....#", "#######");
    fc.assert(
      fc.property(
        fc.integer({ min: 0, max: 359 }),
        fc.constantFrom("forward" as const, "reverse" as const),
        (degrees, action) => {
          const { pose } = bumped(maze, degrees, action);
          const { x, y } = contactOf(maze, pose, action === "forward" ? "front" : "back");
          const distance = Math.sqrt((x - pose.x) ** 2 + (y - pose.y) ** 2);
          expect(Math.abs(distance - ROBOT_RADIUS)).toBeLessThan(0.5);
        },
      ),
      { numRuns: 200 },
    );
  });
});
