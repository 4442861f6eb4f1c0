/**
 * Edits of a maze as pure functions from document to document, so that undo restores the previous
 * document. Both documents share unchanged rows. An edit without effect returns the same object.
 * An edit that would make the document invalid returns a code, which the page translates.
 */
import { isBlock, sizeOf } from "./maze-cells.ts";
import { type Cell, type MazeDocument } from "./maze-document.ts";
import {
  BLOCK,
  MAX_GOALS,
  MAX_NAME_LENGTH,
  MAX_SIDE,
  OPEN,
  type HeadingName,
} from "./maze-limits.ts";

/** Why an edit was refused. */
export type MazeRefusal =
  /** the cell is outside the grid */
  | "outside"
  /** the start cannot be a block */
  | "start-here"
  /** the start and the goals must be open cells */
  | "block-here"
  /** the maze already has the maximum number of goals */
  | "too-many-goals"
  /** columns and rows must be whole numbers from 1 to 256 */
  | "bad-size"
  /** the name exceeds the maximum length */
  | "name-too-long";

export type MazeEdit = { ok: true; maze: MazeDocument } | { ok: false; code: MazeRefusal };

/**
 * Fills or opens a cell. Filling a goal removes the goal. Filling the start is refused.
 * @returns the edit, or the code "outside" or "start-here"
 */
export function setBlock(maze: MazeDocument, cell: Cell, filled: boolean): MazeEdit {
  if (!isInside(maze, cell)) return refuse("outside");
  if (isBlock(maze, cell.column, cell.row) === filled) return accept(maze);
  if (filled && isSameCell(maze.start, cell)) return refuse("start-here");
  const blocks = withCell(maze.blocks, cell, filled ? BLOCK : OPEN);
  return accept({ ...maze, blocks, goals: filled ? withoutGoal(maze.goals, cell) : maze.goals });
}

/**
 * Moves the start to an open cell, which may be a goal.
 * @returns the edit, or the code "outside" or "block-here"
 */
export function setStart(maze: MazeDocument, cell: Cell, heading: HeadingName): MazeEdit {
  const code = closedReason(maze, cell);
  if (code !== null) return refuse(code);
  if (isSameCell(maze.start, cell) && maze.start.heading === heading) return accept(maze);
  return accept({ ...maze, start: { column: cell.column, row: cell.row, heading } });
}

/**
 * Adds a goal on an open cell, or removes all goals on it.
 * @returns the edit, or the code "outside", "block-here" or "too-many-goals"
 */
export function toggleGoal(maze: MazeDocument, cell: Cell): MazeEdit {
  const code = closedReason(maze, cell);
  if (code !== null) return refuse(code);
  const others = withoutGoal(maze.goals, cell);
  if (others !== maze.goals) return accept({ ...maze, goals: others });
  if (maze.goals.length >= MAX_GOALS) return refuse("too-many-goals");
  return accept({ ...maze, goals: [...maze.goals, { column: cell.column, row: cell.row }] });
}

/** Opens every cell. The start and the goals remain. */
export function clearBlocks(maze: MazeDocument): MazeDocument {
  if (maze.blocks.every((row) => !row.includes(BLOCK))) return maze;
  const openRow = OPEN.repeat(sizeOf(maze).columns);
  return { ...maze, blocks: maze.blocks.map(() => openRow) };
}

/**
 * Changes the size at the right and bottom edges. New cells are open. A start outside the new size
 * moves to the nearest cell inside, which is opened. Goals outside the new size are removed.
 * @param columns 1 to 256
 * @param rows 1 to 256
 * @returns the edit, or the code "bad-size"
 */
export function resize(maze: MazeDocument, columns: number, rows: number): MazeEdit {
  if (!isSide(columns) || !isSide(rows)) return refuse("bad-size");
  const before = sizeOf(maze);
  if (before.columns === columns && before.rows === rows) return accept(maze);
  const column = Math.min(maze.start.column, columns - 1);
  const row = Math.min(maze.start.row, rows - 1);
  const sized = Array.from({ length: rows }, (_, at) =>
    (maze.blocks[at] ?? "").slice(0, columns).padEnd(columns, OPEN),
  );
  const goals = maze.goals.filter((goal) => goal.column < columns && goal.row < rows);
  return accept({
    ...maze,
    blocks: withCell(sized, { column, row }, OPEN),
    start: isSameCell(maze.start, { column, row }) ? maze.start : { ...maze.start, column, row },
    goals: goals.length === maze.goals.length ? maze.goals : goals,
  });
}

/** Renames the maze. The name may be empty. Returns the code "name-too-long" if it is too long. */
export function rename(maze: MazeDocument, name: string): MazeEdit {
  if (name.length > MAX_NAME_LENGTH) return refuse("name-too-long");
  return accept(maze.name === name ? maze : { ...maze, name });
}

function accept(maze: MazeDocument): MazeEdit {
  return { ok: true, maze };
}

function refuse(code: MazeRefusal): MazeEdit {
  return { ok: false, code };
}

function isSameCell(a: Cell, b: Cell): boolean {
  return a.column === b.column && a.row === b.row;
}

function isSide(length: number): boolean {
  return Number.isInteger(length) && length >= 1 && length <= MAX_SIDE;
}

function isInside(maze: MazeDocument, { column, row }: Cell): boolean {
  return maze.blocks[row]?.[column] !== undefined;
}

function closedReason(maze: MazeDocument, cell: Cell): MazeRefusal | null {
  if (!isInside(maze, cell)) return "outside";
  return isBlock(maze, cell.column, cell.row) ? "block-here" : null;
}

/** Removes the goals on a cell. Returns the same array if there are none. */
function withoutGoal(goals: Cell[], cell: Cell): Cell[] {
  const others = goals.filter((goal) => !isSameCell(goal, cell));
  return others.length === goals.length ? goals : others;
}

function withCell(blocks: string[], { column, row }: Cell, mark: string): string[] {
  return blocks.map((text, at) =>
    at === row ? text.slice(0, column) + mark + text.slice(column + 1) : text,
  );
}
