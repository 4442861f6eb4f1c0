/**
 * Reads micromouse mazes: posts (`o` or `+`) with walls between them (`---` and `|`), as maze collections
 * and simulators of that contest write them. Their walls have no width; here each becomes a block, and n by
 * m squares become 2n + 1 by 2m + 1 cells.
 */
import type { ReadResult } from "@corridor/protocol";
import { BLOCK, MAX_SIDE, OPEN } from "./maze-limits.ts";
import { type DrawnMaze, type Drawing, indentOf, markOf, nameOf, Sketch } from "./text-sketch.ts";

/** Characters from one post to the next. */
const PITCH = 4;
const MAX_SQUARES = Math.floor((MAX_SIDE - 1) / 2);

/** @returns the maze; or what cannot be read of it, by line and column */
export function readWalls({ lines, firstLine }: Drawing): ReadResult<DrawnMaze> {
  const sketch = new Sketch(firstLine);
  const indent = indentOf(lines);
  const rows = lines.map((line) => line.trimEnd().slice(indent));
  const width = rows[0]?.length ?? 0;
  if (width % PITCH !== 1 || width === 1 || width > PITCH * MAX_SQUARES + 1) {
    const expected = `1 to ${MAX_SQUARES} squares: a post every ${PITCH} characters, o---o---o`;
    sketch.refuse(0, null, `${width} characters`, expected);
    return sketch.finish([]);
  }
  if (rows.length % 2 === 0 || rows.length > 2 * MAX_SQUARES + 1 || rows.length === 1) {
    const expected = `an odd number from 3 to ${2 * MAX_SQUARES + 1}: lines of posts around lines of squares`;
    sketch.refuse(rows.length - 1, null, `${rows.length} lines`, expected);
    return sketch.finish([]);
  }
  const blocks: string[] = [];
  for (const [row, text] of rows.entries()) {
    if (sketch.isFull) break;
    if (text.length > width) {
      const expected = `at most ${width}, as in line ${firstLine}`;
      sketch.refuse(row, null, `${text.length} characters`, expected);
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
  /** characters in front of the first post */
  indent: number;
}

/** A line of posts and the walls between them. A post is a block, one that is left out is open. */
function readPosts(sketch: Sketch, { text, row, indent }: Line): string {
  let cells = "";
  for (let at = 0; at < text.length; at += PITCH) {
    const post = text.slice(at, at + 1);
    if (!"o+ ".includes(post)) {
      sketch.refuse(row, at + indent, nameOf(post), "a post: o or +");
    }
    cells += post === " " ? OPEN : BLOCK;
    if (at + 1 === text.length) break;
    const wall = text.slice(at + 1, at + PITCH);
    if (wall !== "---" && wall.trim() !== "") {
      sketch.refuse(row, at + 1 + indent, nameOf(wall), "a wall, ---, or three spaces");
    }
    cells += wall.trim() === "" ? OPEN : BLOCK;
  }
  return cells;
}

/** A line of squares and the walls between them; a square is empty or holds one mark. */
function readCells(sketch: Sketch, { text, row, indent }: Line): string {
  let cells = "";
  for (let at = 0; at < text.length; at += PITCH) {
    const wall = text.slice(at, at + 1);
    if (wall !== "|" && wall !== " ") {
      sketch.refuse(row, at + indent, nameOf(wall), "a wall, |, or a space");
    }
    cells += wall === " " ? OPEN : BLOCK;
    if (at + 1 === text.length) break;
    const inside = text.slice(at + 1, at + PITCH);
    const column = at + 1 + Math.max(0, inside.search(/\S/)) + indent;
    const mark = markOf(inside.trim() === "" ? " " : inside.trim());
    if (mark === undefined || mark.kind === "block") {
      const expected = "three spaces, S or ^ > v < for the start, or G for a goal";
      sketch.refuse(row, column, nameOf(inside.trim()), expected);
    } else if (mark.kind !== "open") {
      sketch.take(mark, { column: (2 * at) / PITCH + 1, row }, row, column);
    }
    cells += OPEN;
  }
  return cells;
}
