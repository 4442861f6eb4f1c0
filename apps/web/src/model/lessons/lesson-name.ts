import type { LessonDocument } from "@corridor/challenge";

/** The name of a lesson: a lesson of one task often has none of its own. May be empty. */
export function lessonName({ name, tasks }: LessonDocument): string {
  return name === "" && tasks.length === 1 ? (tasks[0]?.name ?? "") : name;
}
