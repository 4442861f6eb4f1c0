/**
 * A lesson as the device stores it: the text of its link if it fits into one, otherwise JSON. Ten
 * large mazes take 173 characters in a link, and almost 1 MB as JSON.
 */
import { oldestDocumentOf, readLesson, type LessonDocument } from "@corridor/challenge";
import { decodeLink, encodeLink } from "@corridor/link";

export function writeLessonText(lesson: LessonDocument): string {
  const link = encodeLink({ lesson });
  return link.ok ? link.text : JSON.stringify(oldestDocumentOf(lesson));
}

/** @returns null if the text is neither a link with a lesson nor a lesson as JSON */
export function readLessonText(text: string): LessonDocument | null {
  if (text.startsWith("{")) {
    const read = readLesson(text);
    return read.ok ? read.value : null;
  }
  const link = decodeLink(text);
  return link.ok ? (link.value.lesson ?? null) : null;
}
