/**
 * Lists of numbers, the `.num` files of contests: a line `X Y N E S W` for each cell, in any order.
 * A wall is 1, otherwise 0. Cell 0 0 is at the bottom left. A list has no start and no goal.
 */
import type { ReadResult } from "@corridor/protocol";
import { type DrawnMaze, type Drawing, nameOf, Sketch } from "../text-sketch.ts";
import { contestGoals, contestStart, type ContestCell, MAX_CONTEST_SIDE } from "./contest-cells.ts";
import {
  blocksOf,
  cellsOf,
  sides,
  type WallFault,
  wallFaults,
  wallsAt,
  type WallTable,
} from "./wall-table.ts";

const MAX_QUOTED = 40;
const EXPECTED = `X Y N E S W: a cell from 0 to ${MAX_CONTEST_SIDE - 1}, and 1 or 0 for its walls`;

/** Whether a text with this first line is a list of cells. */
export function startsCellList(line: string): boolean {
  return /^\s*\d+(?:\s+\d+){5}\s*$/.test(line);
}

/** @returns the maze, or the problems with their line */
export function readCellList({ lines, firstLine }: Drawing): ReadResult<DrawnMaze> {
  const sketch = new Sketch(firstLine);
  const cells = new Map<string, { line: number; walls: number }>();
  let columns = 0;
  let rows = 0;
  for (const [line, text] of lines.entries()) {
    if (sketch.isFull) break;
    if (text.trim() === "") continue;
    const numbers = startsCellList(text) ? text.trim().split(/\s+/).map(Number) : [];
    const [x = MAX_CONTEST_SIDE, y = 0, ...walls] = numbers;
    if (x >= MAX_CONTEST_SIDE || y >= MAX_CONTEST_SIDE || walls.some((wall) => wall > 1)) {
      sketch.addProblem(line, null, nameOf(text.trim().slice(0, MAX_QUOTED)), EXPECTED);
      continue;
    }
    const first = cells.get(keyOf({ x, y }));
    if (first !== undefined) {
      const expected = `each cell once; it is in line ${first.line + firstLine} already`;
      sketch.addProblem(line, null, `cell ${x} ${y} again`, expected);
      continue;
    }
    const bits = sides.map(({ bit }, at) => (walls[at] === 1 ? bit : 0));
    cells.set(keyOf({ x, y }), { line, walls: bits.reduce((sum, bit) => sum + bit, 0) });
    columns = Math.max(columns, x + 1);
    rows = Math.max(rows, y + 1);
  }
  if (sketch.hasProblems) return sketch.finish([]);
  const table: WallTable = { columns, rows, walls: new Uint8Array(columns * rows) };
  for (const cell of cellsOf(table)) {
    const listed = cells.get(keyOf(cell));
    if (listed === undefined) {
      const found = `no line for cell ${keyOf(cell)}`;
      sketch.addProblem(
        lines.length - 1,
        null,
        found,
        `a line for each of ${columns} x ${rows} cells`,
      );
    } else table.walls[cell.x * rows + cell.y] = listed.walls;
    if (sketch.isFull) break;
  }
  if (!sketch.hasProblems) {
    for (const fault of wallFaults(table)) {
      const { found, expected } = describeFault(fault, keyOf);
      sketch.addProblem(cells.get(keyOf(fault.cell))?.line ?? 0, null, found, expected);
      if (sketch.isFull) break;
    }
  }
  const missing = { start: contestStart(table), goals: contestGoals(table) };
  return sketch.finish(blocksOf(table), missing);
}

/** @param nameOfCell how the file names a cell */
export function describeFault(
  { side, neighbour }: WallFault,
  nameOfCell: (cell: ContestCell) => string,
): { found: string; expected: string } {
  return {
    found: `no wall in the ${side.name}`,
    expected:
      neighbour === null
        ? "the outer wall"
        : `a wall, as cell ${nameOfCell(neighbour)} has on its side`,
  };
}

/** Writes a line for each cell, column by column from the bottom left. */
export function writeCellList(table: WallTable): string {
  let text = "";
  for (const cell of cellsOf(table)) {
    const walls = sides.map(({ bit }) => ((wallsAt(table, cell) & bit) === 0 ? 0 : 1));
    text += `${cell.x} ${cell.y} ${walls.join(" ")}\n`;
  }
  return text;
}

function keyOf({ x, y }: ContestCell): string {
  return `${x} ${y}`;
}
