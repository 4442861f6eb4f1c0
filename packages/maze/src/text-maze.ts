/**
 * Mazes as plain text, for example in mails, books and other programs: drawings with one character
 * per cell, and the drawings and lists of contests. Ambiguous text is rejected with line, column,
 * the found and the expected text.
 */
import type { FieldProblem, ReadResult } from "@corridor/protocol";
import type { Cell, MazeDocument } from "./maze-document.ts";
import { readCellList, startsCellList } from "./contest/cell-list.ts";
import { named } from "./contest/read-contest-maze.ts";
import { readDrawing, startsDrawing } from "./contest/read-drawing.ts";
import { type DrawnMaze, type Drawing, GOAL_MARK, startMarks } from "./text-sketch.ts";
import { readSquares } from "./text-squares.ts";

/** Maximum text length in characters. The longest list of cells nearly needs it. */
const MAX_TEXT_LENGTH = 262_144;
/** Characters of binary files, such as those of mazes with another number of cells. */
// oxlint-disable-next-line no-control-regex -- these are the characters to find
const CONTROL = /[\u0000-\u0008\u000E-\u0019]/;

/**
 * Reads a drawn maze. docs/maze-format.md describes the notations.
 * @param name name of the document, truncated to `MAX_NAME_LENGTH`; a drawing has no name
 * @returns the maze with its goals in reading order, or 1 to 20 problems whose path is a line and a
 *   column
 */
export function readTextMaze(text: string, name: string): ReadResult<MazeDocument> {
  if (text.length > MAX_TEXT_LENGTH) {
    return refuse(`${text.length} characters`, `at most ${MAX_TEXT_LENGTH} characters`);
  }
  const lines = text.replace(/^\uFEFF/, "").split(/\r\n|\r|\n/);
  if (lines.every((line) => line.trim() === "")) return refuse("nothing", "a maze, line by line");
  const start = lines.find((line) => line.trim() !== "") ?? "";
  const read = readerOf(start);
  if (read === readSquares && CONTROL.test(start)) {
    return refuse("data that is not text", "a drawing, a list of cells, or 256 bytes of walls");
  }
  // If spaces are open squares, a line of spaces is a row. Otherwise it only surrounds the drawing.
  const isSpaced = read === readSquares && !lines.some((line) => /[._]/.test(line));
  const isRow = (line: string): boolean => (isSpaced ? line : line.trim()) !== "";
  const first = lines.findIndex(isRow);
  const drawn = read({
    lines: lines.slice(first, lines.findLastIndex(isRow) + 1),
    firstLine: first + 1,
  });
  return drawn.ok ? { ok: true, value: named(drawn.value, name) } : drawn;
}

/** Chooses the notation by the first line. */
function readerOf(line: string): (drawing: Drawing) => ReadResult<DrawnMaze> {
  if (startsDrawing(line)) return readDrawing;
  return startsCellList(line) ? readCellList : readSquares;
}

/**
 * Draws a maze with one character per square: `#` block, `.` open, `^ > v <` start by heading, `G`
 * goal, `▲ ► ▼ ◄` a start that is also a goal. The drawing omits the name and the order of goals.
 */
export function writeTextMaze(maze: MazeDocument): string {
  const { blocks, start, goals } = maze;
  const rows = blocks.map((row) => row.split(""));
  const put = ({ column, row }: Cell, mark: string): void => {
    const cells = rows[row];
    if (cells !== undefined) cells[column] = mark;
  };
  for (const goal of goals) put(goal, GOAL_MARK);
  const isGoal = rows[start.row]?.[start.column] === GOAL_MARK;
  const marks = startMarks[start.heading];
  put(start, isGoal ? marks.startAndGoal : marks.start);
  return `${rows.map((row) => row.join("")).join("\n")}\n`;
}

function refuse(found: string, expected: string): { ok: false; problems: FieldProblem[] } {
  return { ok: false, problems: [{ path: "", found, expected }] };
}
