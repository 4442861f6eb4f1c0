/**
 * `npm run bench:page`: what the built page costs in a browser, beside variants of it in the same run.
 * Prints tables and a line for each goal; exit code 1 when one is missed. Words on the command line
 * choose sections by their titles. What each number is: docs/performance.md.
 */
import { chromium } from "playwright";
import { RelayProcess } from "../../e2e/support/relay-process.ts";
import { chromiumArguments, requireChromium } from "../../scripts/chromium.ts";
import { formatGoal, isMet, type Goal } from "../core/goals.ts";
import { firstVisit } from "./first-visit.ts";
import { otherMazes } from "./other-mazes.ts";
import { frames } from "./frames.ts";
import { scrubbing } from "./scrubbing.ts";
import type { Section } from "./section.ts";

const sections: readonly Section[] = [frames, scrubbing, firstVisit, otherMazes];

const wanted = process.argv.slice(2).map((word) => word.toLowerCase());
const chosen = sections.filter(
  ({ title }) => wanted.length === 0 || wanted.some((word) => title.toLowerCase().includes(word)),
);

const relay = await RelayProcess.start();
const browser = await chromium.launch({
  executablePath: requireChromium(),
  args: [...chromiumArguments],
});
const goals: Goal[] = [];
try {
  for (const { title, measure } of chosen) {
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
