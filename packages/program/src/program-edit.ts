/**
 * Edits of a program: document in, document out. Pure, so that undo is keeping the old document;
 * untouched rules are shared between the two, and an edit that changes nothing gives back the very
 * same document. An edit that would break the document is refused with a code, never an exception:
 * the page turns the code into a sentence.
 */
import type { PlainAction } from "@corridor/protocol";
import { conditionOf, numberOf, numberRange, kindOf } from "./condition-parts.ts";
import type { Condition, ProgramDocument, Rule } from "./program-document.ts";
import {
  DEFAULT_ACTION,
  DEFAULT_NUMBER,
  MAX_NAME_LENGTH,
  MAX_RULES,
  type ConditionKind,
} from "./vocabulary.ts";

/** Why an edit was refused. */
export type ProgramRefusal =
  /** the program has as many rules as a document can hold */
  | "too-many-rules"
  /** there is no rule at this place */
  | "no-such-rule"
  /** a line that does nothing has no number */
  | "no-condition"
  /** the number is not one, or out of the range of its condition */
  | "bad-number"
  /** the name is longer than a document can hold */
  | "name-too-long";

export type ProgramEdit =
  | { ok: true; program: ProgramDocument }
  | { ok: false; code: ProgramRefusal };

/** Adds a line `[Do nothing]` at the end; refused as "too-many-rules". */
export function addRule(program: ProgramDocument): ProgramEdit {
  if (program.rules.length >= MAX_RULES) return refuse("too-many-rules");
  return accept({ ...program, rules: [...program.rules, { when: null, do: DEFAULT_ACTION }] });
}

/** Takes a line away; refused as "no-such-rule". */
export function removeRule(program: ProgramDocument, index: number): ProgramEdit {
  if (program.rules[index] === undefined) return refuse("no-such-rule");
  return accept({ ...program, rules: program.rules.filter((_, at) => at !== index) });
}

/**
 * Moves a line up or down, at most to the first or last place.
 * @param by places, negative is up
 * @returns refused as "no-such-rule"
 */
export function moveRule(program: ProgramDocument, index: number, by: number): ProgramEdit {
  const rule = program.rules[index];
  if (rule === undefined) return refuse("no-such-rule");
  const place = Math.max(0, Math.min(program.rules.length - 1, index + Math.trunc(by)));
  if (place === index) return accept(program);
  const others = program.rules.filter((_, at) => at !== index);
  return accept({ ...program, rules: others.toSpliced(place, 0, rule) });
}

/**
 * Chooses another condition for a line and keeps its number as near as the new kind allows; a line
 * that did nothing starts with 50.
 * @param kind null is `[Do nothing]`
 * @returns refused as "no-such-rule"
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

/** Changes the number of a line; refused as "no-such-rule", "no-condition" or "bad-number". */
export function setNumber(program: ProgramDocument, index: number, number: number): ProgramEdit {
  return changeRule(program, index, (rule) => {
    if (rule.when === null) return "no-condition";
    const kind = kindOf(rule.when);
    const { min, max } = numberRange(kind);
    // Written so that NaN is refused too.
    if (!(number >= min && number <= max)) return "bad-number";
    return numberOf(rule.when) === number ? rule : { ...rule, when: conditionOf(kind, number) };
  });
}

/** Changes what a line does; refused as "no-such-rule". */
export function setAction(
  program: ProgramDocument,
  index: number,
  action: PlainAction,
): ProgramEdit {
  return changeRule(program, index, (rule) =>
    rule.do === action ? rule : { ...rule, do: action },
  );
}

/** Changes what the robot does when no line is true. */
export function setDefault(program: ProgramDocument, action: PlainAction): ProgramDocument {
  return program.default === action ? program : { ...program, default: action };
}

/** Gives the program another name, which may be empty; refused as "name-too-long". */
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

function isSameCondition(a: Condition | null, b: Condition): boolean {
  return a !== null && kindOf(a) === kindOf(b) && numberOf(a) === numberOf(b);
}
