/**
 * Measures peers alternately in rounds, so that a slow period of the machine affects all of them,
 * and computes metrics of the rounds.
 */
import { median, quantile, timesSlower } from "../core/measure.ts";
import type { LoadResult } from "./load/jobs.ts";

/**
 * Runs every measurement once per round. The order rotates, so that a measurement does not always
 * follow the same other one.
 */
export async function measureAlternately<K>(
  measurements: ReadonlyMap<K, () => Promise<LoadResult>>,
  rounds: number,
): Promise<Map<K, LoadResult[]>> {
  const results = new Map<K, LoadResult[]>([...measurements.keys()].map((name) => [name, []]));
  const all = [...measurements];
  for (let round = 0; round < rounds; round++) {
    const from = round % all.length;
    for (const [name, measure] of [...all.slice(from), ...all.slice(0, from)]) {
      results.get(name)?.push(await measure());
    }
  }
  return results;
}

/** The ratio of a metric of two peers: the median of the ratios of all rounds. */
export function ratioOf(
  numerator: readonly LoadResult[],
  denominator: readonly LoadResult[],
  metric: (result: LoadResult) => number,
): number {
  return timesSlower(numerator.map(metric), denominator.map(metric));
}

/** The median of a metric of all rounds. */
export function medianOf(
  rounds: readonly LoadResult[],
  metric: (result: LoadResult) => number,
): number {
  return median(rounds.map(metric));
}

/** Processed snapshots or answered commands per second. */
export const rate = ({ done, seconds }: LoadResult): number => done / seconds;

/** Microseconds of processor time of all processes, per processed snapshot or answered command. */
export const costPerItem = (result: LoadResult): number => (totalMs(result) * 1000) / result.done;

/** Processor time of all processes in percent of one core. */
export const coreShare = (result: LoadResult): number => totalMs(result) / result.seconds / 10;

/** The share of snapshots that were forwarded to readers, in percent. */
export const forwardedShare = ({ forwarded, done }: LoadResult): number => (100 * forwarded) / done;

export type Times = "latencies" | "answers" | "starts";

/** A metric: the quantile of a list of times, in microseconds. */
export const quantileOf =
  (times: Times, share: number) =>
  (result: LoadResult): number =>
    quantile(result[times], share) * 1000;

function totalMs({ processorMs }: LoadResult): number {
  return processorMs.reduce((sum, ms) => sum + ms, 0);
}
