/**
 * Edits of a program as pure functions from document to document, so that undo restores the
 * previous document. Both documents share unchanged rules. An edit without effect returns the same
 * object. An edit that would make the document invalid returns a code, which the page translates.
 */
import type { PlainAction } from "@corridor/protocol";
import { conditionOf, numberOf, numberRange, kindOf } from "./condition-parts.ts";
import type { ProgramDocument, Rule } from "./program-document.ts";
import { isSameCondition } from "./same-program.ts";
import {
  DEFAULT_ACTION,
  DEFAULT_NUMBER,
  MAX_NAME_LENGTH,
  MAX_RULES,
  type ConditionKind,
} from "./vocabulary.ts";

/** Why an edit was refused. */
export type ProgramRefusal =
  /** the program already has the maximum number of rules */
  | "too-many-rules"
  /** no rule has this index */
  | "no-such-rule"
  /** a `[Do nothing]` line has no number */
  | "no-condition"
  /** the number is NaN or outside the range of its condition */
  | "bad-number"
  /** the name exceeds the maximum length */
  | "name-too-long";

export type ProgramEdit =
  | { ok: true; program: ProgramDocument }
  | { ok: false; code: ProgramRefusal };

/** Appends a `[Do nothing]` line. Returns the code "too-many-rules" if the program is full. */
export function addRule(program: ProgramDocument): ProgramEdit {
  if (program.rules.length >= MAX_RULES) return refuse("too-many-rules");
  return accept({ ...program, rules: [...program.rules, { when: null, do: DEFAULT_ACTION }] });
}

/** Removes a line. Returns the code "no-such-rule" if the index does not exist. */
export function removeRule(program: ProgramDocument, index: number): ProgramEdit {
  if (program.rules[index] === undefined) return refuse("no-such-rule");
  return accept({ ...program, rules: program.rules.filter((_, at) => at !== index) });
}

/**
 * Moves a line up or down, at most to the first or last position.
 * @param by number of positions, negative for up
 * @returns the edit, or the code "no-such-rule"
 */
export function moveRule(program: ProgramDocument, index: number, by: number): ProgramEdit {
  const rule = program.rules[index];
  if (rule === undefined) return refuse("no-such-rule");
  const target = Math.max(0, Math.min(program.rules.length - 1, index + Math.trunc(by)));
  if (target === index) return accept(program);
  const others = program.rules.filter((_, at) => at !== index);
  return accept({ ...program, rules: others.toSpliced(target, 0, rule) });
}

/**
 * Changes the condition of a line. The number is clamped to the range of the new kind. A
 * `[Do nothing]` line gets the number 50.
 * @param kind null for `[Do nothing]`
 * @returns the edit, or the code "no-such-rule"
 */
export function setCondition(
  program: ProgramDocument,
  index: number,
  kind: ConditionKind | null,
): ProgramEdit {
  return changeRule(program, index, (rule) => {
    if (kind === null) return rule.when === null ? rule : { ...rule, when: null };
    const { min, max } = numberRange(kind);
    const number = rule.when === null ? DEFAULT_NUMBER : numberOf(rule.when);
    const when = conditionOf(kind, Math.max(min, Math.min(max, number)));
    return isSameCondition(rule.when, when) ? rule : { ...rule, when };
  });
}

/** Changes the number of a line. Codes: "no-such-rule", "no-condition", "bad-number". */
export function setNumber(program: ProgramDocument, index: number, number: number): ProgramEdit {
  return changeRule(program, index, (rule) => {
    if (rule.when === null) return "no-condition";
    const kind = kindOf(rule.when);
    const { min, max } = numberRange(kind);
    // The negated form also refuses NaN.
    if (!(number >= min && number <= max)) return "bad-number";
    return numberOf(rule.when) === number ? rule : { ...rule, when: conditionOf(kind, number) };
  });
}

/** Changes the action of a line. Returns the code "no-such-rule" if the index does not exist. */
export function setAction(
  program: ProgramDocument,
  index: number,
  action: PlainAction,
): ProgramEdit {
  return changeRule(program, index, (rule) =>
    rule.do === action ? rule : { ...rule, do: action },
  );
}

/** Changes the default action, which runs when no line is true. */
export function setDefault(program: ProgramDocument, action: PlainAction): ProgramDocument {
  return program.default === action ? program : { ...program, default: action };
}

/**
 * Renames the program. The name may be empty. Returns the code "name-too-long" if it is too long.
 */
export function rename(program: ProgramDocument, name: string): ProgramEdit {
  if (name.length > MAX_NAME_LENGTH) return refuse("name-too-long");
  return accept(program.name === name ? program : { ...program, name });
}

function accept(program: ProgramDocument): ProgramEdit {
  return { ok: true, program };
}

function refuse(code: ProgramRefusal): ProgramEdit {
  return { ok: false, code };
}

function changeRule(
  program: ProgramDocument,
  index: number,
  change: (rule: Rule) => Rule | ProgramRefusal,
): ProgramEdit {
  const rule = program.rules[index];
  if (rule === undefined) return refuse("no-such-rule");
  const changed = change(rule);
  if (typeof changed === "string") return refuse(changed);
  if (changed === rule) return accept(program);
  return accept({ ...program, rules: program.rules.with(index, changed) });
}
