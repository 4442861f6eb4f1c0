import { describe, expect, it } from "vitest";
import { allocatedPerTick, measureRounds, median, timesSlower } from "./measure.ts";

describe("median", () => {
  it.each([
    { numbers: [3], middle: 3 },
    { numbers: [9, 1, 5], middle: 5 },
    { numbers: [4, 1, 3, 2], middle: 2.5 },
  ])("of $numbers is $middle", ({ numbers, middle }) => {
    expect(median(numbers)).toBe(middle);
  });
});

it("a ratio compares times of the same round, so that a slow round of both changes nothing", () => {
  expect(timesSlower([20, 2000, 22], [10, 1000, 11])).toBe(2);
});

it("every variant gets a time in every round, whatever the order of the round", () => {
  const ran = [0, 0, 0];
  const variants = ran.map((_, at) => ({
    run: (ticks: number) => {
      for (let i = 0; i < ticks * 1000; i++) ran[at] = (ran[at] ?? 0) + 1;
    },
    roundMs: 1,
  }));
  const times = measureRounds(variants, 5);
  expect(times.map((each) => each.length)).toEqual([5, 5, 5]);
  expect(ran.every((count) => count > 0)).toBe(true);
});

it("an array in every tick is found among the bytes allocated", () => {
  const kept: Float64Array[] = [];
  const bytes = allocatedPerTick((ticks) => {
    for (let i = 0; i < ticks; i++) kept[i % 8] = Float64Array.from({ length: 8 }, () => i);
  }, 20_000);
  expect(kept).toHaveLength(8);
  expect(bytes).toBeGreaterThan(64);
});
