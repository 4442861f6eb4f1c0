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

it("compares times of the same round, so a round that is slow for both changes nothing", () => {
  expect(timesSlower([20, 2000, 22], [10, 1000, 11])).toBe(2);
});

it("times every variant in every round", () => {
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

it("counts the bytes of an array that is allocated in every tick", () => {
  const retained: Float64Array[] = [];
  const bytes = allocatedPerTick((ticks) => {
    for (let i = 0; i < ticks; i++) retained[i % 8] = Float64Array.from({ length: 8 }, () => i);
  }, 20_000);
  expect(retained).toHaveLength(8);
  expect(bytes).toBeGreaterThan(64);
});
