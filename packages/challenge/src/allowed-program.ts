/**
 * Checks a program against the permissions of a task without running it: number of lines,
 * conditions, actions, and unchanged parts of the starting program.
 */
import { kindOf, numberOf, type ProgramDocument, type Rule } from "@corridor/program";
import { rightsOf, type Rights } from "./rights.ts";
import type { Task } from "./task-schema.ts";
import type { Failure, FailureCode } from "./verdict.ts";

/** Returns the starting program of a task. */
export function startingProgram({ name, program }: Task): ProgramDocument {
  return program ?? { format: "corridor/program", version: 1, name, default: "forward", rules: [] };
}

/** Returns the first part of a program that the task does not allow, or null. */
export function findViolation(task: Task, program: ProgramDocument): Failure | null {
  const rights = rightsOf(task);
  if (!rights.drivers.includes("program")) return failure("driver", null);
  const found = program.rules.length;
  if (found > rights.maxLines) {
    return { ...failure("too-many-lines", rights.maxLines), needed: rights.maxLines, found };
  }
  const start = startingProgram(task);
  if (!rights.edits.has("otherwise") && program.default !== start.default) {
    return failure("changed", "default");
  }
  const changed = changedLine(start.rules, program.rules, rights);
  if (changed !== null) return failure("changed", changed);
  // Conditions and actions of the starting program are always allowed, even if they are not listed.
  const givenActions = new Set([start.default, ...start.rules.map((rule) => rule.do)]);
  const givenKinds = new Set(start.rules.map(({ when }) => when && kindOf(when)));
  for (const [line, rule] of program.rules.entries()) {
    const kind = rule.when && kindOf(rule.when);
    if (kind !== null && !rights.conditions.includes(kind) && !givenKinds.has(kind)) {
      return failure("condition-not-allowed", line);
    }
    if (!rights.actions.includes(rule.do) && !givenActions.has(rule.do)) {
      return failure("action-not-allowed", line);
    }
  }
  if (!rights.actions.includes(program.default) && !givenActions.has(program.default)) {
    return failure("action-not-allowed", "default");
  }
  return null;
}

/** Returns the first line with a change in a part that must not change, or null. */
function changedLine(
  given: readonly Rule[],
  rules: readonly Rule[],
  { edits }: Rights,
): number | null {
  if (edits.has("lines")) return null;
  const fixed = (rule: Rule | undefined): string => fixedParts(rule, edits);
  if (!edits.has("order")) {
    const length = Math.max(given.length, rules.length);
    for (let line = 0; line < length; line++) {
      if (fixed(given[line]) !== fixed(rules[line])) return line;
    }
    return null;
  }
  const unmatched = given.map(fixed);
  for (const [line, rule] of rules.entries()) {
    const at = unmatched.indexOf(fixed(rule));
    if (at < 0) return line;
    unmatched.splice(at, 1);
  }
  return unmatched.length === 0 ? null : rules.length;
}

/** Serialises the parts of a line that must not change, for comparison. */
function fixedParts(rule: Rule | undefined, edits: Rights["edits"]): string {
  if (rule === undefined) return "none";
  const { when } = rule;
  const kind = when === null ? "nothing" : `${when.sensor} ${when.is} ${when.than === "right"}`;
  return [
    edits.has("condition") ? "" : kind,
    edits.has("number") || (edits.has("condition") && when === null) ? "" : when && numberOf(when),
    edits.has("action") ? "" : rule.do,
  ].join("|");
}

function failure(code: FailureCode, line: Failure["line"]): Failure {
  return {
    code,
    line,
    maze: null,
    tick: null,
    place: null,
    needed: null,
    found: null,
    decision: null,
  };
}
