/**
 * Formats the results as a Markdown table: what was done, what must hold, what was measured.
 */
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
compares the histories of scripts, relay and robots. [CONTRIBUTING.md](../CONTRIBUTING.md#fault-scenario) describes how to
add a scenario.

- "lost", "doubled", "reordered" and "ended twice" count the commands in which the histories differ.
- "late" counts the commands that a robot started more than 100 ms after their time to live. The time to live starts with
  the first attempt. A message contains the age of its command, but not its transit time. Therefore, the time that the
  accepted attempt waited unread at its relay is added.
- A load above the number of processors means that other programs ran on the machine. Every time is then longer.

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
  return goals.map((goal, n) => {
    const { label, measured, bound, unit } = goal;
    const limit = "atMost" in bound ? `at most ${bound.atMost}` : `at least ${bound.atLeast}`;
    const verdict = isMet(goal) ? "pass" : "FAIL";
    return `| ${n === 0 ? title : ""} | ${cell(label)}: ${limit} | ${formatNumber(measured)} ${cell(unit)} | ${verdict} |`;
  });
}

function cell(text: string): string {
  return text.replaceAll("|", "\\|").replaceAll("\n", " ");
}
