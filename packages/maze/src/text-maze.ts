/**
 * Mazes drawn as plain text, for example in mails, books and other programs. Two notations are
 * supported: squares (one character per cell), and the walls and posts of micromouse mazes.
 * Ambiguous text is rejected with line, column, the found and the expected text.
 */
import type { FieldProblem, ReadResult } from "@corridor/protocol";
import type { Cell, MazeDocument } from "./maze-document.ts";
import { MAX_NAME_LENGTH } from "./maze-limits.ts";
import { GOAL_MARK, startMarks } from "./text-sketch.ts";
import { readSquares } from "./text-squares.ts";
import { readWalls } from "./text-walls.ts";

/** Maximum text length in characters. The largest micromouse maze needs half of it. */
const MAX_TEXT_LENGTH = 262_144;

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
  // If spaces are open squares, a line of spaces is a row. Otherwise it only surrounds the drawing.
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

/** Whether the text uses the micromouse notation: only that notation starts with a post. */
function isWalls(lines: readonly string[]): boolean {
  return /^\s*[o+]/.test(lines.find((line) => line.trim() !== "") ?? "");
}

function refuse(found: string, expected: string): { ok: false; problems: FieldProblem[] } {
  return { ok: false, problems: [{ path: "", found, expected }] };
}
