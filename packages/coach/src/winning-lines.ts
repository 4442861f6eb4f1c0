/**
 * Finds a smallest set of lines because of which a line never decides: one of them is true whenever
 * the line is true.
 *
 * Each contradiction is one of seven cycles: a lower and an upper bound of one quantity, or right,
 * difference and left together. The tightest bounds result in the smallest set. Then the uppermost
 * line that is tight enough replaces each, because that line decides.
 */
import { numberOf, type Condition, type Rule } from "@corridor/program";
import { quantityOf, type Quantity, type ReadingRange } from "./reaching-readings.ts";

/** `line` is null for a bound of the range, and for the bound of the examined line. */
interface Bound {
  value: number;
  /** whether the value itself is excluded: for a condition that must be true */
  isStrict: boolean;
  line: number | null;
}

/** Bounds of one kind, each tighter than the one before it. */
type Ladder = Bound[];
type Ladders = Record<Quantity, Ladder>;

/** The ladders of a cycle, and whether one bound of each contradict each other. */
interface Cycle {
  ladders: Ladder[];
  isEmpty: (bounds: readonly Bound[]) => boolean;
}

/**
 * @param rules of the program
 * @param line the line that never decides; `rules.length` for "otherwise"
 * @param range of all readings
 * @returns a smallest set of lines above, uppermost first; empty if no reading of the range makes
 * the condition true; null if the line can decide
 */
export function winningLines(
  rules: readonly Rule[],
  line: number,
  range: ReadingRange,
): number[] | null {
  const own = rules[line]?.when ?? null;
  let best: number[] | null = null;
  for (const cycle of cyclesOf(rules.slice(0, line), own, range)) {
    for (const bounds of choices(cycle.ladders.map((ladder) => candidates(ladder)))) {
      if (!cycle.isEmpty(bounds)) continue;
      const lines = uppermost(bounds, cycle);
      if (best === null || lines.length < best.length) best = lines;
    }
  }
  return best?.toSorted((a, b) => a - b) ?? null;
}

function cyclesOf(above: readonly Rule[], own: Condition | null, range: ReadingRange): Cycle[] {
  const low = laddersFrom(range.min, -Infinity);
  const high = laddersFrom(range.max, Infinity);
  for (const [line, { when }] of above.entries()) {
    if (when === null) continue;
    const bound = { value: numberOf(when), isStrict: false, line };
    const quantity = quantityOf(when);
    const top = (when.is === ">" ? high : low)[quantity];
    const tightest = top.at(-1)?.value ?? 0;
    if (when.is === ">" ? bound.value < tightest : bound.value > tightest) top.push(bound);
  }
  if (own !== null) {
    const side = own.is === ">" ? low : high;
    const bound = { value: numberOf(own), isStrict: true, line: null };
    // The condition itself must be true: its own bound comes before all looser ones.
    side[quantityOf(own)].unshift(bound);
  }
  const pairs = (Object.keys(low) as Quantity[]).map((quantity): Cycle => ({
    ladders: [low[quantity], high[quantity]],
    isEmpty: ([from, to]) => contradict(from?.value, to?.value, [from, to]),
  }));
  return [
    ...pairs,
    // right <= a and left - right <= b leave left at most a + b
    {
      ladders: [high.right, high.difference, low.left],
      isEmpty: ([a, b, left]) => contradict(left?.value, sum(a, b), [a, b, left]),
    },
    {
      ladders: [low.right, low.difference, high.left],
      isEmpty: ([a, b, left]) => contradict(sum(a, b), left?.value, [a, b, left]),
    },
  ];
}

function laddersFrom(reading: number, difference: number): Ladders {
  const from = (value: number): Ladder => [{ value, isStrict: false, line: null }];
  return {
    front: from(reading),
    right: from(reading),
    back: from(reading),
    left: from(reading),
    difference: from(difference),
  };
}

function sum(a: Bound | undefined, b: Bound | undefined): number {
  return (a?.value ?? 0) + (b?.value ?? 0);
}

/** Whether the interval is empty; its ends belong to it unless a bound is strict. */
function contradict(from = 0, to = 0, bounds: readonly (Bound | undefined)[]): boolean {
  return bounds.some((bound) => bound?.isStrict) ? from >= to : from > to;
}

/** The bounds without a line, and the tightest one with a line. */
function candidates(ladder: Ladder): Bound[] {
  const tightest = ladder.at(-1);
  const free = ladder.filter(({ line }) => line === null);
  return tightest === undefined || tightest.line === null ? free : [...free, tightest];
}

/** All combinations with one bound of each column. */
function* choices(columns: readonly Bound[][], chosen: Bound[] = []): Generator<Bound[]> {
  const column = columns[chosen.length];
  if (column === undefined) yield chosen;
  else for (const bound of column) yield* choices(columns, [...chosen, bound]);
}

/** The lines of a contradiction, each replaced by the uppermost sufficient one. */
function uppermost(bounds: readonly Bound[], { ladders, isEmpty }: Cycle): number[] {
  let chosen = bounds;
  for (const [at, bound] of bounds.entries()) {
    if (bound.line === null) continue;
    const first = ladders[at]?.find(
      (other) => other.line !== null && isEmpty(chosen.with(at, other)),
    );
    if (first !== undefined) chosen = chosen.with(at, first);
  }
  return chosen.flatMap(({ line }) => (line === null ? [] : [line]));
}
