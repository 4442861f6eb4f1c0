/**
 * A teacher's lesson as the device stores it: the text of its link if it has one, otherwise JSON. A
 * lesson that contradicts itself, such as a maze without the goal to reach, has no link.
 */
import {
  MAX_CHALLENGE_TEXT_LENGTH,
  parseLesson,
  readLessonDraft,
  type LessonDocument,
} from "@corridor/challenge";
import { readLessonText, writeLessonText } from "../lessons/lesson-text.ts";

/** @throws RangeError if the lesson is too large to be read again */
export function writeDraft(lesson: LessonDocument): string {
  if (parseLesson(lesson).ok) return writeLessonText(lesson);
  const text = JSON.stringify(lesson);
  if (text.length > MAX_CHALLENGE_TEXT_LENGTH) throw new RangeError("The lesson is too large.");
  return text;
}

/** @returns null if the text is not a lesson */
export function readDraft(text: string): LessonDocument | null {
  const read = text.startsWith("{") ? readLessonDraft(text) : null;
  return read?.ok === true ? read.value : readLessonText(text);
}
