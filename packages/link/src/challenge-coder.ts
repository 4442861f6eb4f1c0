/** Codes a challenge as bits: a task whose texts and mazes are coded one by one. */
import type { Choices } from "./choices.ts";
import { codeMaze } from "./maze-coder.ts";
import { codeName } from "./name-coder.ts";
import { NumberModel, RealModel } from "./numbers.ts";
import { codeProgram } from "./program-coder.ts";
import type { BitCoder } from "./range-coder.ts";
import { codeBit, codeIndices, codeTask, type TaskFields, type TaskPart } from "./task-coder.ts";

/**
 * Encodes or decodes a challenge.
 * @param challenge the challenge to encode; a decoder ignores it, and its caller passes any valid
 *   one
 * @param onPart called after each part, in order
 * @returns the decoded fields, not yet checked by a schema; null if the bits cannot come from an
 *   encoder
 */
export function codeChallenge(
  coder: BitCoder,
  challenge: TaskFields,
  choices: Choices,
  onPart: (part: TaskPart) => void = () => undefined,
): TaskFields | null {
  return codeTask(coder, challenge, {
    numbers: new NumberModel(),
    reals: new RealModel(),
    text: (text, maxLength) => codeName(coder, text, maxLength, choices.isPlainName(text)),
    maze: (maze, taskName) => {
      // Most mazes have the name of their challenge.
      const isNamed = codeBit(coder, maze.name !== taskName);
      const read = codeMaze(coder, isNamed ? maze : { ...maze, name: "" }, choices);
      return read === null || isNamed ? read : { ...read, name: taskName };
    },
    program: (program) => codeProgram(coder, program, choices.isPlainName(program.name)),
    indices: (names, chosen) => codeIndices(coder, names.length, chosen),
    onPart,
  });
}
