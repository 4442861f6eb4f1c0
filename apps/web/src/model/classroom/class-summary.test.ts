import { expect, it } from "vitest";
import { barsOf, median, mostCommon } from "./class-summary.ts";

it.each([
  { values: [], expected: null },
  { values: [3], expected: 3 },
  { values: [1, 9, 2], expected: 2 },
  { values: [1, 2, 9, 4], expected: 3 },
])("the median of $values is $expected", ({ values, expected }) => {
  expect(median(values)).toBe(expected);
});

it("the most common number is the smallest one if several are", () => {
  expect(mostCommon([])).toBeNull();
  expect(mostCommon([5, 3, 3, 5, 2])).toEqual({ value: 3, count: 2, all: 5 });
});

it("bars have every number in between, and the last of 8 all larger ones", () => {
  expect(barsOf([2, 4, 4])).toEqual([
    { value: 2, count: 1, isOpen: false },
    { value: 3, count: 0, isOpen: false },
    { value: 4, count: 2, isOpen: false },
  ]);
  const bars = barsOf([1, 8, 30]);
  expect(bars).toHaveLength(8);
  expect(bars.at(-1)).toEqual({ value: 8, count: 2, isOpen: true });
  expect(barsOf([])).toEqual([]);
});
