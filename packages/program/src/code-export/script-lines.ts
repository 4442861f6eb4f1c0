/**
 * A program as the decisions of a script. A program decides on every tick; a script receives a
 * reading some ticks later. So each forward and reverse gets `until`: the conditions that end it on
 * the first tick on which the program could choose another action.
 */
import {
  MAX_CONDITIONS,
  type LineRef,
  type PlainAction,
  type UntilCondition,
} from "@corridor/protocol";
import type { Condition, ProgramDocument } from "../program-document.ts";

/** A line of the program that can decide. */
export interface ScriptLine {
  line: LineRef;
  /** null for the default, which is always true */
  when: Condition | null;
  action: PlainAction;
  /**
   * For forward and reverse: a line above with another action is true, or this line no longer is.
   * The script adds that the robot has reached a goal. Null for the other actions, which end by
   * themselves.
   */
  until: readonly UntilComparison[] | null;
}

export type UntilComparison = Exclude<UntilCondition, { goal: true }>;

export type ScriptLines =
  | { ok: true; lines: readonly ScriptLine[] }
  /** the motion of `line` needs more conditions than the robot accepts */
  | { ok: false; line: LineRef; conditions: number };

/** Lines in the order of the document, without `[Do nothing]`; the default is the last one. */
export function scriptLines({ rules, default: otherwise }: ProgramDocument): ScriptLines {
  const lines: ScriptLine[] = [];
  const above: { when: Condition; action: PlainAction }[] = [];
  const all = [...rules.entries(), ["default", { when: null, do: otherwise }] as const];
  for (const [line, { when, do: action }] of all) {
    if (line !== "default" && when === null) continue;
    const until = isMotion(action) ? untilOf(action, when, above) : null;
    // The goal is one more condition.
    const conditions = (until?.length ?? 0) + 1;
    if (conditions > MAX_CONDITIONS) return { ok: false, line, conditions };
    lines.push({ line, when, action, until });
    if (when !== null) above.push({ when, action });
  }
  return { ok: true, lines };
}

/** Whether an action drives until another one is chosen, so that it needs `until`. */
function isMotion(action: PlainAction): boolean {
  return action === "forward" || action === "reverse";
}

function untilOf(
  action: PlainAction,
  when: Condition | null,
  above: readonly { when: Condition; action: PlainAction }[],
): UntilComparison[] {
  const others = above.filter((line) => line.action !== action).map((line) => line.when);
  return when === null ? others : [...others, negationOf(when)];
}

function negationOf(condition: Condition): UntilComparison {
  return { ...condition, is: condition.is === ">" ? "<=" : ">=" };
}
