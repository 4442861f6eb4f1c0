/**
 * Random programs with close numbers, so that lines overlap in every way, and their distinct
 * readings.
 */
import {
  conditionKinds,
  conditionOf,
  numberOf,
  type Condition,
  type ProgramDocument,
} from "@corridor/program";
import { plainActions } from "@corridor/protocol";
import fc from "fast-check";
import type { ReadingRange } from "../reaching-readings.ts";

/** Halves and their sums are exact in binary. */
const near = fc.integer({ min: 18, max: 40 }).map((number) => number / 2);
const plus = fc.integer({ min: -8, max: 8 }).map((number) => number / 2);

/** Any condition with a number around 15. */
export const randomCondition: fc.Arbitrary<Condition> = fc
  .constantFrom(...conditionKinds, ...conditionKinds.slice(4), ...conditionKinds.slice(8))
  .chain((kind) =>
    (kind.than === "right" ? plus : near).map((number) => conditionOf(kind, number)),
  );

/** A program of up to `max` lines, some without a condition. */
export function randomProgram(max: number): fc.Arbitrary<ProgramDocument> {
  const rule = fc.record({
    when: fc.option(randomCondition, { freq: 8 }),
    do: fc.constantFrom(...plainActions),
  });
  return fc.array(rule, { minLength: 1, maxLength: max }).map((rules) => ({
    format: "corridor/program",
    version: 1,
    name: "",
    default: "forward",
    rules,
  }));
}

/**
 * One reading for each combination of true and false conditions: at every number and sum of
 * numbers, between neighbours, and at the ends of the range.
 */
export function* distinctReadings(
  { rules }: ProgramDocument,
  range: ReadingRange,
): Generator<{ front: number; right: number; back: number; left: number }> {
  const conditions = rules.flatMap(({ when }) => (when === null ? [] : [when]));
  const numbersOf = (sensor: Condition["sensor"]) =>
    conditions.filter((each) => each.than !== "right" && each.sensor === sensor).map(numberOf);
  const differences = conditions.filter(({ than }) => than === "right").map(numberOf);
  const lefts = [range.min, range.max, ...numbersOf("left")];
  const rights = [
    ...numbersOf("right"),
    ...lefts.flatMap((left) => differences.map((difference) => left - difference)),
  ];
  for (const front of cuts(numbersOf("front"), range)) {
    for (const back of cuts(numbersOf("back"), range)) {
      for (const right of cuts(rights, range)) {
        const sums = differences.map((difference) => right + difference);
        for (const left of cuts([...lefts, ...sums], range)) yield { front, right, back, left };
      }
    }
  }
}

/** The numbers inside the range, its ends, and a value between each two neighbours. */
function cuts(numbers: readonly number[], { min, max }: ReadingRange): number[] {
  const inside = numbers.filter((number) => number >= min && number <= max);
  const points = [...new Set([min, max, ...inside])].toSorted((a, b) => a - b);
  return points.flatMap((point, at) => {
    const next = points[at + 1];
    return next === undefined ? [point] : [point, (point + next) / 2];
  });
}
