/** Mends taken: document in, document out, like every edit of a program. */
import {
  moveRule,
  removeRule,
  setAction,
  setDefault,
  setNumber,
  type ProgramDocument,
  type ProgramEdit,
} from "@corridor/program";
import type { Mend } from "./advice.ts";

/**
 * Puts a mend into the program that its advice was given for.
 * @throws RangeError when the mend does not fit the program, such as one of another document
 */
export function applyMend(program: ProgramDocument, mend: Mend): ProgramDocument {
  switch (mend.kind) {
    case "action":
      return mend.line === "default"
        ? setDefault(program, mend.action)
        : accepted(setAction(program, mend.line, mend.action));
    case "number":
      return accepted(setNumber(program, mend.line, mend.number));
    case "condition":
      return withCondition(program, mend);
    case "move":
      return accepted(moveRule(program, mend.line, mend.to - mend.line));
    case "delete":
      return accepted(removeRule(program, mend.line));
    case "insert":
      return { ...program, rules: program.rules.toSpliced(mend.at, 0, mend.rule) };
  }
}

function withCondition(
  program: ProgramDocument,
  { line, when }: Extract<Mend, { kind: "condition" }>,
): ProgramDocument {
  const rule = program.rules[line];
  if (rule === undefined) throw new RangeError(`The program has no line at ${line}.`);
  return { ...program, rules: program.rules.with(line, { ...rule, when }) };
}

function accepted(edit: ProgramEdit): ProgramDocument {
  if (!edit.ok) throw new RangeError(`The mend does not fit the program: ${edit.code}.`);
  return edit.program;
}
