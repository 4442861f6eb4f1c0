/** Attempts as texts for the class: without names, and null if they are too long. */
import type { Attempt } from "@corridor/challenge";
import { encodeLink } from "@corridor/link";
import type { ProgramDocument } from "@corridor/program";
import { MAX_PROGRAM_LINK } from "@corridor/protocol";

/** A link with the program alone. */
export function programText(program: ProgramDocument): string | null {
  return textOf({ program: { ...program, name: "" } });
}

/** @param lesson mark of the lesson @param task index of the task */
export function completionText(lesson: string, task: number, attempt: Attempt): string | null {
  return textOf({ completion: { lesson, task, attempt } });
}

function textOf(content: Parameters<typeof encodeLink>[0]): string | null {
  const link = encodeLink(content);
  return link.ok && link.text.length <= MAX_PROGRAM_LINK ? link.text : null;
}
