/**
 * Whether a program is the student's own. The example and ready-made algorithms are not: a maze that is
 * opened without a program opens with an empty one in their place, so that there is something to solve.
 */
import { emptyProgram, programPresets, type ProgramDocument } from "@corridor/program";
import type { i18n } from "i18next";
import { languages } from "../../text/languages.ts";

/** Empty programs and unchanged ready-made ones, under the names that they were given, are nobody's own. */
export function isOwnProgram(program: ProgramDocument, words: Pick<i18n, "t">): boolean {
  return !isEmpty(program) && !isReadyMade(program, words);
}

/**
 * An edited program under the name that it goes on with: a ready-made one whose lines were changed is no
 * longer what its name says. A name that the student gave stays.
 */
export function namedAfterEdit(
  before: ProgramDocument,
  after: ProgramDocument,
  words: Pick<i18n, "t">,
): ProgramDocument {
  if (after.name === "" || after.name !== before.name) return after;
  if (behaviourOf(after) === behaviourOf(before) || !isReadyMade(before, words)) return after;
  return { ...after, name: words.t("program.own") };
}

function isReadyMade(program: ProgramDocument, words: Pick<i18n, "t">): boolean {
  return readyMadeName(program, words) !== null;
}

/**
 * The name of a ready-made program in the reader's language; null for any other program. The program may have
 * got its name in a language from before: each one that the page has loaded counts.
 */
export function readyMadeName(program: ProgramDocument, words: Pick<i18n, "t">): string | null {
  const behaviour = behaviourOf(program);
  // A student may have found the same lines alone, in a program of another name.
  for (const { id, program: preset } of programPresets) {
    if (behaviour !== behaviourOf(preset)) continue;
    for (const { tag } of languages) {
      if (program.name === words.t("program.example", { lng: tag })) {
        return words.t("program.example");
      }
      const name = words.t(`program.preset.${id}.name`, { lng: tag });
      if (program.name === name || program.name === preset.name) {
        return words.t(`program.preset.${id}.name`);
      }
    }
  }
  return null;
}

/**
 * The program for a maze that comes without one: null for the student's own, else an empty one. One that
 * is empty already keeps its name.
 */
export function programForMaze(
  program: ProgramDocument,
  words: Pick<i18n, "t">,
): ProgramDocument | null {
  if (isOwnProgram(program, words)) return null;
  return emptyProgram(isEmpty(program) ? program.name : "");
}

function isEmpty(program: ProgramDocument): boolean {
  return behaviourOf(program) === behaviourOf(emptyProgram());
}

function behaviourOf({ default: otherwise, rules }: ProgramDocument): string {
  return JSON.stringify([otherwise, rules]);
}
