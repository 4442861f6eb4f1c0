/**
 * Formats the results as Markdown: each scenario, its goals and the measured values.
 */
import { faultKinds } from "../../apps/relay/src/testing/faults/history.ts";
import { formatNumber, isMet, type Goal } from "../../benches/core/goals.ts";

export interface Result {
  title: string;
  description: string;
  /** null when the scenario itself failed; then `fault` is the reason */
  goals: readonly Goal[] | null;
  fault?: string;
  seconds: number;
  /** load average of the machine in the last minute */
  load: number;
}

export interface RunInfo {
  /** date of the run, such as 2026-11-22 */
  date: string;
  machine: string;
  versions: string;
  isLong: boolean;
  seed: number;
}

/** Whether the scenario ran to its end and met all goals. */
export function passes({ goals }: Result): boolean {
  return goals !== null && goals.every(isMet);
}

export function reportOf(results: readonly Result[], about: RunInfo): string {
  const lines = results.flatMap(linesOf);
  return `# Fault tests

\`npm run test:faults${about.isLong ? " -- --long" : ""}\` runs each scenario with real processes and sockets, injects faults, and
compares what scripts, relay and robots recorded. [CONTRIBUTING.md](../CONTRIBUTING.md#fault-scenario) describes how to
add a scenario.

| Fault | Commands that it counts |
| --- | --- |
| lost | acknowledged but not stored, or without a final state |
| doubled | started more than once |
| reordered | started after a command with a higher number |
| ended twice | with two different final states, or expired and started |
| late | started more than 100 ms after their time to live, counted from the first attempt |

If a script sends no clock value, the relay cannot measure transit times: "late" then excludes the transit time of the
accepted attempt. A load above the number of processors means that other programs ran on the machine, which makes every
time longer.

## Results

${about.date}, ${about.machine}; ${about.versions}; seed ${about.seed}; ${about.isLong ? "long" : "short"} run.
${results.filter(passes).length} of ${results.length} scenarios pass.

| Scenario | Goal | Measured | Result |
| --- | --- | --- | --- |
${lines.join("\n")}

## Scenarios

${results.map(lineAbout).join("\n")}
`;
}

function lineAbout({ title, description: does, seconds, load }: Result): string {
  return `- **${title}** (${Math.round(seconds)} s, load ${load.toFixed(1)}): ${does}.`;
}

function linesOf({ title, goals, fault }: Result): string[] {
  if (goals === null) return [`| ${title} | runs to its end | ${cell(fault ?? "")} | FAIL |`];
  return withoutRepetition(goals).map((goal, n) => {
    const { label, measured, bound, unit } = goal;
    const limit = "atMost" in bound ? `at most ${bound.atMost}` : `at least ${bound.atLeast}`;
    const verdict = isMet(goal) ? "pass" : "FAIL";
    return `| ${n === 0 ? title : ""} | ${cell(label)}: ${limit} | ${formatNumber(measured)} ${cell(unit)} | ${verdict} |`;
  });
}

/** Merges the goals for kinds of faults with equal results, which would fill most of the table. */
function withoutRepetition(goals: readonly Goal[]): Goal[] {
  const merged: Goal[] = [];
  for (const goal of goals) {
    const kind = faultKinds.find((each) => goal.label === `commands ${each}`);
    const last = merged.at(-1);
    const isRepeated =
      last !== undefined && last.label.startsWith("commands ") && last.measured === goal.measured;
    if (kind !== undefined && isRepeated) {
      merged[merged.length - 1] = { ...last, label: `${last.label}, ${kind}` };
    } else merged.push(goal);
  }
  return merged;
}

function cell(text: string): string {
  return text.replaceAll("|", "\\|").replaceAll("\n", " ");
}
