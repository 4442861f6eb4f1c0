/**
 * Reads micromouse mazes: posts (`o` or `+`) with walls between them (`---` and `|`), the notation
 * of the contest's maze collections and simulators. Its walls have no width. Each wall becomes a
 * block, so n x m squares become (2n + 1) x (2m + 1) cells.
 */
import type { ReadResult } from "@corridor/protocol";
import { BLOCK, MAX_SIDE, OPEN } from "./maze-limits.ts";
import { type DrawnMaze, type Drawing, indentOf, markOf, nameOf, Sketch } from "./text-sketch.ts";

/** Distance between adjacent posts, in characters. */
const PITCH = 4;
const MAX_SQUARES = Math.floor((MAX_SIDE - 1) / 2);

/** @returns the maze, or the problems with their line and column */
export function readWalls({ lines, firstLine }: Drawing): ReadResult<DrawnMaze> {
  const sketch = new Sketch(firstLine);
  const indent = indentOf(lines);
  const rows = lines.map((line) => line.trimEnd().slice(indent));
  const width = rows[0]?.length ?? 0;
  if (width % PITCH !== 1 || width === 1 || width > PITCH * MAX_SQUARES + 1) {
    const expected = `1 to ${MAX_SQUARES} squares: a post every ${PITCH} characters, o---o---o`;
    sketch.addProblem(0, null, `${width} characters`, expected);
    return sketch.finish([]);
  }
  if (rows.length % 2 === 0 || rows.length > 2 * MAX_SQUARES + 1 || rows.length === 1) {
    const expected = `an odd number from 3 to ${2 * MAX_SQUARES + 1}: lines of posts around lines of squares`;
    sketch.addProblem(rows.length - 1, null, `${rows.length} lines`, expected);
    return sketch.finish([]);
  }
  const blocks: string[] = [];
  for (const [row, text] of rows.entries()) {
    if (sketch.isFull) break;
    if (text.length > width) {
      const expected = `at most ${width}, as in line ${firstLine}`;
      sketch.addProblem(row, null, `${text.length} characters`, expected);
      continue;
    }
    const line = { text: text.padEnd(width), row, indent };
    blocks.push(row % 2 === 0 ? readPosts(sketch, line) : readCells(sketch, line));
  }
  return sketch.finish(blocks);
}

interface Line {
  text: string;
  row: number;
  /** number of characters before the first post */
  indent: number;
}

/** Reads a line of posts and the walls between them. A post is a block; a missing post is open. */
function readPosts(sketch: Sketch, { text, row, indent }: Line): string {
  let cells = "";
  for (let at = 0; at < text.length; at += PITCH) {
    const post = text.slice(at, at + 1);
    if (!"o+ ".includes(post)) {
      sketch.addProblem(row, at + indent, nameOf(post), "a post: o or +");
    }
    cells += post === " " ? OPEN : BLOCK;
    if (at + 1 === text.length) break;
    const wall = text.slice(at + 1, at + PITCH);
    if (wall !== "---" && wall.trim() !== "") {
      sketch.addProblem(row, at + 1 + indent, nameOf(wall), "a wall, ---, or three spaces");
    }
    cells += wall.trim() === "" ? OPEN : BLOCK;
  }
  return cells;
}

/** Reads a line of squares and the walls between them. A square is empty or contains one mark. */
function readCells(sketch: Sketch, { text, row, indent }: Line): string {
  let cells = "";
  for (let at = 0; at < text.length; at += PITCH) {
    const wall = text.slice(at, at + 1);
    if (wall !== "|" && wall !== " ") {
      sketch.addProblem(row, at + indent, nameOf(wall), "a wall, |, or a space");
    }
    cells += wall === " " ? OPEN : BLOCK;
    if (at + 1 === text.length) break;
    const inside = text.slice(at + 1, at + PITCH);
    const column = at + 1 + Math.max(0, inside.search(/\S/)) + indent;
    const mark = markOf(inside.trim() === "" ? " " : inside.trim());
    if (mark === undefined || mark.kind === "block") {
      const expected = "three spaces, S or ^ > v < for the start, or G for a goal";
      sketch.addProblem(row, column, nameOf(inside.trim()), expected);
    } else if (mark.kind !== "open") {
      sketch.addMark(mark, { column: (2 * at) / PITCH + 1, row }, row, column);
    }
    cells += OPEN;
  }
  return cells;
}
