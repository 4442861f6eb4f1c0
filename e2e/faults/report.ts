/**
 * What a run of the rows found, as a table in Markdown: what was done, what must hold, what was
 * measured.
 */
import { formatNumber, isMet, type Goal } from "../../benches/core/goals.ts";

export interface Judged {
  title: string;
  does: string;
  /** null where the row itself failed; then `fault` says how */
  goals: readonly Goal[] | null;
  fault?: string;
  seconds: number;
  /** average of the machine in its last minute */
  load: number;
}

export interface Circumstances {
  /** of the run, such as 2026-11-22 */
  date: string;
  machine: string;
  versions: string;
  isLong: boolean;
  seed: number;
}

/** Whether everything holds. */
export function holds({ goals }: Judged): boolean {
  return goals !== null && goals.every(isMet);
}

export function reportOf(rows: readonly Judged[], about: Circumstances): string {
  const lines = rows.flatMap(linesOf);
  return `# What breaks, and what holds

Written by \`npm run test:faults${about.isLong ? " -- --long" : ""}\`: real processes and sockets, with faults.
Histories of scripts, relay and robots are compared: "lost", "doubled", "reordered", "ended twice" and "late" count
commands for which they differ, or that a robot began more than 100 ms after their time to live. That is counted from
the first try; what the try that was taken waited unread before its relay, as on a machine with too much to do, comes
on top: a message says how old its command is, and nobody can say how long it was on its way. A load above the number of
processors means that others were at work on the machine, which makes every time longer. How to add a row:
[CONTRIBUTING.md](../CONTRIBUTING.md).

${about.date}, ${about.machine}; ${about.versions}; seed ${about.seed}; ${about.isLong ? "long" : "short"} run.
${rows.filter(holds).length} of ${rows.length} rows hold.

| row | what must hold | measured | |
| --- | --- | --- | --- |
${lines.join("\n")}

${rows.map(lineAbout).join("\n")}
`;
}

function lineAbout({ title, does, seconds, load }: Judged): string {
  return `- **${title}** (${Math.round(seconds)} s, load ${load.toFixed(1)}): ${does}.`;
}

function linesOf({ title, goals, fault }: Judged): string[] {
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
