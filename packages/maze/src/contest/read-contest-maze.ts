/** Detects and reads files of contests, by their content. */
import type { ReadResult } from "@corridor/protocol";
import type { MazeDocument } from "../maze-document.ts";
import { MAX_NAME_LENGTH } from "../maze-limits.ts";
import type { DrawnMaze } from "../text-sketch.ts";
import { readCellBytes } from "./cell-bytes.ts";
import { startsCellList } from "./cell-list.ts";
import { startsDrawing } from "./read-drawing.ts";

/** Whether a text is a drawing of posts and walls, or a list of cells. */
export function isContestText(text: string): boolean {
  const [line = ""] = text
    .replace(/^\uFEFF/, "")
    .trimStart()
    .split(/[\r\n]/, 1);
  return startsDrawing(line) || startsCellList(line);
}

/**
 * Reads a binary file, for which `isBinaryMaze` is true.
 * @param name name of the document, truncated to `MAX_NAME_LENGTH`; a file has no name
 */
export function readBinaryMaze(bytes: Uint8Array, name: string): ReadResult<MazeDocument> {
  const read = readCellBytes(bytes);
  return read.ok ? { ok: true, value: named(read.value, name) } : read;
}

export function named({ blocks, start, goals }: DrawnMaze, name: string): MazeDocument {
  const shortName = name.slice(0, MAX_NAME_LENGTH);
  return { format: "corridor/maze", version: 1, name: shortName, blocks, start, goals };
}
