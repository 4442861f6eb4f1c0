/**
 * `npm run bench:page`: measures the built page in a browser and compares it with variants. Prints
 * tables and one line per goal; exits with code 1 if a goal is missed. Arguments select sections by
 * parts of their titles. docs/performance.md describes each number.
 */
import { chromium } from "playwright";
import { RelayProcess } from "../../tests/support/relay-process.ts";
import { chromiumArguments, requireChromium } from "../../scripts/chromium.ts";
import { formatGoal, isMet, type Goal } from "../core/goals.ts";
import { dashboard } from "./dashboard/dashboard.ts";
import { firstVisit } from "./first-visit.ts";
import { lessonCheck } from "./lesson-check.ts";
import { otherMazes } from "./other-mazes.ts";
import { frames } from "./frames.ts";
import { scrubbing } from "./scrubbing.ts";
import { storedEndings } from "./stored-endings.ts";
import type { Section } from "./section.ts";

const sections: readonly Section[] = [
  frames,
  storedEndings,
  scrubbing,
  firstVisit,
  otherMazes,
  lessonCheck,
  dashboard,
];

const filters = process.argv.slice(2).map((filter) => filter.toLowerCase());
const selected = sections.filter(
  ({ title }) =>
    filters.length === 0 || filters.some((filter) => title.toLowerCase().includes(filter)),
);

const relay = await RelayProcess.start();
const browser = await chromium.launch({
  executablePath: requireChromium(),
  args: [...chromiumArguments],
});
const goals: Goal[] = [];
try {
  for (const { title, measure } of selected) {
    console.log(`\n${title}`);
    goals.push(...(await measure({ browser, url: relay.url })));
  }
} finally {
  await browser.close();
  await relay.stop();
}
console.log();
for (const goal of goals) console.log(formatGoal(goal));
if (!goals.every(isMet)) process.exitCode = 1;
