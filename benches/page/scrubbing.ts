/**
 * Going to any moment of an hour's run, and what the hour holds of the page's memory: the past alone, in Node, and
 * the built page with all that it draws.
 */
import type { Goal } from "../core/goals.ts";
import { quantile } from "../core/measure.ts";
import { hours } from "./hours.ts";
import { pageScrubReport } from "./scrub-page.ts";
import { scrubReport } from "./scrub.ts";
import type { PageUnderTest, Section } from "./section.ts";

const MEBIBYTE = 2 ** 20;
const FRAME_MS = 16.7;
const MOST_MS = 50;
const MOST_MIB = 64;

export const scrubbing: Section = {
  title: "Scrubbing",
  measure: async (page) => [...goalsOfPast(), ...(await goalsOfPage(page))],
};

function goalsOfPast(): Goal[] {
  return hours().flatMap((hour): Goal[] => {
    const { name, p50, p99, worst, bytes, counted } = scrubReport(hour);
    const sizes = [bytes, counted].map((each) => (each / MEBIBYTE).toFixed(1)).join(" / ");
    const times = [p50, p99, worst].map((each) => each.toFixed(2)).join(" / ");
    console.log(`  ${name}: p50 / p99 / worst ${times} ms; held / counted ${sizes} MiB`);
    return [
      atMost(MOST_MS, "ms", `to any moment of an hour, ${name}, p99`, p99),
      atMost(MOST_MIB, "MiB", `an hour, ${name}`, bytes / MEBIBYTE),
    ];
  });
}

async function goalsOfPage({ browser, url }: PageUnderTest): Promise<Goal[]> {
  const goals: Goal[] = [];
  for (const hour of hours()) {
    const { jumps, held } = await pageScrubReport(browser, url, hour);
    const time = jumps.map((jump) => jump.time);
    const main = jumps.map((jump) => jump.main);
    const worker = jumps.map((jump) => jump.worker);
    const [main99, worker99] = [quantile(main, 0.99), quantile(worker, 0.99)];
    const sizes = [held.main, held.workers].map((each) => (each / MEBIBYTE).toFixed(1));
    console.log(`  ${hour.name}, in the page: p50 / p99 / worst ${three(time)} ms`);
    console.log(`    processor: page ${three(main)} ms, worker ${three(worker)} ms`);
    console.log(`    page / worker hold ${sizes.join(" / ")} MiB`);
    const all = (held.main + held.workers) / MEBIBYTE;
    goals.push(
      atMost(
        MOST_MS,
        "ms",
        `picture and panel of any moment, ${hour.name}, p99`,
        quantile(time, 0.99),
      ),
      atMost(
        FRAME_MS,
        "ms",
        `processor for it, the busier thread, ${hour.name}, p99`,
        Math.max(main99, worker99),
      ),
      atMost(MOST_MIB, "MiB", `page and worker with an hour, ${hour.name}`, all),
    );
  }
  return goals;
}

function three(times: readonly number[]): string {
  return [0.5, 0.99, 1].map((part) => quantile(times, part).toFixed(1)).join(" / ");
}

function atMost(most: number, unit: string, label: string, measured: number): Goal {
  return { label, measured, bound: { atMost: most }, unit };
}
