/**
 * Bounds of all sensor readings in a maze, for any heading of the robot.
 *
 * A program turns by quarters, but a student or a script may have turned the robot by any angle
 * before, and then the beams are diagonal. So the upper bound is the longest straight line of any
 * slope through the open cells that are connected with the start. It is exact to the part of a cell
 * at each end.
 *
 * Consider a line to the right and down, by at most one row per column. Let K be the number of
 * columns per row, rounded up. The line crosses each inner row within K or K + 1 cells, and touches
 * at most K + 1 cells of the first and the last row. Consecutive rows share the column of the
 * crossing. For each K, one pass from the bottom finds the longest chain of such runs. Mirroring
 * and transposing the maze covers the other slopes.
 */
import { CELL, distancesFromStart, sizeOf, UNREACHABLE, type MazeDocument } from "@corridor/maze";
import type { ReadingRange } from "./reaching-readings.ts";

/**
 * Lower bound of readings: the radius of the robot is 25. At corners the physics permits an overlap
 * of some hundredths of a unit, and at walls there are rounding errors. Half a unit covers both.
 */
const NEAREST = 24.5;

/** Maximum number of visited cells; mazes that need more get a looser bound. */
const MAX_WORK = 1_000_000;

export interface MazeVisibility {
  /** all readings that the robot can have, in units */
  range: ReadingRange;
  /** whether there is an outer corner, so that a corridor opens to a side somewhere */
  hasOpenings: boolean;
}

const cache = new WeakMap<MazeDocument, MazeVisibility>();

/** The visibility from the cells that are connected with the start; cached per document. */
export function visibilityIn(maze: MazeDocument): MazeVisibility {
  const cached = cache.get(maze);
  if (cached !== undefined) return cached;
  const cells = reachableCells(maze);
  // The opposite beam lies on the same line and is at least as long as the radius.
  const max = longestLine(cells) * CELL - NEAREST;
  const visibility = { range: { min: NEAREST, max }, hasOpenings: hasOuterCorner(cells) };
  cache.set(maze, visibility);
  return visibility;
}

/** Cells by rows: 1 if reachable, else 0. */
interface Cells {
  columns: number;
  rows: number;
  isOpen: Uint8Array;
}

function reachableCells(maze: MazeDocument): Cells {
  const isOpen = Uint8Array.from(distancesFromStart(maze), (steps) =>
    steps === UNREACHABLE ? 0 : 1,
  );
  return { ...sizeOf(maze), isOpen };
}

/** Whether three of four cells around a point are open. */
function hasOuterCorner({ columns, rows, isOpen }: Cells): boolean {
  for (let row = 1; row < rows; row++) {
    for (let at = row * columns + 1; at < (row + 1) * columns; at++) {
      const open = [at, at - 1, at - columns, at - columns - 1].filter(
        (cell) => isOpen[cell] === 1,
      );
      if (open.length === 3) return true;
    }
  }
  return false;
}

/** Upper bound of the longest straight line through open cells, in sides of a cell. */
function longestLine(cells: Cells): number {
  const turned = transposed(cells);
  const runs = [longestRun(cells), longestRun(turned)];
  const work = ((runs[0] ?? 0) + (runs[1] ?? 0)) * cells.isOpen.length;
  if (work > MAX_WORK) return diagonalOfBox(cells);
  const views = [cells, upsideDown(cells), turned, upsideDown(turned)];
  return Math.sqrt(Math.max(...views.map((view) => longestFall(view))));
}

/** Square of the longest line to the right and down, by at most one row per column. */
function longestFall(cells: Cells): number {
  const steepest = longestRun(cells);
  const toRight = runsToRight(cells);
  let longest = 0;
  for (let run = 1; run <= steepest; run++) {
    longest = Math.max(longest, longestChain(cells, toRight, run));
  }
  return longest;
}

/** The same for lines with `run` columns per row, rounded up. */
function longestChain(
  { columns, rows }: Cells,
  toRight: Readonly<Int32Array>,
  run: number,
): number {
  // Columns and rows of the longest chain that enters a row from above, by its first column, for
  // the row below and for this one. Both are 0 at blocks.
  let wide = new Int32Array(columns);
  let high = new Int32Array(columns);
  let ownWide = new Int32Array(columns);
  let ownHigh = new Int32Array(columns);
  let longest = 0;
  for (let row = rows - 1; row >= 0; row--) {
    let toLeft = 0;
    for (let column = 0; column < columns; column++) {
      const free = toRight[row * columns + column] ?? 0;
      toLeft = free === 0 ? 0 : toLeft + 1;
      let maxWide = Math.min(free, run + 1);
      let maxHigh = free === 0 ? 0 : 1;
      // The line crosses this row within `run` or `run` + 1 cells, and continues in the next.
      for (let length = run; length <= run + 1 && length <= free; length++) {
        const crossing = column + length - 1;
        const below = high[crossing] ?? 0;
        if (below === 0) continue;
        maxWide = Math.max(maxWide, length - 1 + (wide[crossing] ?? 0));
        maxHigh = Math.max(maxHigh, 1 + below);
      }
      ownWide[column] = maxWide;
      ownHigh[column] = maxHigh;
      if (free === 0) continue;
      // The line starts in this row, to the left, and enters the next row here.
      const across = Math.min(toLeft, run + 1) - 1 + Math.max(1, wide[column] ?? 0);
      const down = 1 + (high[column] ?? 0);
      const starting = across * across + down * down;
      const whole = maxWide * maxWide + maxHigh * maxHigh;
      longest = Math.max(longest, starting, whole);
    }
    [wide, ownWide] = [ownWide, wide];
    [high, ownHigh] = [ownHigh, high];
  }
  return longest;
}

/** Number of consecutive open cells to the right of each cell, including itself. */
function runsToRight({ columns, isOpen }: Cells): Int32Array {
  const runs = new Int32Array(isOpen.length);
  for (let at = isOpen.length - 1; at >= 0; at--) {
    const next = (at + 1) % columns === 0 ? 0 : (runs[at + 1] ?? 0);
    runs[at] = isOpen[at] === 1 ? next + 1 : 0;
  }
  return runs;
}

function longestRun(cells: Cells): number {
  return runsToRight(cells).reduce((longest, run) => Math.max(longest, run), 0);
}

/** Diagonal of the box around all open cells. */
function diagonalOfBox({ columns, isOpen }: Cells): number {
  let [left, right, top, bottom] = [Infinity, -Infinity, Infinity, -Infinity];
  for (const [at, open] of isOpen.entries()) {
    if (open === 0) continue;
    const column = at % columns;
    const row = (at - column) / columns;
    left = Math.min(left, column);
    right = Math.max(right, column);
    top = Math.min(top, row);
    bottom = Math.max(bottom, row);
  }
  const across = right - left + 1;
  const down = bottom - top + 1;
  return Math.sqrt(across * across + down * down);
}

function transposed({ columns, rows, isOpen }: Cells): Cells {
  const turned = new Uint8Array(isOpen.length);
  for (const [at, open] of isOpen.entries()) {
    turned[(at % columns) * rows + Math.floor(at / columns)] = open;
  }
  return { columns: rows, rows: columns, isOpen: turned };
}

function upsideDown({ columns, rows, isOpen }: Cells): Cells {
  const mirrored = new Uint8Array(isOpen.length);
  for (let row = 0; row < rows; row++) {
    mirrored.set(isOpen.subarray(row * columns, (row + 1) * columns), (rows - 1 - row) * columns);
  }
  return { columns, rows, isOpen: mirrored };
}
