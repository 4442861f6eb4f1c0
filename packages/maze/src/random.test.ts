import { describe, expect, it } from "vitest";
import { createRandom } from "./random.ts";

function draw(seed: number, limit: number, count: number): number[] {
  const random = createRandom(seed);
  return Array.from({ length: count }, () => random.below(limit));
}

describe("createRandom", () => {
  it("repeats its numbers for a seed and varies between seeds, including large and negative ones", () => {
    const seeds = [0, 1, 2, -1, 2 ** 32, 2 ** 40 + 5, Number.MAX_SAFE_INTEGER];
    const series = seeds.map((seed) => draw(seed, 1000, 8).join(" "));
    expect(series).toEqual(seeds.map((seed) => draw(seed, 1000, 8).join(" ")));
    expect(new Set(series).size).toBe(seeds.length);
  });

  it("returns numbers below the limit, each about equally often", () => {
    const counts = [0, 0, 0, 0, 0, 0, 0];
    for (const number of draw(3, 7, 70_000)) counts[number] = (counts[number] ?? 0) + 1;
    expect(counts.reduce((sum, count) => sum + count)).toBe(70_000);
    for (const count of counts) expect(Math.abs(count - 10_000)).toBeLessThan(500);
  });
});
