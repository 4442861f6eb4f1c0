/** The maze that a tile names. Pure. */
import { mazeOf, type LessonDocument } from "@corridor/challenge";
import type { MazeDocument } from "@corridor/maze";

/**
 * Given maze 1 of a task is "g1", unseen maze 31 is "u31".
 * @param task from 1
 * @returns null if the lesson has no such maze, because a tile is the claim of a page
 */
export function tileMaze(lesson: LessonDocument, task: number, name: string): MazeDocument | null {
  const found = lesson.tasks[task - 1];
  if (found === undefined) return null;
  try {
    const at = (name.startsWith("u") ? found.mazes.length : 0) + Number(name.slice(1)) - 1;
    return mazeOf(found, at);
  } catch {
    return null;
  }
}
