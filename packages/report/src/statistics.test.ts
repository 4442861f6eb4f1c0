import fc from "fast-check";
import { expect, it } from "vitest";
import { deviationOf, meanOf, medianOf } from "./statistics.ts";

it.each([
  { values: [], mean: null, median: null, deviation: null },
  { values: [7], mean: null, median: null, deviation: null },
  { values: [1, 3], mean: 2, median: 2, deviation: 1 },
  { values: [9, 1, 2, 0], mean: 3, median: 1.5, deviation: Math.sqrt(12.5) },
])("describes $values", ({ values, mean, median, deviation }) => {
  expect([meanOf(values), medianOf(values), deviationOf(values)]).toEqual([
    mean,
    median,
    deviation,
  ]);
});

it("gives the same figures in every order, and half of the values are at most the median", () => {
  const values = fc.array(fc.integer({ min: 0, max: 43_200 }), { minLength: 2, maxLength: 50 });
  fc.assert(
    fc.property(values, (numbers) => {
      const median = medianOf(numbers) ?? Number.NaN;
      expect(medianOf(numbers.toReversed())).toBe(median);
      expect(numbers.filter((value) => value <= median).length * 2).toBeGreaterThanOrEqual(
        numbers.length,
      );
      expect(deviationOf(numbers.map((value) => value + 60))).toBeCloseTo(
        deviationOf(numbers) ?? Number.NaN,
      );
    }),
  );
});
