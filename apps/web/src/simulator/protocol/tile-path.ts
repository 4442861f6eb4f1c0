/** The path of a tile, in cells. Pure. */
import { CELL } from "@corridor/maze";
import type { Tile } from "@corridor/protocol";

export interface CellPoint {
  column: number;
  row: number;
}

const steps = {
  n: { column: 0, row: -1 },
  e: { column: 1, row: 0 },
  s: { column: 0, row: 1 },
  w: { column: -1, row: 0 },
} as const;

/**
 * The corners of the path, from its oldest cell to the robot's cell. A path has only the newest
 * moves, so it is followed backwards from the robot.
 */
export function pathCells({ path, pose: [x, y] }: Pick<Tile, "path" | "pose">): CellPoint[] {
  let at: CellPoint = { column: Math.floor(x / CELL), row: Math.floor(y / CELL) };
  const cells = [at];
  for (const [move] of [...path.matchAll(/[news]\d+/g)].toReversed()) {
    const step = steps[move.charAt(0) as keyof typeof steps];
    const count = Number(move.slice(1));
    at = { column: at.column - count * step.column, row: at.row - count * step.row };
    cells.push(at);
  }
  return cells.toReversed();
}
