/**
 * Binary files of contests, `.maz`: one byte for each of 16 x 16 cells, column by column from the
 * bottom left, with the bits of `sides` for the walls. Programs ignore the upper four bits. A binary
 * file has no start and no goal.
 */
import type { FieldProblem, ReadResult } from "@corridor/protocol";
import type { DrawnMaze } from "../text-sketch.ts";
import { describeFault } from "./cell-list.ts";
import { contestGoals, contestStart } from "./contest-cells.ts";
import { blocksOf, sides, wallFaults, type WallTable } from "./wall-table.ts";

/** Number of cells on a side. */
export const BINARY_SIDE = 16;
const MAX_PROBLEMS = 20;
const NORTH = 1;
const ALL = 15;

/**
 * Whether a file is binary: 256 bytes of which at least one appears in no text. The character that
 * ended texts in DOS does not count.
 */
export function isBinaryMaze(bytes: Uint8Array): boolean {
  const isText = (byte: number): boolean => byte >= 32 || [9, 10, 13, 26].includes(byte);
  return bytes.length === BINARY_SIDE * BINARY_SIDE && !bytes.every(isText);
}

/**
 * Reads 256 bytes. Some programs turned or mirrored the bits of the walls, so that the start, which
 * has three walls, is not open to the north. The one way to turn them back is found by the walls,
 * which must be closed, and equal from both sides.
 */
export function readCellBytes(bytes: Uint8Array): ReadResult<DrawnMaze> {
  const walls = bytes.map((byte) => byte & ALL);
  const usual: WallTable = { columns: BINARY_SIDE, rows: BINARY_SIDE, walls };
  const turned = symmetries
    .map((symmetry): WallTable => ({
      ...usual,
      walls: walls.map((bits) => permuted(bits, symmetry)),
    }))
    .filter((table) => table.walls[0] === ALL - NORTH);
  const table = [...turned, usual].find((each) => wallFaults(each).next().done === true);
  if (table === undefined) return { ok: false, problems: problemsOf(turned[0] ?? usual) };
  const blocks = blocksOf(table);
  return { ok: true, value: { blocks, start: contestStart(table), goals: contestGoals(table) } };
}

/** Writes 256 bytes. The table has 16 x 16 cells. */
export function writeCellBytes({ walls }: WallTable): Uint8Array<ArrayBuffer> {
  return Uint8Array.from(walls);
}

/** Where each side of a cell is in the file, for the four turns without and with a reflection. */
const symmetries = [0, 1, 2, 3].flatMap((turn) =>
  [1, -1].map((direction) => sides.map((_, at) => (turn + direction * at + 4) % 4)),
);

function permuted(bits: number, symmetry: readonly number[]): number {
  return symmetry.reduce((sum, from, to) => sum + (((bits >> from) & 1) << to), 0);
}

function problemsOf(table: WallTable): FieldProblem[] {
  const problems: FieldProblem[] = [];
  const indexOf = ({ x, y }: { x: number; y: number }): number => x * BINARY_SIDE + y;
  for (const fault of wallFaults(table)) {
    if (problems.length === MAX_PROBLEMS) break;
    const described = describeFault(fault, (cell) => `of byte ${indexOf(cell)}`);
    problems.push({ path: `byte ${indexOf(fault.cell)}`, ...described });
  }
  return problems;
}
