/** Saves the open lesson as a file, in the oldest version that holds it. This module is a separate chunk. */
import { oldestDocumentOf, type LessonDocument } from "@corridor/challenge";
import { saveDocument } from "../../ui/save-file.ts";

export function saveLesson(lesson: LessonDocument): void {
  saveDocument(oldestDocumentOf(lesson), "lesson");
}
