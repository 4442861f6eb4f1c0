/** Whether a maze document is a maze of posts and walls, and what no file of a contest can store. */
import type { FieldProblem } from "@corridor/protocol";
import { isBlock, sizeOf } from "../maze-cells.ts";
import type { Cell, MazeDocument } from "../maze-document.ts";
import {
  cellOf,
  contestCellOf,
  type ContestCell,
  type ContestSize,
  MAX_CONTEST_SIDE,
} from "./contest-cells.ts";
import { cellsOf, sides, type WallTable } from "./wall-table.ts";

/** A maze of posts and walls. */
export interface ContestMaze extends WallTable {
  maze: MazeDocument;
  start: ContestCell;
  goals: ContestCell[];
}

/**
 * - `no-contest-maze`: its cells are not cells between posts and walls
 * - `no-goal`: files without a goal have it in the centre
 * - `outer-wall`: the outer wall has a gap
 * - `posts`: the format has all posts, and some are missing
 * - `start`, `goals`: the format stores none, so they must be those of a contest
 * - `sides`: the format stores another number of cells
 */
export type ContestRefusalCode =
  | "no-contest-maze"
  | "no-goal"
  | "outer-wall"
  | "posts"
  | "start"
  | "goals"
  | "sides";

/** Why a maze is not a contest maze, or cannot be stored in a format of contests. */
export interface ContestRefusal {
  code: ContestRefusalCode;
  problem: FieldProblem;
}

export type ContestResult<T> = { ok: true; value: T } | { ok: false; refusal: ContestRefusal };

export function refuse(
  code: ContestRefusalCode,
  path: string,
  found: string,
  expected: string,
): { ok: false; refusal: ContestRefusal } {
  return { ok: false, refusal: { code, problem: { path, found, expected } } };
}

/** Reads the posts and walls of a maze. */
export function contestMazeOf(maze: MazeDocument): ContestResult<ContestMaze> {
  const size = contestSizeOf(maze);
  if (size === null) {
    const { columns, rows } = sizeOf(maze);
    const expected = `odd numbers from 3 to ${2 * MAX_CONTEST_SIDE + 1}: posts and walls around cells`;
    return refuse("no-contest-maze", "blocks", `${columns} x ${rows} cells`, expected);
  }
  const walls = new Uint8Array(size.columns * size.rows);
  for (const cell of cellsOf(size)) {
    const { column, row } = cellOf(size, cell);
    if (isBlock(maze, column, row)) {
      const found = `a block in column ${column}`;
      const expected = "open cells wherever column and row are odd";
      return refuse("no-contest-maze", `blocks[${row}]`, found, expected);
    }
    for (const { bit, dx, dy } of sides) {
      if (isBlock(maze, column + dx, row - dy)) {
        walls[cell.x * size.rows + cell.y] = (walls[cell.x * size.rows + cell.y] ?? 0) | bit;
      }
    }
  }
  const start = contestCellOf(size, maze.start);
  if (start === null) return refuseBetween("start", maze.start);
  const goals: ContestCell[] = [];
  for (const [number, goal] of maze.goals.entries()) {
    const cell = contestCellOf(size, goal);
    if (cell === null) return refuseBetween(`goals[${number}]`, goal);
    goals.push(cell);
  }
  return { ok: true, value: { ...size, walls, maze, start, goals } };
}

function contestSizeOf(maze: MazeDocument): ContestSize | null {
  const { columns, rows } = sizeOf(maze);
  if (columns % 2 === 0 || rows % 2 === 0 || columns < 3 || rows < 3) return null;
  return { columns: (columns - 1) / 2, rows: (rows - 1) / 2 };
}

function refuseBetween(
  path: string,
  { column, row }: Cell,
): { ok: false; refusal: ContestRefusal } {
  const found = `column ${column}, row ${row}: between two cells`;
  return refuse("no-contest-maze", path, found, "an odd column and an odd row");
}
