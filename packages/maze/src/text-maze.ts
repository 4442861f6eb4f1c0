/**
 * Mazes drawn as plain text, as they stand in mails, books and other programs. Two ways of drawing are
 * read: squares (one character a cell) and the walls and posts of micromouse mazes. What would have to
 * be guessed is refused with line, column, what was found and what was expected.
 */
import type { FieldProblem, ReadResult } from "@corridor/protocol";
import type { Cell, MazeDocument } from "./maze-document.ts";
import { MAX_NAME_LENGTH } from "./maze-limits.ts";
import { GOAL_MARK, startMarks } from "./text-sketch.ts";
import { readSquares } from "./text-squares.ts";
import { readWalls } from "./text-walls.ts";

/** The longest text that is looked at: the largest micromouse maze needs half of it. */
const MAX_TEXT_LENGTH = 262_144;

/**
 * Reads a drawn maze; docs/maze-format.md describes the drawings.
 * @param name the document's name, since a drawing has none; cut to what a document can hold
 * @returns the maze with its goals in reading order, or 1 to 20 problems whose path is a line and a column
 */
export function readTextMaze(text: string, name: string): ReadResult<MazeDocument> {
  if (text.length > MAX_TEXT_LENGTH) {
    return refuse(`${text.length} characters`, `at most ${MAX_TEXT_LENGTH} characters`);
  }
  const lines = text.replace(/^\uFEFF/, "").split(/\r\n|\r|\n/);
  if (lines.every((line) => line.trim() === "")) return refuse("nothing", "a maze, line by line");
  // Where spaces are open squares, a line of spaces is a row; else only a line around the drawing.
  const isSpaced = !isWalls(lines) && !lines.some((line) => /[._]/.test(line));
  const isRow = (line: string): boolean => (isSpaced ? line : line.trim()) !== "";
  const first = lines.findIndex(isRow);
  const drawing = {
    lines: lines.slice(first, lines.findLastIndex(isRow) + 1),
    firstLine: first + 1,
  };
  const read = isWalls(lines) ? readWalls(drawing) : readSquares(drawing);
  if (!read.ok) return read;
  const { blocks, start, goals } = read.value;
  const shortName = name.slice(0, MAX_NAME_LENGTH);
  return {
    ok: true,
    value: { format: "corridor/maze", version: 1, name: shortName, blocks, start, goals },
  };
}

/**
 * Draws a maze with one character a square: `#` block, `.` open, `^ > v <` start by its heading, `G` goal,
 * `▲ ► ▼ ◄` a start that is a goal. The name and the order of the goals are not in the drawing.
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

/** Posts begin a drawing of walls, and no drawing of squares. */
function isWalls(lines: readonly string[]): boolean {
  return /^\s*[o+]/.test(lines.find((line) => line.trim() !== "") ?? "");
}

function refuse(found: string, expected: string): { ok: false; problems: FieldProblem[] } {
  return { ok: false, problems: [{ path: "", found, expected }] };
}
