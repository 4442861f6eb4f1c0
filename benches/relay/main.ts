/**
 * `npm run bench:relay`: measures the cost and the capacity of the relay, and compares it with
 * peers: other systems that forward messages between a robot's page and its reader. Prints tables
 * and one line per goal; exits with code 1 if a goal is missed. Arguments select sections by parts
 * of their titles. docs/performance.md describes each number.
 */
import { availableParallelism, cpus } from "node:os";
import { formatGoal, isMet, type Goal } from "../core/goals.ts";
import { classes } from "./classes/classes.ts";
import { commands } from "./commands.ts";
import { crowd } from "./crowd.ts";
import { gateways } from "./gateways.ts";
import { idle } from "./idle.ts";
import { redis } from "./redis.ts";
import type { Section } from "./section.ts";
import { snapshots } from "./snapshots.ts";
import { twoRelays } from "./two-relays.ts";

if (process.platform !== "linux") {
  console.error("npm run bench:relay requires Linux, because it reads process metrics from /proc.");
  process.exit(2);
}

const sections: readonly Section[] = [
  snapshots,
  commands,
  redis,
  crowd,
  gateways,
  idle,
  twoRelays,
  classes,
];
const filters = process.argv.slice(2).map((filter) => filter.toLowerCase());
const selected = sections.filter(
  ({ title }) =>
    filters.length === 0 || filters.some((filter) => title.toLowerCase().includes(filter)),
);

const goals: Goal[] = [];
for (const { title, measure } of selected) {
  console.log(`\n${title}`);
  goals.push(...(await measure()));
}
const model = cpus()[0]?.model.trim() ?? "unknown processor";
console.log(`\nNode ${process.versions.node}, ${availableParallelism()} cores, ${model}\n`);
for (const goal of goals) console.log(formatGoal(goal));
if (!goals.every(isMet)) process.exitCode = 1;
