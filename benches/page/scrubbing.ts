/**
 * Measures seeking in an hour's run, and the memory of the run: for the recording alone in Node.js,
 * and for the built page with everything that it draws.
 */
import type { Goal } from "../core/goals.ts";
import { quantile } from "../core/measure.ts";
import { hourRuns } from "./hour-runs.ts";
import { scrubPage } from "./scrub-page.ts";
import { scrubRecording } from "./scrub-recording.ts";
import type { PageUnderTest, Section } from "./section.ts";

const MEBIBYTE = 2 ** 20;
const FRAME_MS = 16.7;
const MAX_MS = 50;
const MAX_MIB = 64;

export const scrubbing: Section = {
  title: "Scrubbing",
  measure: async (page) => [...measureRecordings(), ...(await measurePage(page))],
};

function measureRecordings(): Goal[] {
  return hourRuns().flatMap((run): Goal[] => {
    const { name, p50, p99, worst, bytes, countedBytes } = scrubRecording(run);
    const sizes = [bytes, countedBytes].map((each) => (each / MEBIBYTE).toFixed(1)).join(" / ");
    const times = [p50, p99, worst].map((each) => each.toFixed(2)).join(" / ");
    console.log(`  ${name}: p50 / p99 / max ${times} ms; measured / counted ${sizes} MiB`);
    return [
      atMost(MAX_MS, "ms", `seek to any tick of an hour, ${name}, p99`, p99),
      atMost(MAX_MIB, "MiB", `recording of an hour, ${name}`, bytes / MEBIBYTE),
    ];
  });
}

async function measurePage({ browser, url }: PageUnderTest): Promise<Goal[]> {
  const goals: Goal[] = [];
  for (const run of hourRuns()) {
    const { jumps, memory } = await scrubPage(browser, url, run);
    const time = jumps.map((jump) => jump.time);
    const main = jumps.map((jump) => jump.main);
    const worker = jumps.map((jump) => jump.worker);
    const [main99, worker99] = [quantile(main, 0.99), quantile(worker, 0.99)];
    const sizes = [memory.main, memory.workers].map((each) => (each / MEBIBYTE).toFixed(1));
    console.log(`  ${run.name}, in the page: p50 / p99 / max ${formatQuantiles(time)} ms`);
    console.log(
      `    processor time: page ${formatQuantiles(main)} ms, worker ${formatQuantiles(worker)} ms`,
    );
    console.log(`    memory: page / worker ${sizes.join(" / ")} MiB`);
    const total = (memory.main + memory.workers) / MEBIBYTE;
    goals.push(
      atMost(MAX_MS, "ms", `canvas and panel after a jump, ${run.name}, p99`, quantile(time, 0.99)),
      atMost(
        FRAME_MS,
        "ms",
        `processor time of a jump on the busier thread, ${run.name}, p99`,
        Math.max(main99, worker99),
      ),
      atMost(MAX_MIB, "MiB", `page and worker with a run of an hour, ${run.name}`, total),
    );
  }
  return goals;
}

function formatQuantiles(times: readonly number[]): string {
  return [0.5, 0.99, 1].map((share) => quantile(times, share).toFixed(1)).join(" / ");
}

function atMost(max: number, unit: string, label: string, measured: number): Goal {
  return { label, measured, bound: { atMost: max }, unit };
}
