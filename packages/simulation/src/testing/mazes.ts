/** Mazes and commands for tests: hand-written ones, and generators for property tests. */
import { CELL, type MazeDocument, type Start } from "@corridor/maze";
import type { Command } from "@corridor/protocol";
import fc from "fast-check";
import { ROBOT_RADIUS } from "../settings.ts";

/** Creates a maze from its rows. The default start is cell (1, 1), heading east. */
export function mazeOf(
  blocks: string[],
  start: Partial<Start> = {},
  goals: MazeDocument["goals"] = [],
): MazeDocument {
  return {
    format: "corridor/maze",
    version: 1,
    name: "test",
    blocks,
    start: { column: 1, row: 1, heading: "east", ...start },
    goals,
  };
}

/**
 * Overlap of the robot's disc with the nearest block, in units. Negative if they do not overlap.
 */
export function overlap(maze: MazeDocument, x: number, y: number): number {
  let deepest = Number.NEGATIVE_INFINITY;
  for (let row = -1; row <= maze.blocks.length; row++) {
    for (let column = -1; column <= (maze.blocks[0]?.length ?? 0); column++) {
      if ((maze.blocks[row]?.[column] ?? "#") !== "#") continue;
      const dx = Math.max(column * CELL - x, 0, x - (column + 1) * CELL);
      const dy = Math.max(row * CELL - y, 0, y - (row + 1) * CELL);
      deepest = Math.max(deepest, ROBOT_RADIUS - Math.hypot(dx, dy));
    }
  }
  return deepest;
}

/** Generates mazes of up to 7 x 7 cells, about a third of them blocks. */
export const anyMaze: fc.Arbitrary<MazeDocument> = fc
  .record({
    columns: fc.integer({ min: 1, max: 7 }),
    rows: fc.integer({ min: 1, max: 7 }),
    fill: fc.array(fc.integer({ min: 0, max: 2 }), { minLength: 49, maxLength: 49 }),
    at: fc.nat(),
    heading: fc.constantFrom("north", "east", "south", "west"),
  })
  .map(({ columns, rows, fill, at, heading }) => {
    const column = at % columns;
    const row = Math.floor(at / columns) % rows;
    const blocks = Array.from({ length: rows }, (_, r) =>
      Array.from({ length: columns }, (_unused, c) =>
        fill[r * 7 + c] === 0 && !(c === column && r === row) ? "#" : ".",
      ).join(""),
    );
    return mazeOf(blocks, { column, row, heading });
  });

const power = fc.double({ min: -1, max: 1, noNaN: true });

/** Generates commands of the protocol. */
export const anyCommand: fc.Arbitrary<Command> = fc.oneof(
  fc.constantFrom<Command>(
    { action: "forward" },
    { action: "reverse" },
    { action: "stop" },
    { action: "left 90" },
    { action: "right 90" },
    { action: "turn 180" },
    { action: "delayed left 90" },
    { action: "delayed right 90" },
  ),
  fc.record({
    action: fc.constant("move" as const),
    distance: fc.double({ min: -300, max: 300, noNaN: true }),
  }),
  fc.record({
    action: fc.constant("turn" as const),
    degrees: fc.double({ min: -200, max: 200, noNaN: true }),
  }),
  fc.record({ action: fc.constant("drive" as const), left: power, right: power }),
);
