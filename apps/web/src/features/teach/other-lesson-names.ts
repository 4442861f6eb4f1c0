/** Names the lessons of completion codes that belong to another one of this device. */
import { lessonMark } from "@corridor/challenge";
import { lessonName } from "../../model/lessons/lesson-name.ts";
import type { SavedLessons } from "../../model/teaching/saved-lessons.ts";
import type { HandInRow } from "./check-hand-ins.ts";

/** @returns names by the mark of the lesson, for the codes among the rows */
export function otherLessonNames(
  rows: readonly HandInRow[],
  lessons: Pick<SavedLessons, "list">,
): ReadonlyMap<string, string> {
  const hasOther = rows.some(({ checked }) => !checked.ok && checked.code === "other-lesson");
  // The marks of all lessons take time to calculate.
  if (!hasOther) return new Map();
  return new Map(
    lessons
      .list()
      .map(({ lesson }) => [lessonMark(lesson), lessonName(lesson)] as const)
      .filter(([, name]) => name.trim() !== ""),
  );
}
