/**
 * Whether a program is the student's own. The example and presets are not. A maze that is opened
 * without a program replaces them with an empty one, so that there is something to solve.
 */
import {
  isSameBehaviour,
  emptyProgram,
  programPresets,
  type ProgramDocument,
} from "@corridor/program";
import type { i18n } from "i18next";
import { languages } from "../../text/languages.ts";

/** Empty programs, and unchanged presets under their given names, are not the student's own. */
export function isOwnProgram(program: ProgramDocument, words: Pick<i18n, "t">): boolean {
  return !isEmpty(program) && !isReadyMade(program, words);
}

/**
 * The edited program, with a new name if a preset's lines changed and its old name no longer fits.
 * A name that the student chose stays.
 */
export function namedAfterEdit(
  before: ProgramDocument,
  after: ProgramDocument,
  words: Pick<i18n, "t">,
): ProgramDocument {
  if (after.name === "" || after.name !== before.name) return after;
  if (isSameBehaviour(after, before) || !isReadyMade(before, words)) return after;
  return { ...after, name: words.t("program.own") };
}

function isReadyMade(program: ProgramDocument, words: Pick<i18n, "t">): boolean {
  return readyMadeName(program, words) !== null;
}

/**
 * The name of a preset in the student's language; null for any other program. The program may still
 * have its name in an earlier language, so every loaded language counts.
 */
export function readyMadeName(program: ProgramDocument, words: Pick<i18n, "t">): string | null {
  // A student may have found the same lines alone, in a program with another name.
  for (const { id, program: preset } of programPresets) {
    if (!isSameBehaviour(program, preset)) continue;
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
 * The program for a maze that comes without one: null for the student's own, otherwise an empty
 * one. A program that is already empty retains its name.
 */
export function programForMaze(
  program: ProgramDocument,
  words: Pick<i18n, "t">,
): ProgramDocument | null {
  if (isOwnProgram(program, words)) return null;
  return emptyProgram(isEmpty(program) ? program.name : "");
}

function isEmpty(program: ProgramDocument): boolean {
  return isSameBehaviour(program, emptyProgram());
}
