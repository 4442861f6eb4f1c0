/** The order of the tasks of a lesson: which are open, and which one is next. */
import type { LessonDocument } from "@corridor/challenge";
import type { ChallengeState } from "../challenge/challenge-store.ts";

/**
 * @param solved which tasks are solved, by index
 * @param openTo number of the last task that the teacher of a class has opened; undefined: no limit
 */
export function isTaskOpen(
  { order }: Pick<LessonDocument, "order">,
  solved: readonly boolean[],
  index: number,
  openTo?: number,
): boolean {
  if (!isTaskOpened(index, openTo)) return false;
  if (order === "any" || index === 0) return true;
  return solved[index - 1] === true || solved[index] === true;
}

/** Whether the teacher of the class, if there is one, has opened the task. */
export function isTaskOpened(index: number, openTo?: number): boolean {
  return openTo === undefined || index < openTo;
}

/** The next open task that is not solved: after this one, otherwise from the first; null if none. */
export function nextTask(
  lesson: Pick<LessonDocument, "order" | "tasks">,
  solved: readonly boolean[],
  index: number,
  openTo?: number,
): number | null {
  const isNext = (at: number) => solved[at] !== true && isTaskOpen(lesson, solved, at, openTo);
  const indexes = [...lesson.tasks.keys()];
  const others = [...indexes.slice(index + 1), ...indexes.slice(0, index)];
  return others.find(isNext) ?? null;
}

/** The task after the open one of a stored lesson; null if no lesson is open, or all are solved. */
export function nextTaskOf({
  lesson,
  lessonId,
  solved,
  index,
  openTo,
}: ChallengeState): number | null {
  return lesson === null || lessonId === null ? null : nextTask(lesson, solved, index, openTo);
}
