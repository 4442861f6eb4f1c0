/**
 * `npm run bench:relay`: what the relay costs and how much it takes, beside other ways of passing messages
 * between a robot and its reader, in the same run. Prints tables and a line for each goal; exit code 1 when one
 * is missed. Words on the command line choose sections by their titles. What each number is: docs/performance.md.
 */
import { availableParallelism, cpus } from "node:os";
import { formatGoal, isMet, type Goal } from "../core/goals.ts";
import { commands } from "./commands.ts";
import { crowd } from "./crowd.ts";
import { idle } from "./idle.ts";
import type { Section } from "./section.ts";
import { snapshots } from "./snapshots.ts";
import { twoRelays } from "./two-relays.ts";

if (process.platform !== "linux") {
  console.error("npm run bench:relay reads what processes cost from /proc, which only Linux has.");
  process.exit(2);
}

const sections: readonly Section[] = [snapshots, commands, crowd, idle, twoRelays];
const wanted = process.argv.slice(2).map((word) => word.toLowerCase());
const chosen = sections.filter(
  ({ title }) => wanted.length === 0 || wanted.some((word) => title.toLowerCase().includes(word)),
);

const goals: Goal[] = [];
for (const { title, measure } of chosen) {
  console.log(`\n${title}`);
  goals.push(...(await measure()));
}
const model = cpus()[0]?.model.trim() ?? "unknown processor";
console.log(`\nNode ${process.versions.node}, ${availableParallelism()} cores, ${model}\n`);
for (const goal of goals) console.log(formatGoal(goal));
if (!goals.every(isMet)) process.exitCode = 1;
