import { CELL, gridOf, type MazeDocument } from "@corridor/maze";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { ROBOT_RADIUS, TICK_SECONDS, WHEEL_SPEED } from "../settings.ts";
import { anyMaze, mazeOf, overlap } from "../testing/mazes.ts";
import { PhysicsWorld } from "./physics-world.ts";

/** The body is a polygon around the disc, which touches the corner of a block this much early. */
const EARLY = 0.05;
/**
 * A robot that passes a corner at full speed is at most this deep in its block, or moved back this
 * much too far. 40,000 random runs reached 0.32 and 0.45 units.
 */
const DEEPEST = 0.6;
const TOO_FAR_BACK = 0.9;
/** The longest step of the robot in one tick: both wheels at full power. */
const LONGEST_STEP = WHEEL_SPEED * TICK_SECONDS;

function startOf({ start }: MazeDocument): readonly [number, number] {
  return [start.column * CELL + CELL / 2, start.row * CELL + CELL / 2];
}

function worldOf(maze: MazeDocument): PhysicsWorld {
  return new PhysicsWorld(gridOf(maze), ...startOf(maze));
}

const anyStep = fc
  .record({
    degrees: fc.integer({ min: 0, max: 359 }),
    percent: fc.integer({ min: 1, max: 100 }),
  })
  .map(({ degrees, percent }) => {
    const length = (percent / 100) * LONGEST_STEP;
    const angle = (degrees * Math.PI) / 180;
    return { dx: Math.sin(angle) * length, dy: -Math.cos(angle) * length };
  });
/** Steps in one direction are frequent: only they reach a wall, and push against it. */
const anySteps = fc
  .array(fc.tuple(anyStep, fc.integer({ min: 1, max: 40 })), { maxLength: 8 })
  .map((parts) => parts.flatMap(([step, times]) => Array.from({ length: times }, () => step)));

/** Whether a robot with this overlap is in a block. Both is right for one that only touches it. */
function isIn(depth: number, otherwise: boolean): boolean {
  return depth > DEEPEST || (depth >= -EARLY && otherwise);
}

/** The hall of one cell: the robot reaches each wall after 25 units. */
const cell = mazeOf(["###", "#.#", "###"]);

describe("a robot that moves in any maze", () => {
  it("arrives where nothing is in its way, and is stopped exactly where a block is", () => {
    let stops = 0;
    fc.assert(
      fc.property(anyMaze, anySteps, (maze, steps) => {
        const world = worldOf(maze);
        for (const { dx, dy } of steps) {
          const { x, y } = world;
          const isStopped = world.move(dx, dy);
          if (isStopped) stops++;
          expect(isStopped).toBe(isIn(overlap(maze, x + dx, y + dy), isStopped));
          expect(world.inContact).toBe(isStopped);
          const end = overlap(maze, world.x, world.y);
          expect(end).toBeLessThan(DEEPEST);
          expect(end > -TOO_FAR_BACK || !isStopped).toBe(true);
          const missing = Math.hypot(x + dx - world.x, y + dy - world.y);
          expect(isStopped || missing < 1e-9).toBe(true);
        }
      }),
      { numRuns: 300 },
    );
    expect(stops).toBeGreaterThan(0);
  });

  it("never leaves the straight line of its step, and never slides along a wall", () => {
    fc.assert(
      fc.property(anyMaze, anySteps, (maze, steps) => {
        const world = worldOf(maze);
        for (const { dx, dy } of steps) {
          const { x, y } = world;
          world.move(dx, dy);
          const length = Math.hypot(dx, dy);
          const along = ((world.x - x) * dx + (world.y - y) * dy) / length;
          const beside = ((world.x - x) * dy - (world.y - y) * dx) / length;
          expect(Math.abs(beside)).toBeLessThan(1e-9);
          expect(along).toBeGreaterThanOrEqual(-1e-9);
          expect(along).toBeLessThanOrEqual(length + 1e-9);
        }
      }),
    );
  });

  it("has bumped as often as it touched a wall that it did not touch before", () => {
    fc.assert(
      fc.property(anyMaze, anySteps, (maze, steps) => {
        const world = worldOf(maze);
        for (const { dx, dy } of steps) {
          const before = { isTouching: world.inContact, bumps: world.bumps };
          const isStopped = world.move(dx, dy);
          const least = isStopped && !before.isTouching ? 1 : 0;
          // In a corner the robot may touch the other wall next.
          const most = isStopped ? 1 : 0;
          expect(world.bumps - before.bumps).toBeGreaterThanOrEqual(least);
          expect(world.bumps - before.bumps).toBeLessThanOrEqual(most);
        }
      }),
    );
  });

  it("is as new when it is placed, whatever it did before", () => {
    fc.assert(
      fc.property(anyMaze, anySteps, (maze, steps) => {
        const world = worldOf(maze);
        for (const { dx, dy } of steps) world.move(dx, dy);
        world.place(...startOf(maze));
        expect(world.save()).toEqual(worldOf(maze).save());
      }),
    );
  });

  it("continues bit for bit from a saved state", () => {
    fc.assert(
      fc.property(anyMaze, anySteps, anySteps, (maze, before, after) => {
        const world = worldOf(maze);
        for (const { dx, dy } of before) world.move(dx, dy);
        const other = worldOf(maze);
        other.restore(world.save(), gridOf(maze));
        for (const { dx, dy } of after) expect(other.move(dx, dy)).toBe(world.move(dx, dy));
        expect(other.save()).toEqual(world.save());
      }),
    );
  });
});

