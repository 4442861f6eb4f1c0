import {
  moveRule,
  removeRule,
  setAction,
  setDefault,
  setNumber,
  type ProgramDocument,
  type ProgramEdit,
} from "@corridor/program";
import type { Fix } from "./advice.ts";

/**
 * Applies a fix to the program of its advice.
 * @returns the changed document
 * @throws RangeError if the fix does not fit the program
 */
export function applyFix(program: ProgramDocument, fix: Fix): ProgramDocument {
  switch (fix.kind) {
    case "action":
      return fix.line === "default"
        ? setDefault(program, fix.action)
        : accepted(setAction(program, fix.line, fix.action));
    case "number":
      return accepted(setNumber(program, fix.line, fix.number));
    case "condition":
      return withCondition(program, fix);
    case "move":
      return accepted(moveRule(program, fix.line, fix.to - fix.line));
    case "delete":
      return accepted(removeRule(program, fix.line));
    case "insert":
      return { ...program, rules: program.rules.toSpliced(fix.at, 0, fix.rule) };
  }
}

function withCondition(
  program: ProgramDocument,
  { line, when }: Extract<Fix, { kind: "condition" }>,
): ProgramDocument {
  const rule = program.rules[line];
  if (rule === undefined) throw new RangeError(`The program has no line at ${line}.`);
  return { ...program, rules: program.rules.with(line, { ...rule, when }) };
}

function accepted(edit: ProgramEdit): ProgramDocument {
  if (!edit.ok) throw new RangeError(`The fix does not fit the program: ${edit.code}.`);
  return edit.program;
}
