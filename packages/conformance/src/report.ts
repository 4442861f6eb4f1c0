/** The report of a run as text: one line per check, and a summary to publish. */
import { PROTOCOL_VERSION } from "@corridor/protocol";
import type { Outcome, Result } from "./run-checks.ts";

const marks: Record<Outcome["kind"], string> = {
  passed: "ok",
  failed: "FAILED",
  "not offered": "not offered",
  "not testable": "not testable here",
};
const WIDTH = Math.max(...Object.values(marks).map((mark) => mark.length));

/** The result of one check with the id of its promise, and the reason for its outcome. */
export function linesOf({ promise, check, outcome }: Result): string[] {
  const lines = [`  ${marks[outcome.kind].padEnd(WIDTH)}  ${promise}: ${check}`];
  const more = (text: string) => lines.push(`  ${" ".repeat(WIDTH)}  ${text}`);
  if (outcome.kind === "failed") {
    more(`expected: ${outcome.expected}`);
    more(`found:    ${outcome.found}`);
    if (outcome.isLast === true) more("The other checks need this one, so the run ends here.");
  } else if (outcome.kind === "not offered") {
    more(`${outcome.feature}: ${outcome.why}`);
  } else if (outcome.kind === "not testable") {
    more(outcome.why);
  }
  return lines;
}

/** Whether no check failed, and each check that a run can test was tested or is not offered. */
export function passes(results: readonly Result[]): boolean {
  return results.every(({ outcome }) =>
    outcome.kind === "not testable" ? outcome.isNever : outcome.kind !== "failed",
  );
}

/** @param date of the run, in the format `2026-11-25` */
export function verdict(results: readonly Result[], date: string): string {
  const of = (kind: Outcome["kind"]) => results.filter(({ outcome }) => outcome.kind === kind);
  const failed = of("failed").length;
  const word = passes(results) ? "PASSED" : failed > 0 ? "FAILED" : "INCOMPLETE";
  const features = new Set(
    results.flatMap(({ outcome }) => (outcome.kind === "not offered" ? [outcome.feature] : [])),
  );
  const which = features.size > 0 ? ` (${[...features].join(", ")})` : "";
  return [
    `Corridor conformance, protocol ${PROTOCOL_VERSION}, ${date}: ${word}`,
    `${of("passed").length} passed`,
    `${failed} failed`,
    `${of("not offered").length} not offered${which}`,
    `${of("not testable").length} not testable here`,
  ].join(", ");
}