describe("a robot at a wall", () => {
  it.each([
    { name: "north", dx: 0, dy: -1, x: 150, y: 125 },
    { name: "east", dx: 1, dy: 0, x: 175, y: 150 },
    { name: "south", dx: 0, dy: 1, x: 150, y: 175 },
    { name: "west", dx: -1, dy: 0, x: 125, y: 150 },
  ])("in the $name is stopped one radius from it, and bumps once", ({ dx, dy, x, y }) => {
    const world = worldOf(cell);
    for (let n = 0; n < 100; n++) expect(world.move(dx, dy)).toBe(n >= CELL / 2 - ROBOT_RADIUS);
    expect([world.x, world.y]).toEqual([expect.closeTo(x, 6), expect.closeTo(y, 6)]);
    expect(world.bumps).toBe(1);
  });

  it("drives along it freely, and away from it, and bumps when it comes back", () => {
    const world = worldOf(cell);
    world.move(0, 30);
    expect(world.bumps).toBe(1);
    for (let n = 0; n < 10; n++) expect(world.move(1, 0)).toBe(false);
    expect([world.inContact, world.bumps]).toEqual([false, 1]);
    expect(world.move(0, -5)).toBe(false);
    expect(world.move(0, 30)).toBe(true);
    expect(world.bumps).toBe(2);
  });

  it("bumps again at the other wall of a corner, but not when it pushes on there", () => {
    const world = worldOf(cell);
    world.move(30, 0);
    world.move(0, 30);
    expect(world.bumps).toBe(2);
    for (let n = 0; n < 5; n++) world.move(0, 30);
    expect(world.bumps).toBe(2);
    expect([world.x, world.y]).toEqual([expect.closeTo(175, 6), expect.closeTo(175, 6)]);
  });

  it("is stopped by the border of the maze as by a block", () => {
    const world = worldOf(mazeOf(["."], { column: 0, row: 0 }));
    for (const [dx, dy] of [
      [30, 0],
      [0, 30],
      [-30, 0],
      [0, -30],
    ] as const) {
      for (let n = 0; n < 3; n++) world.move(dx, dy);
    }
    expect([world.x, world.y]).toEqual([expect.closeTo(25, 6), expect.closeTo(25, 6)]);
    expect(world.bumps).toBe(4);
  });
});

describe("another grid", () => {
  it("is accepted exactly if the robot stands free in it, and otherwise changes nothing", () => {
    const refused = { count: 0 };
    fc.assert(
      fc.property(anyMaze, anySteps, anyMaze, anySteps, (maze, before, other, after) => {
        const world = worldOf(maze);
        for (const { dx, dy } of before) world.move(dx, dy);
        const { columns, rows } = gridOf(other);
        const isInside = world.x < columns * CELL && world.y < rows * CELL;
        const depth = isInside ? overlap(other, world.x, world.y) : ROBOT_RADIUS;
        const saved = world.save();
        const isAccepted = world.setGrid(gridOf(other));
        expect(world.save()).toEqual(saved);
        expect(!isAccepted).toBe(isIn(depth, !isAccepted));
        if (!isAccepted) refused.count++;
        const same = worldOf(maze);
        same.restore(saved, gridOf(isAccepted ? other : maze));
        for (const { dx, dy } of after) expect(world.move(dx, dy)).toBe(same.move(dx, dy));
        expect(world.save()).toEqual(same.save());
      }),
    );
    expect(refused.count).toBeGreaterThan(0);
  });
});
