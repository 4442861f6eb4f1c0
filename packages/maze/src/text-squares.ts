/**
 * Reads mazes drawn with one character per square. A drawing uses either dots (or underscores) or
 * spaces for open squares, not both. Editors strip trailing spaces, so only a drawing with spaces
 * may have lines of different lengths. A space in a drawing with dots is an error.
 */
import type { ReadResult } from "@corridor/protocol";
import { BLOCK, MAX_SIDE, OPEN } from "./maze-limits.ts";
import {
  type DrawnMaze,
  type Drawing,
  indentOf,
  type Mark,
  markOf,
  nameOf,
  Sketch,
} from "./text-sketch.ts";

const EXPECTED = "# for a block, . for an open square, S or ^ > v < for the start, G for a goal";
/** Maximum number of characters that a problem quotes. */
const MAX_QUOTED = 40;

/** @returns the maze, or the problems with their line and column */
export function readSquares({ lines, firstLine }: Drawing): ReadResult<DrawnMaze> {
  const sketch = new Sketch(firstLine);
  const first = lines[0] ?? "";
  if (!isDrawn(first)) {
    const quoted = first.length > MAX_QUOTED ? `${first.slice(0, MAX_QUOTED)}…` : first;
    sketch.addProblem(0, null, JSON.stringify(quoted), `a row of squares: ${EXPECTED}`);
    return sketch.finish([]);
  }
  if (lines.length > MAX_SIDE) {
    sketch.addProblem(MAX_SIDE, null, `${lines.length} rows`, `at most ${MAX_SIDE} rows`);
    return sketch.finish([]);
  }
  const isDotted = lines.some((line) => /[._]/.test(line));
  const indent = isDotted ? indentOf(lines) : 0;
  const rows = isDotted ? lines.map((line) => line.trimEnd().slice(indent)) : spacedRows(lines);
  const width = isDotted ? (rows[0] ?? "").length : Math.max(...rows.map((row) => row.length));
  if (width > MAX_SIDE) {
    sketch.addProblem(0, null, `${width} squares`, `at most ${MAX_SIDE} squares in a row`);
    return sketch.finish([]);
  }
  const blocks: string[] = [];
  for (const [row, text] of rows.entries()) {
    if (sketch.isFull) break;
    if (isDotted && text.length !== width) {
      const expected = `${width} squares, as in line ${firstLine}`;
      sketch.addProblem(row, null, `${text.length} squares`, expected);
      continue;
    }
    if (text === "") {
      sketch.addProblem(row, null, "an empty line", "a row of squares: draw open squares as .");
      continue;
    }
    blocks.push(readRow(sketch, text.padEnd(width), { row, indent, isDotted }));
  }
  return sketch.finish(blocks);
}

/** Whether a line is likely a row: at least half of its characters are marks. */
function isDrawn(line: string): boolean {
  const characters = Array.from(line.trim());
  return (
    characters.filter((character) => markOf(character) !== undefined).length * 2 >=
    characters.length
  );
}

/**
 * Trailing spaces are squares only if all lines have the same length. Otherwise they are stripped.
 */
function spacedRows(lines: readonly string[]): string[] {
  const isEven = lines.every((line) => line.length === lines[0]?.length);
  return lines.map((line) => (isEven ? line : line.trimEnd()));
}

interface RowPlace {
  row: number;
  /** number of characters before the first square */
  indent: number;
  isDotted: boolean;
}

/** Returns one row of the document's blocks. Adds starts, goals and problems to the sketch. */
function readRow(sketch: Sketch, text: string, { row, indent, isDotted }: RowPlace): string {
  let cells = "";
  for (const [column, character] of Array.from(text).entries()) {
    const mark: Mark | undefined = isDotted && character === " " ? undefined : markOf(character);
    if (mark === undefined) {
      const expected = character === " " ? ". as for the other open squares" : EXPECTED;
      sketch.addProblem(row, column + indent, nameOf(character), expected);
    } else if (mark.kind !== "block" && mark.kind !== "open") {
      sketch.addMark(mark, { column, row }, row, column + indent);
    }
    cells += mark?.kind === "block" ? BLOCK : OPEN;
  }
  return cells;
}
