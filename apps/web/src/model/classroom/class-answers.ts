/** Reads the responses of a class and writes its lessons. In a file that loads on first use. */
import { oldestDocumentOf, type LessonDocument } from "@corridor/challenge/document";
import {
  readJson,
  returnCodeSchema,
  studentProgramSchema,
  type ReturnCode,
  type StudentProgram,
} from "@corridor/protocol";

const MAX_ANSWER = 16 * 1_024;

/** null: another Corridor's response */
export function readReturnCode(text: string): ReturnCode | null {
  const read = readJson(returnCodeSchema, text, MAX_ANSWER);
  return read.ok ? read.value : null;
}

/** null: another Corridor's response */
export function readStudentProgram(text: string): StudentProgram | null {
  const read = readJson(studentProgramSchema, text, MAX_ANSWER);
  return read.ok ? read.value : null;
}

export function lessonBody(lesson: LessonDocument): object {
  return oldestDocumentOf(lesson);
}
