/** A lesson of one task, as the benchmarks of checks and of the dashboard use it. */
import type { LessonDocument, LessonTask } from "@corridor/challenge";
import { lessonOfTasks, taskIn } from "@corridor/challenge/testing";
import type { MazeDocument } from "@corridor/maze";

export function benchLesson(
  name: string,
  maze: MazeDocument,
  unseen: LessonTask["unseen"] = null,
): LessonDocument {
  const checks = { bumps: 0, seconds: 600 };
  return lessonOfTasks(name, [taskIn([maze], { name, checks, unseen })]);
}
