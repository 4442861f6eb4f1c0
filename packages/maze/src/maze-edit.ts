/**
 * Edits of a maze: document in, document out. Pure, so that undo is keeping the old document;
 * untouched rows are shared between the two, and an edit that changes nothing gives back the very
 * same document. An edit that would break the document is refused with a code, never an exception:
 * the page turns the code into a sentence.
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
  /** the cell lies outside of the grid */
  | "outside"
  /** a block cannot be put onto the start */
  | "start-here"
  /** start and goals stand on open cells only */
  | "block-here"
  /** the maze has as many goals as a document can hold */
  | "too-many-goals"
  /** columns or rows are not whole numbers from 1 to 256 */
  | "bad-size"
  /** the name is longer than a document can hold */
  | "name-too-long";

export type MazeEdit = { ok: true; maze: MazeDocument } | { ok: false; code: MazeRefusal };

/**
 * Fills or opens a cell. Filling a goal removes that goal; filling the start is refused.
 * @returns refused as "outside" or "start-here"
 */
export function setBlock(maze: MazeDocument, cell: Cell, filled: boolean): MazeEdit {
  if (!isInside(maze, cell)) return refuse("outside");
  if (isBlock(maze, cell.column, cell.row) === filled) return accept(maze);
  if (filled && isSameCell(maze.start, cell)) return refuse("start-here");
  const blocks = withCell(maze.blocks, cell, filled ? BLOCK : OPEN);
  return accept({ ...maze, blocks, goals: filled ? withoutGoal(maze.goals, cell) : maze.goals });
}

/** Fills an open cell, opens a filled one; refused as `setBlock` is. */
export function toggleBlock(maze: MazeDocument, cell: Cell): MazeEdit {
  return setBlock(maze, cell, !isBlock(maze, cell.column, cell.row));
}

/**
 * Puts the start onto an open cell, which may be a goal.
 * @returns refused as "outside" or "block-here"
 */
export function setStart(maze: MazeDocument, cell: Cell, heading: HeadingName): MazeEdit {
  const code = whyNotOpen(maze, cell);
  if (code !== null) return refuse(code);
  if (isSameCell(maze.start, cell) && maze.start.heading === heading) return accept(maze);
  return accept({ ...maze, start: { column: cell.column, row: cell.row, heading } });
}

/**
 * Makes an open cell a goal, or takes every goal on it away.
 * @returns refused as "outside", "block-here" or "too-many-goals"
 */
export function toggleGoal(maze: MazeDocument, cell: Cell): MazeEdit {
  const code = whyNotOpen(maze, cell);
  if (code !== null) return refuse(code);
  const others = withoutGoal(maze.goals, cell);
  if (others !== maze.goals) return accept({ ...maze, goals: others });
  if (maze.goals.length >= MAX_GOALS) return refuse("too-many-goals");
  return accept({ ...maze, goals: [...maze.goals, { column: cell.column, row: cell.row }] });
}

/** Opens every cell; start and goals stay. */
export function clearBlocks(maze: MazeDocument): MazeDocument {
  if (maze.blocks.every((row) => !row.includes(BLOCK))) return maze;
  const openRow = OPEN.repeat(sizeOf(maze).columns);
  return { ...maze, blocks: maze.blocks.map(() => openRow) };
}

/**
 * Changes the size at the right and bottom edges. New cells are open. A start that is cut off moves
 * to the nearest cell that remains, which is opened for it; goals that are cut off are dropped.
 * @param columns 1 to 256
 * @param rows 1 to 256
 * @returns refused as "bad-size"
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

/** Gives the maze another name, which may be empty; refused as "name-too-long". */
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

function whyNotOpen(maze: MazeDocument, cell: Cell): MazeRefusal | null {
  if (!isInside(maze, cell)) return "outside";
  return isBlock(maze, cell.column, cell.row) ? "block-here" : null;
}

/** The goals without those on a cell; the same list when there is none. */
function withoutGoal(goals: Cell[], cell: Cell): Cell[] {
  const others = goals.filter((goal) => !isSameCell(goal, cell));
  return others.length === goals.length ? goals : others;
}

function withCell(blocks: string[], { column, row }: Cell, mark: string): string[] {
  return blocks.map((text, at) =>
    at === row ? text.slice(0, column) + mark + text.slice(column + 1) : text,
  );
}
