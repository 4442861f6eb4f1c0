/** The name of a student as text. */
import type { StudentName } from "@corridor/protocol";
import { studentWords } from "./student-names.ts";

/** @returns the pseudonym from the teacher, or the word of the list */
export function studentNameText({ text, word }: StudentName): string {
  return text ?? studentWords[word ?? 0] ?? "";
}
