/** Saves a file as a download, which every browser supports. */
import { writeTextMaze, type MazeDocument } from "@corridor/maze";
import { fileName } from "./file-name.ts";

/** Some browsers read the data only after the user has chosen where to store the file. */
const READ_WITHIN_MS = 60_000;

/** @param name file name with its ending */
export function saveFile(content: Blob, name: string): void {
  const url = URL.createObjectURL(content);
  const link = document.createElement("a");
  link.href = url;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), READ_WITHIN_MS);
}

/**
 * Saves a document as a file that can be opened again: "long-way-round.maze.json". A run has no
 * white space, because its size limit applies to the compact text.
 */
export function saveDocument(
  document: { name: string },
  kind: "maze" | "program" | "run" | "lesson",
): void {
  const text = kind === "run" ? JSON.stringify(document) : `${JSON.stringify(document, null, 2)}\n`;
  const file = `${fileName(document.name, kind)}.${kind}.json`;
  saveFile(new Blob([text], { type: "application/json" }), file);
}

/** Saves the maze drawn as text, for mails and other programs. */
export function saveTextMaze(maze: MazeDocument): void {
  const content = new Blob([writeTextMaze(maze)], { type: "text/plain" });
  saveFile(content, `${fileName(maze.name, "maze")}.txt`);
}
