/**
 * Reads mazes drawn with one character a square. Open squares are written as dots (or underlines) or as
 * spaces, not as both: editors drop spaces at the end of a line, so only a drawing with spaces may have
 * lines of different lengths, and a space in a drawing with dots is a slip.
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
const MAX_SHOWN = 40;

/** @returns the maze; or what cannot be read of it, by line and column */
export function readSquares({ lines, firstLine }: Drawing): ReadResult<DrawnMaze> {
  const sketch = new Sketch(firstLine);
  const first = lines[0] ?? "";
  if (!isDrawn(first)) {
    const shown = first.length > MAX_SHOWN ? `${first.slice(0, MAX_SHOWN)}…` : first;
    sketch.refuse(0, null, JSON.stringify(shown), `a row of squares: ${EXPECTED}`);
    return sketch.finish([]);
  }
  if (lines.length > MAX_SIDE) {
    sketch.refuse(MAX_SIDE, null, `${lines.length} rows`, `at most ${MAX_SIDE} rows`);
    return sketch.finish([]);
  }
  const isDotted = lines.some((line) => /[._]/.test(line));
  const indent = isDotted ? indentOf(lines) : 0;
  const rows = isDotted ? lines.map((line) => line.trimEnd().slice(indent)) : spacedRows(lines);
  const width = isDotted ? (rows[0] ?? "").length : Math.max(...rows.map((row) => row.length));
  if (width > MAX_SIDE) {
    sketch.refuse(0, null, `${width} squares`, `at most ${MAX_SIDE} squares in a row`);
    return sketch.finish([]);
  }
  const blocks: string[] = [];
  for (const [row, text] of rows.entries()) {
    if (sketch.isFull) break;
    if (isDotted && text.length !== width) {
      const expected = `${width} squares, as in line ${firstLine}`;
      sketch.refuse(row, null, `${text.length} squares`, expected);
      continue;
    }
    if (text === "") {
      sketch.refuse(row, null, "an empty line", "a row of squares: draw open squares as .");
      continue;
    }
    blocks.push(readRow(sketch, text.padEnd(width), { row, indent, isDotted }));
  }
  return sketch.finish(blocks);
}

/** Whether a line could be a row at all: half of its characters and more mean something. */
function isDrawn(line: string): boolean {
  const signs = Array.from(line.trim());
  return signs.filter((sign) => markOf(sign) !== undefined).length * 2 >= signs.length;
}

/** Spaces at the end are squares only where all lines are equally long; else they are what editors leave. */
function spacedRows(lines: readonly string[]): string[] {
  const isEven = lines.every((line) => line.length === lines[0]?.length);
  return lines.map((line) => (isEven ? line : line.trimEnd()));
}

interface RowPlace {
  row: number;
  /** characters in front of the first square */
  indent: number;
  isDotted: boolean;
}

/** One row of a document's blocks; starts, goals and problems go into the sketch. */
function readRow(sketch: Sketch, text: string, { row, indent, isDotted }: RowPlace): string {
  let cells = "";
  for (const [column, sign] of Array.from(text).entries()) {
    const mark: Mark | undefined = isDotted && sign === " " ? undefined : markOf(sign);
    if (mark === undefined) {
      const expected = sign === " " ? ". as for the other open squares" : EXPECTED;
      sketch.refuse(row, column + indent, nameOf(sign), expected);
    } else if (mark.kind !== "block" && mark.kind !== "open") {
      sketch.take(mark, { column, row }, row, column + indent);
    }
    cells += mark?.kind === "block" ? BLOCK : OPEN;
  }
  return cells;
}
