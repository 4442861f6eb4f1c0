import type { Task } from "@corridor/challenge";
import { isSameLayout, type MazeDocument } from "@corridor/maze";

/**
 * Index of a given maze in its task, regardless of the name; null if the task does not contain it.
 */
export function mazeIndex({ mazes }: Pick<Task, "mazes">, maze: MazeDocument): number | null {
  const at = mazes.findIndex((each) => isSameLayout(each, maze));
  return at < 0 ? null : at;
}
