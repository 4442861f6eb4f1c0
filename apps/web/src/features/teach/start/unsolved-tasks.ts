/** The tasks of a lesson that the teacher has not solved on this device. Pure. */
import type { LessonDocument } from "@corridor/challenge";
import type { SavedLesson } from "../../../model/teaching/saved-lessons.ts";
import { solutionOf } from "../../../model/teaching/solution.ts";

/** @returns their numbers, from 1 */
export function unsolvedTasks(
  { tasks }: LessonDocument,
  saved: readonly Pick<SavedLesson, "solutions">[],
): number[] {
  return tasks.flatMap((task, at) =>
    saved.some(({ solutions }) => solutionOf(solutions, task) !== null) ? [] : [at + 1],
  );
}
