/**
 * Whether a program is the student's own. The example and ready-made algorithms are not: a maze that is
 * opened without a program opens with an empty one in their place, so that there is something to solve.
 */
import { emptyProgram, programPresets, type ProgramDocument } from "@corridor/program";
import type { i18n } from "i18next";

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
  const behaviour = behaviourOf(program);
  // A student may have found the same lines alone, in a program of another name.
  return programPresets.some(({ id, program: preset }) => {
    const name = words.t(`program.preset.${id}.name`);
    const names = [preset.name, name, words.t("program.example")];
    return behaviour === behaviourOf(preset) && names.includes(program.name);
  });
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
