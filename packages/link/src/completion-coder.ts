/**
 * Codes a completion code as bits, with one function for encoding and decoding: the mark of the
 * lesson, the task, and the program or the commands of a drive. Names are left out, because
 * they are not needed for the check and can be those of students.
 */
import { MARK_LENGTH, MAX_TASKS } from "@corridor/challenge";
import type { ProgramDocument } from "@corridor/program";
import type { TimedCommand } from "@corridor/protocol";
import { CommandCoder, TickModel } from "./command-coder.ts";
import type { CompletionCode } from "./completion-code.ts";
import { codeUniform, NumberModel } from "./numbers.ts";
import { placeholderProgram } from "./placeholders.ts";
import { codeLines } from "./program-coder.ts";
import type { BitCoder } from "./range-coder.ts";

/** Maximum number of commands of a drive. */
const MAX_COMMANDS = 4_096;
/** Hexadecimal digits that are coded together: their number, and that of their values. */
const DIGITS = 3;
const VALUES = 4_096;

/**
 * Encodes or decodes a completion code.
 * @param code the code to encode; a decoder ignores it, and its caller passes any valid one
 * @returns the decoded code, whose attempt is not yet checked by its schema; null if it exceeds the
 *   bounds of a code, or if the bits cannot come from an encoder
 */
export function codeCompletion(coder: BitCoder, code: CompletionCode): CompletionCode | null {
  let lesson = "";
  for (let at = 0; at < MARK_LENGTH; at += DIGITS) {
    const digits = Number.parseInt(code.lesson.slice(at, at + DIGITS), 16);
    lesson += codeUniform(coder, VALUES, digits).toString(16).padStart(DIGITS, "0");
  }
  const task = codeUniform(coder, MAX_TASKS, code.task);
  const { attempt } = code;
  const [program, commands] = "rules" in attempt ? [attempt, null] : [null, attempt];
  const isManual = coder.bit(3, 1, commands === null ? 0 : 1) === 1;
  const coded: ProgramDocument | TimedCommand[] | null = isManual
    ? codeCommands(coder, commands ?? [])
    : codeLines(coder, program ?? placeholderProgram);
  return coded && { lesson, task, attempt: coded };
}

function codeCommands(coder: BitCoder, commands: readonly TimedCommand[]): TimedCommand[] | null {
  const count = new NumberModel().code(coder, commands.length);
  if (count > MAX_COMMANDS) return null;
  const ticks = new TickModel();
  const models = new CommandCoder();
  const coded: TimedCommand[] = [];
  let tick = 0;
  for (let at = 0; at < count; at += 1) {
    const timed = commands[at];
    tick += ticks.code(coder, (timed?.tick ?? 0) - tick);
    const command = models.code(coder, timed?.command ?? { action: "stop" });
    if (command === null) return null;
    coded.push({ tick, command });
  }
  return coded;
}
