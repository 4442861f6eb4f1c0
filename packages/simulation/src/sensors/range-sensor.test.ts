import { CELL, gridOf, type MazeDocument } from "@corridor/maze";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { anyMaze } from "../testing/mazes.ts";
import { writeRange } from "./range-sensor.ts";

/** Reference implementation: the nearest of all solid cells. */
function bruteForce(maze: MazeDocument, x: number, y: number, dx: number, dy: number): number {
  let nearest = Number.POSITIVE_INFINITY;
  for (let row = -1; row <= maze.blocks.length; row++) {
    for (let column = -1; column <= (maze.blocks[0]?.length ?? 0); column++) {
      if ((maze.blocks[row]?.[column] ?? "#") !== "#") continue;
      nearest = Math.min(
        nearest,
        entry([column * CELL, row * CELL], [x, y], [dx, dy]) ?? Number.POSITIVE_INFINITY,
      );
    }
  }
  return nearest;
}

/** Distance at which a ray enters a cell, by the slab method; undefined if it misses. */
function entry(corner: number[], from: number[], direction: number[]): number | undefined {
  let near = Number.NEGATIVE_INFINITY;
  let far = Number.POSITIVE_INFINITY;
  for (const axis of [0, 1]) {
    const low = (corner[axis] ?? 0) - (from[axis] ?? 0);
    const speed = direction[axis] ?? 0;
    if (speed === 0) {
      if (low > 0 || low + CELL <= 0) return undefined;
      continue;
    }
    const [a, b] = [low / speed, (low + CELL) / speed];
    near = Math.max(near, Math.min(a, b));
    far = Math.min(far, Math.max(a, b));
  }
  return near <= far && near >= 0 ? near : undefined;
}

describe("writeRange", () => {
  const anyHeading = fc.oneof(
    fc.constantFrom(0, 90, 180, 270),
    fc.double({ min: 0, max: 359.99, noNaN: true }),
  );
  const inCell = fc.double({ min: 25, max: 75, noNaN: true });

  it("finds the same wall as a search over all blocks, from any position in any direction", () => {
    fc.assert(
      fc.property(anyMaze, anyHeading, inCell, inCell, (maze, degrees, offsetX, offsetY) => {
        const x = maze.start.column * CELL + offsetX;
        const y = maze.start.row * CELL + offsetY;
        const radians = (degrees * Math.PI) / 180;
        const isQuarter = degrees % 90 === 0;
        const dx = isQuarter ? [0, 1, 0, -1][degrees / 90] : Math.sin(radians);
        const dy = isQuarter ? [-1, 0, 1, 0][degrees / 90] : -Math.cos(radians);
        const out = new Float64Array(1);
        writeRange(gridOf(maze), x, y, dx ?? 0, dy ?? 0, out, 0);
        expect(out[0]).toBeCloseTo(bruteForce(maze, x, y, dx ?? 0, dy ?? 0), 6);
      }),
      { numRuns: 1000 },
    );
  });
});
