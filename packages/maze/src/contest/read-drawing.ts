/**
 * Reads drawings of contest mazes, the `.map` and `.txt` files of micromouse simulators: a post
 * every four characters, walls between the posts, and a line of cells after each line of posts. Any
 * characters may draw posts and walls. Text after the maze is ignored.
 */
import type { ReadResult } from "@corridor/protocol";
import { BLOCK, OPEN } from "../maze-limits.ts";
import { type DrawnMaze, type Drawing, markOf, nameOf, Sketch } from "../text-sketch.ts";
import { contestGoals, contestStart, MAX_CONTEST_SIDE } from "./contest-cells.ts";

/** Distance between adjacent posts, in characters. */
const PITCH = 4;
const USUAL_POSTS = "o+";
const USUAL_WALL = "|";
/** Maximum number of characters that a problem quotes. */
const MAX_QUOTED = 20;

/**
 * Whether a text with this first line draws posts and walls. Posts `o` and `+` appear in no other
 * drawing. Other characters must have the pattern of an outer wall, and not all of them may draw
 * squares.
 */
export function startsDrawing(line: string): boolean {
  const text = line.trim();
  if (USUAL_POSTS.includes(text.slice(0, 1))) return text !== "";
  if (text.length % PITCH !== 1 || text.length === 1) return false;
  const [post = "", ...wall] = text.slice(0, PITCH);
  const pattern = (post + wall.join("")).repeat((text.length - 1) / PITCH) + post;
  const isWall = wall.every((character) => character === wall[0]);
  return isWall && text === pattern && [post, ...wall].some((each) => markOf(each) === undefined);
}

/** @returns the maze, or the problems with their line and column */
export function readDrawing({ lines, firstLine }: Drawing): ReadResult<DrawnMaze> {
  const sketch = new Sketch(firstLine);
  const first = lines[0] ?? "";
  const indent = Math.max(0, first.search(/\S/));
  const width = first.trim().length;
  if (width % PITCH !== 1 || width === 1 || width > PITCH * MAX_CONTEST_SIDE + 1) {
    const expected = `1 to ${MAX_CONTEST_SIDE} cells: a post every ${PITCH} characters, o---o---o`;
    sketch.addProblem(0, null, `${width} characters`, expected);
    return sketch.finish([]);
  }
  const rows = linesOfMaze(sketch, lines, indent);
  if (rows === null) return sketch.finish([]);
  if (rows.length < 3 || rows.length > 2 * MAX_CONTEST_SIDE + 1) {
    const expected = `an odd number from 3 to ${2 * MAX_CONTEST_SIDE + 1}: lines of posts around lines of cells`;
    sketch.addProblem(rows.length - 1, null, `${rows.length} lines`, expected);
    return sketch.finish([]);
  }
  // A post inside a wall indicates shifted characters, unless the drawing uses one character for
  // both.
  const post = first.slice(indent, indent + 1);
  const isPost = (wall: string): boolean =>
    !first.slice(indent + 1, indent + PITCH).includes(post) && wall.includes(post);
  const blocks: string[] = [];
  for (const [row, text] of rows.entries()) {
    if (sketch.isFull) break;
    if (text.length > width) {
      const expected = `at most ${width}, as in line ${firstLine}`;
      sketch.addProblem(row, null, `${text.length} characters`, expected);
      continue;
    }
    const line = { text: text.padEnd(width), row, indent };
    blocks.push(row % 2 === 0 ? readPosts(sketch, line, isPost) : readCells(sketch, line));
  }
  const size = { columns: (width - 1) / PITCH, rows: (rows.length - 1) / 2 };
  return sketch.finish(blocks, { start: contestStart(size), goals: contestGoals(size) });
}

/**
 * The lines of the maze, without indentation and trailing spaces. They end before the first line
 * that starts with neither a post nor a wall.
 * @returns null after adding a problem
 */
function linesOfMaze(sketch: Sketch, lines: readonly string[], indent: number): string[] | null {
  const textAt = (at: number): string | null => {
    const line = lines[at];
    return line === undefined || line.slice(0, indent).trim() !== ""
      ? null
      : line.slice(indent).trimEnd();
  };
  const [post = "", wall] = textAt(0) ?? "";
  const walls = `${textAt(1)?.slice(0, 1).trim() ?? ""}${USUAL_WALL}`;
  // Without posts of their own, drawings continue a wall at the place of a post.
  const posts = `${post}${USUAL_POSTS}${post === wall ? walls : ""}`;
  const startsWith = (text: string | null, characters: string): boolean =>
    text !== null && text !== "" && characters.includes(text.slice(0, 1));
  const found = [textAt(0) ?? ""];
  for (;;) {
    const cells = textAt(found.length);
    const below = textAt(found.length + 1);
    if (cells === null || below === null) break;
    if (!startsWith(cells, walls) && !(startsWith(cells, " ") || cells === "")) break;
    if (!startsWith(below, posts) && !(startsWith(cells, walls) && startsWith(below, " "))) break;
    found.push(cells, below);
  }
  // A line with an error looks like text after the maze, so only a closed maze ends before text.
  const rest = lines.slice(found.length);
  const last = found.at(-1) ?? "";
  const isClosed = last.length === found[0]?.length && !last.includes(" ");
  const next = textAt(found.length);
  if (startsWith(next, walls)) {
    const line = nameOf((lines[found.length + 1] ?? "").slice(0, MAX_QUOTED));
    sketch.addProblem(found.length + 1, null, line, "a line of posts, such as o---o");
    return null;
  }
  if (isClosed || rest.every((line) => line.trim() === "")) return found;
  const line = nameOf((lines[found.length] ?? "").slice(0, MAX_QUOTED));
  const expected = "a line of cells, such as |   |, or a closed outer wall above";
  sketch.addProblem(found.length, null, line, expected);
  return null;
}

interface Line {
  text: string;
  row: number;
  /** number of characters before the first post */
  indent: number;
}

/** Reads a line of posts and the walls between them. A missing post is open. */
function readPosts(
  sketch: Sketch,
  { text, row, indent }: Line,
  isPost: (wall: string) => boolean,
): string {
  let cells = "";
  for (let at = 0; at < text.length; at += PITCH) {
    cells += text[at] === " " ? OPEN : BLOCK;
    if (at + 1 === text.length) break;
    const wall = text.slice(at + 1, at + PITCH);
    // Simulators read only the character in the middle of a wall.
    const isOpen = wall[1] === " ";
    if ((isOpen && wall.trim() !== "") || isPost(wall)) {
      sketch.addProblem(row, at + 1 + indent, nameOf(wall), "a wall, ---, or three spaces");
    }
    cells += isOpen ? OPEN : BLOCK;
  }
  return cells;
}

/** Reads a line of cells and the walls between them. A cell is empty or contains one mark. */
function readCells(sketch: Sketch, { text, row, indent }: Line): string {
  let cells = "";
  for (let at = 0; at < text.length; at += PITCH) {
    cells += text[at] === " " ? OPEN : BLOCK;
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
