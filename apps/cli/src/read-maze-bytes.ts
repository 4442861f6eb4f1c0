/** Reads mazes in all formats, which it detects by their content. */
import {
  isBinaryMaze,
  isContestText,
  readBinaryMaze,
  readMaze,
  readTextMaze,
  type MazeDocument,
} from "@corridor/maze";
import type { ReadResult } from "@corridor/protocol";
import { readUtf8 } from "./read-utf8.ts";

/** @param name name of a maze whose format stores none */
export function readMazeBytes(bytes: Uint8Array, name: string): ReadResult<MazeDocument> {
  if (isBinaryMaze(bytes)) return readBinaryMaze(bytes, name);
  // Old drawings end with a description, in any encoding.
  const drawing = new TextDecoder().decode(bytes);
  if (isContestText(drawing)) return readTextMaze(drawing, name);
  return readUtf8(bytes, (text) =>
    /^\s*[{[]/.test(text) ? readMaze(text) : readTextMaze(text, name),
  );
}
