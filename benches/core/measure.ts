/**
 * Timing in one process: rounds in which every variant runs once, so that a slow moment of the machine
 * meets all of them; then medians over the rounds. Each round has its own order, from a fixed seed: what
 * a variant leaves behind (cold caches, garbage to collect) does not always meet the same next one.
 *
 * The clock is the processor time of the process with all its threads. What others do on a shared
 * machine does not count, and what the garbage collector does for a variant beside it does.
 */
import { getHeapStatistics } from "node:v8";
import { createRandom, type Random } from "@corridor/maze";

export interface Timed {
  /** Runs this many ticks. */
  run: (ticks: number) => void;
  /** how long a round of it takes, in milliseconds of processor time; at least one tick runs */
  roundMs: number;
}

/** Doubling stops at this share of a round: enough to tell how many ticks a round takes. */
const CALIBRATED = 0.5;
const WARM_UP_ROUNDS = 3;
const ORDER_SEED = 1;

/**
 * Warms every variant up, then measures them in turn.
 * @returns nanoseconds of processor time a tick, one list of `rounds` numbers for each variant
 */
export function measureRounds(variants: readonly Timed[], rounds: number): number[][] {
  const random = createRandom(ORDER_SEED);
  const ticks = variants.map(warmUp);
  const times = variants.map((): number[] => []);
  for (let round = 0; round < rounds; round++) {
    for (const { at, run } of shuffled(variants, random)) {
      const count = ticks[at] ?? 1;
      times[at]?.push((cpuMs(run, count) * 1e6) / count);
    }
  }
  return times;
}

/** How many times as long a tick of `slow` takes as one of `fast`: the median of the rounds' ratios. */
export function timesSlower(slow: readonly number[], fast: readonly number[]): number {
  return median(slow.map((time, round) => time / (fast[round] ?? Number.NaN)));
}

/** The middle number; the mean of the two in the middle for an even count. */
export function median(numbers: readonly number[]): number {
  const sorted = numbers.toSorted((a, b) => a - b);
  const middle = (sorted.length - 1) / 2;
  return ((sorted[Math.floor(middle)] ?? NaN) + (sorted[Math.ceil(middle)] ?? NaN)) / 2;
}

/** The number below which this share of all lies; NaN when there are none. */
export function quantile(numbers: readonly number[], share: number): number {
  const sorted = numbers.toSorted((a, b) => a - b);
  return sorted[Math.min(sorted.length - 1, Math.floor(sorted.length * share))] ?? Number.NaN;
}

/**
 * Bytes that a tick allocates on the JavaScript heap, garbage included. V8 counts every byte that it has
 * handed out, so collections in between change nothing.
 */
export function allocatedPerTick(run: (ticks: number) => void, ticks: number): number {
  const before = getHeapStatistics().total_allocated_bytes;
  run(ticks);
  return (getHeapStatistics().total_allocated_bytes - before) / ticks;
}

/** Runs a variant until V8 has optimised it. Returns how many ticks fill a round. */
function warmUp({ run, roundMs }: Timed): number {
  let ticks = 1;
  let took = cpuMs(run, ticks);
  while (took < roundMs * CALIBRATED) {
    ticks *= 2;
    took = cpuMs(run, ticks);
  }
  for (let round = 0; round < WARM_UP_ROUNDS; round++) {
    const count = Math.max(1, Math.round((ticks * roundMs) / took));
    took = cpuMs(run, count);
    ticks = count;
  }
  return Math.max(1, Math.round((ticks * roundMs) / took));
}

/** The variants with their places, in an order of its own (Fisher and Yates). */
function shuffled(variants: readonly Timed[], random: Random): (Timed & { at: number })[] {
  const left = variants.map((variant, at) => ({ ...variant, at }));
  return variants.flatMap(() => left.splice(random.below(left.length), 1));
}

function cpuMs(run: (ticks: number) => void, ticks: number): number {
  const start = process.cpuUsage();
  run(ticks);
  const { user, system } = process.cpuUsage(start);
  return (user + system) / 1000;
}
