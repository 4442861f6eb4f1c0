/**
 * Contenders measured in turn, round after round, so that a slow moment of the machine meets all of them;
 * and what their rounds come to.
 */
import { median, quantile, timesSlower } from "../core/measure.ts";
import type { Seen } from "./load/jobs.ts";

/** Runs every measurement once in each round. The order turns: nobody is always the one after the loudest. */
export async function measureInTurn<K>(
  measurements: ReadonlyMap<K, () => Promise<Seen>>,
  rounds: number,
): Promise<Map<K, Seen[]>> {
  const seen = new Map<K, Seen[]>([...measurements.keys()].map((name) => [name, []]));
  const all = [...measurements];
  for (let round = 0; round < rounds; round++) {
    const from = round % all.length;
    for (const [name, measure] of [...all.slice(from), ...all.slice(0, from)]) {
      seen.get(name)?.push(await measure());
    }
  }
  return seen;
}

/** How many times as much as the other, by this figure: the median of the rounds' ratios. */
export function timesAsMuch(
  one: readonly Seen[],
  other: readonly Seen[],
  figure: (seen: Seen) => number,
): number {
  return timesSlower(one.map(figure), other.map(figure));
}

/** The median of the rounds. */
export function typical(rounds: readonly Seen[], figure: (seen: Seen) => number): number {
  return median(rounds.map(figure));
}

export const rate = ({ done, seconds }: Seen): number => done / seconds;

/** Microseconds of processor time for each that was done, of all processes together. */
export const costEach = (seen: Seen): number => (totalMs(seen) * 1000) / seen.done;

/** Percent of one core. */
export const coreShare = (seen: Seen): number => totalMs(seen) / seen.seconds / 10;

/** The share of snapshots that was passed on to readers, in percent. */
export const passedShare = ({ passed, done }: Seen): number => (100 * passed) / done;

export type Times = "ways" | "answers" | "beginnings";

/** Microseconds. */
export const quantileOf =
  (times: Times, share: number) =>
  (seen: Seen): number =>
    quantile(seen[times], share) * 1000;

function totalMs({ processorMs }: Seen): number {
  return processorMs.reduce((sum, ms) => sum + ms, 0);
}
