/** Names the lessons of completion codes that belong to another one of this device. */
import { lessonMark } from "@corridor/challenge";
import { lessonName } from "../../model/lessons/lesson-name.ts";
import type { SavedLessons } from "../../model/teaching/saved-lessons.ts";
import type { HandInRow } from "./check-hand-ins.ts";

/** Whether a code among the rows belongs to another lesson. */
export function hasOtherLesson(rows: readonly HandInRow[]): boolean {
  return rows.some(({ checked }) => !checked.ok && checked.code === "other-lesson");
}

/**
 * @param hasOther see `hasOtherLesson`; without such a code, no lesson is read
 * @returns names by the mark of the lesson
 */
export function otherLessonNames(
  hasOther: boolean,
  lessons: Pick<SavedLessons, "list">,
): ReadonlyMap<string, string> {
  // The marks of all lessons take time to calculate.
  if (!hasOther) return new Map();
  return new Map(
    lessons
      .list()
      .map(({ lesson }) => [lessonMark(lesson), lessonName(lesson)] as const)
      .filter(([, name]) => name.trim() !== ""),
  );
}
