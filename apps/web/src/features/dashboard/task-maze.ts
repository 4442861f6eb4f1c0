import { mazeOf, type LessonDocument } from "@corridor/challenge";
import type { MazeDocument } from "@corridor/maze";

/**
 * A maze of a task by its name in tiles: given maze 1 is "g1", unseen maze 31 is "u31".
 * @param task from 1
 * @returns the first maze of the task if it has none with this name; null without such a task
 */
export function taskMaze(lesson: LessonDocument, task: number, name: string): MazeDocument | null {
  const found = lesson.tasks[task - 1];
  if (found === undefined) return null;
  try {
    const at = (name.startsWith("u") ? found.mazes.length : 0) + Number(name.slice(1)) - 1;
    return mazeOf(found, at);
  } catch {
    // The claim of a page: the task has no such maze.
    return found.mazes[0] ?? null;
  }
}
