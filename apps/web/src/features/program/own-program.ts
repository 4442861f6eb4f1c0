/**
 * Whether a program is the student's own. The example and ready-made algorithms are not: a maze that is
 * opened without a program opens with an empty one in their place, so that there is something to solve.
 */
import { emptyProgram, programPresets, type ProgramDocument } from "@corridor/program";
import type { i18n } from "i18next";

/** Empty programs and unchanged ready-made ones, under the names that they were given, are nobody's own. */
export function isOwnProgram(program: ProgramDocument, words: Pick<i18n, "t">): boolean {
  if (isEmpty(program)) return false;
  const behaviour = behaviourOf(program);
  // A student may have found the same lines alone, in a program of another name.
  return !programPresets.some(({ id, program: preset }) => {
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
