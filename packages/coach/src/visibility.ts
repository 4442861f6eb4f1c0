/**
 * How far the robot can see in a maze: bounds that no reading ever breaks, whoever turned the robot.
 *
 * A program turns by quarters, but a hand or a script may have turned the robot askew before it began,
 * and then beams run diagonally. So the upper bound is that of the longest straight line of any slope
 * through the open cells that the start is connected with; only cells count, and the result may be
 * longer than the longest line by the part of a cell at each end.
 *
 * A line that goes right and down, at most one row for each column, crosses each row that it does not
 * begin or end in within K or K + 1 cells, K being the columns that it takes for a row, rounded up; in
 * the first and the last row it touches at most K + 1. Rows that follow each other share the column of
 * the crossing. For each K one pass from the bottom finds how far such a chain of runs can go. The
 * maze mirrored and with rows and columns exchanged gives the other slopes.
 */
import { CELL, distancesFromStart, sizeOf, UNREACHABLE, type MazeDocument } from "@corridor/maze";
import type { ReadingRange } from "./reaching-readings.ts";

/**
 * No reading is below: a beam from the middle of a disc of radius 25 is at least 25 long. At corners
 * that are passed askew the physics lets the disc in by some hundredths of a unit, and at a wall it is
 * off by rounding; half a unit is room for both, and no line asks about less.
 */
const NEAREST = 24.5;

/** Cells looked at before a looser bound has to do: large mazes with long corridors. */
const MOST_WORK = 1_000_000;

export interface MazeSight {
  /** all readings that the robot can have, in units */
  range: ReadingRange;
  /** whether a corridor opens to a side somewhere: an outer corner that the robot can drive past */
  hasOpenings: boolean;
}

const known = new WeakMap<MazeDocument, MazeSight>();

/** What can be seen from the cells that the start is connected with. Remembered for each document. */
export function sightIn(maze: MazeDocument): MazeSight {
  const before = known.get(maze);
  if (before !== undefined) return before;
  const cells = reachableCells(maze);
  // The beam to the other side is at least as long as the radius, and the two lie on one line.
  const max = longestLine(cells) * CELL - NEAREST;
  const sight = { range: { min: NEAREST, max }, hasOpenings: hasOuterCorner(cells) };
  known.set(maze, sight);
  return sight;
}

/** Cells as rows of 0 and 1, 1 where the robot can get. */
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

/** Three open cells around a point and one that is not. */
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
  if (work > MOST_WORK) return diagonalOfBox(cells);
  const views = [cells, upsideDown(cells), turned, upsideDown(turned)];
  return Math.sqrt(Math.max(...views.map((view) => longestFall(view))));
}

/** Square of the longest line that goes right and down, at most a row for each column. */
function longestFall(cells: Cells): number {
  const steepest = longestRun(cells);
  const toRight = runsToRight(cells);
  let longest = 0;
  for (let run = 1; run <= steepest; run++) {
    longest = Math.max(longest, longestChain(cells, toRight, run));
  }
  return longest;
}

/** The same for lines that take `run` columns for a row, rounded up. */
function longestChain(
  { columns, rows }: Cells,
  toRight: Readonly<Int32Array>,
  run: number,
): number {
  // Columns and rows of the longest chain that enters a row from above, by its first column: of the
  // row below, and of this one. Both are 0 where a block is.
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
      let mostWide = Math.min(free, run + 1);
      let mostHigh = free === 0 ? 0 : 1;
      // The line crosses this row within `run` cells or one more, and falls into the next.
      for (let length = run; length <= run + 1 && length <= free; length++) {
        const crossing = column + length - 1;
        const below = high[crossing] ?? 0;
        if (below === 0) continue;
        mostWide = Math.max(mostWide, length - 1 + (wide[crossing] ?? 0));
        mostHigh = Math.max(mostHigh, 1 + below);
      }
      ownWide[column] = mostWide;
      ownHigh[column] = mostHigh;
      if (free === 0) continue;
      // The line begins in this row, somewhere to the left, and falls into the next one here.
      const across = Math.min(toLeft, run + 1) - 1 + Math.max(1, wide[column] ?? 0);
      const down = 1 + (high[column] ?? 0);
      const began = across * across + down * down;
      const whole = mostWide * mostWide + mostHigh * mostHigh;
      longest = Math.max(longest, began, whole);
    }
    [wide, ownWide] = [ownWide, wide];
    [high, ownHigh] = [ownHigh, high];
  }
  return longest;
}

/** Open cells in a row from each cell to the right, itself included. */
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
