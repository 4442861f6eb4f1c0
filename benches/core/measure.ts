/**
 * Times variants in one process. In each round, every variant runs once, so that a slow period of
 * the machine affects all of them. The results are medians over the rounds. Each round has its own
 * order, shuffled from a fixed seed, so that the cold caches and garbage of a variant affect
 * different successors.
 *
 * The clock is the processor time of the process with all its threads. It excludes other processes
 * of a shared machine and includes the garbage collector.
 */
import { getHeapStatistics } from "node:v8";
import { createRandom, type Random } from "@corridor/maze";

export interface Timed {
  /** Runs this many ticks. */
  run: (ticks: number) => void;
  /** milliseconds of processor time per round; at least one tick runs */
  roundMs: number;
}

/** Calibration doubles the ticks until they take this share of a round. */
const CALIBRATION_SHARE = 0.5;
const WARM_UP_ROUNDS = 3;
const ORDER_SEED = 1;

/**
 * Warms up every variant, then measures all variants in every round.
 * @returns nanoseconds of processor time per tick: for each variant, a list of `rounds` numbers
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

/** The ratio of the times per tick of `slow` and `fast`: the median of the ratios of all rounds. */
export function timesSlower(slow: readonly number[], fast: readonly number[]): number {
  return median(slow.map((time, round) => time / (fast[round] ?? Number.NaN)));
}

/** The median; for an even count, the mean of the two middle numbers. */
export function median(numbers: readonly number[]): number {
  const sorted = numbers.toSorted((a, b) => a - b);
  const middle = (sorted.length - 1) / 2;
  return ((sorted[Math.floor(middle)] ?? NaN) + (sorted[Math.ceil(middle)] ?? NaN)) / 2;
}

/** The quantile of the numbers at a share from 0 to 1; NaN if there are no numbers. */
export function quantile(numbers: readonly number[], share: number): number {
  const sorted = numbers.toSorted((a, b) => a - b);
  return sorted[Math.min(sorted.length - 1, Math.floor(sorted.length * share))] ?? Number.NaN;
}

/**
 * Bytes that a tick allocates on the JavaScript heap, including garbage. V8 counts every allocated
 * byte, so garbage collections do not affect the result.
 */
export function allocatedPerTick(run: (ticks: number) => void, ticks: number): number {
  const before = getHeapStatistics().total_allocated_bytes;
  run(ticks);
  return (getHeapStatistics().total_allocated_bytes - before) / ticks;
}

/** Runs a variant until V8 has optimised it. @returns the number of ticks per round */
function warmUp({ run, roundMs }: Timed): number {
  let ticks = 1;
  let took = cpuMs(run, ticks);
  while (took < roundMs * CALIBRATION_SHARE) {
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

/** The variants with their indices, shuffled (Fisher-Yates). */
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
