/** Equality of programs, for documents that were copied, such as between threads or by storage. */
import type { Condition, ProgramDocument, Rule } from "./program-document.ts";

/** Whether two programs have the same lines and default. Names may be in another language. */
export function isSameBehaviour(one: ProgramDocument, other: ProgramDocument): boolean {
  if (one === other) return true;
  const { rules } = other;
  return (
    one.default === other.default &&
    one.rules.length === rules.length &&
    one.rules.every((rule, at) => {
      const same = rules[at];
      return same !== undefined && isSameRule(rule, same);
    })
  );
}

/** The same with equal names. */
export function isSameProgram(one: ProgramDocument, other: ProgramDocument): boolean {
  return one.name === other.name && isSameBehaviour(one, other);
}

/** Whether two lines have the same condition and action. */
export function isSameRule(one: Rule, other: Rule): boolean {
  return one.do === other.do && isSameCondition(one.when, other.when);
}

export function isSameCondition(one: Condition | null, other: Condition | null): boolean {
  if (one === null || other === null) return one === other;
  if (one.sensor !== other.sensor || one.is !== other.is || one.than !== other.than) return false;
  return one.than !== "right" || (other.than === "right" && one.plus === other.plus);
}
