import type { LessonDocument } from "@corridor/challenge";
import type { MazeDocument } from "@corridor/maze";
import { tileMaze } from "../../simulator/protocol/tile-maze.ts";

/** The maze that a tile names, or the first one of the task; null without such a task. */
export function taskMaze(lesson: LessonDocument, task: number, name: string): MazeDocument | null {
  return tileMaze(lesson, task, name) ?? lesson.tasks[task - 1]?.mazes[0] ?? null;
}
