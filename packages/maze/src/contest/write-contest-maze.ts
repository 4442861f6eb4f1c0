/** Writes mazes as files of contests. Refuses what the format cannot store. */
import type { MazeDocument } from "../maze-document.ts";
import { BINARY_SIDE, writeCellBytes } from "./cell-bytes.ts";
import { writeCellList } from "./cell-list.ts";
import { contestGoals, contestStart } from "./contest-cells.ts";
import { type ContestMaze, contestMazeOf, type ContestResult, refuse } from "./contest-maze.ts";
import { hasOuterWall, missingPosts } from "./outer-wall.ts";
import { writeDrawing } from "./write-drawing.ts";

/** Formats of contests: a drawing, a list of numbers, and 256 bytes. */
export const contestFormats = ["map", "num", "maz"] as const;
export type ContestFormat = (typeof contestFormats)[number];

/** @returns the content of the file, or why the maze cannot be stored in this format */
export function writeContestMaze(
  document: MazeDocument,
  format: ContestFormat,
): ContestResult<string | Uint8Array<ArrayBuffer>> {
  const read = contestMazeOf(document);
  if (!read.ok) return read;
  if (!hasOuterWall(document)) {
    return refuse("outer-wall", "blocks", "a gap in the outer wall", "blocks on all sides");
  }
  if (format === "map") return writeMap(read.value);
  const refusal = refuseDefaults(read.value);
  if (refusal !== null) return refusal;
  if (format === "num") return { ok: true, value: writeCellList(read.value) };
  const { columns, rows } = read.value;
  if (columns !== BINARY_SIDE || rows !== BINARY_SIDE) {
    const expected = `${BINARY_SIDE} x ${BINARY_SIDE} cells between posts and walls`;
    return refuse("sides", "blocks", `${columns} x ${rows}`, expected);
  }
  return { ok: true, value: writeCellBytes(read.value) };
}

function writeMap(contest: ContestMaze): ContestResult<string> {
  if (contest.goals.length === 0) {
    return refuse("no-goal", "goals", "none", "a goal: without one, it is the centre");
  }
  return { ok: true, value: writeDrawing(contest) };
}

/** Lists and binary files have all posts, and store neither a start nor goals. */
function refuseDefaults(contest: ContestMaze): ReturnType<typeof refuse> | null {
  const { maze, start } = contest;
  const missing = missingPosts(maze);
  if (missing > 0) {
    const expected = "blocks wherever column and row are even";
    return refuse("posts", "blocks", `${missing} missing posts`, expected);
  }
  if (start.x !== 0 || start.y !== 0 || maze.start.heading !== contestStart(contest).heading) {
    const found = `column ${maze.start.column}, row ${maze.start.row}, ${maze.start.heading}`;
    return refuse("start", "start", found, "the cell at the bottom left, facing north");
  }
  const found = new Set(maze.goals.map(({ column, row }) => `${column}, ${row}`));
  const centre = contestGoals(contest).map(({ column, row }) => `${column}, ${row}`);
  if (found.size !== centre.length || !centre.every((cell) => found.has(cell))) {
    const expected = `the cells in the centre, column and row ${centre.join("; ")}`;
    const count = `${found.size} ${found.size === 1 ? "cell" : "cells"}`;
    return refuse("goals", "goals", count, expected);
  }
  return null;
}
