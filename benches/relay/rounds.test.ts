import { describe, expect, it } from "vitest";
import type { LoadResult } from "./load/jobs.ts";
import {
  coreShare,
  costPerItem,
  forwardedShare,
  measureAlternately,
  medianOf,
  quantileOf,
  rate,
  ratioOf,
} from "./rounds.ts";

function result(overrides: Partial<LoadResult> = {}): LoadResult {
  return {
    seconds: 2,
    done: 1000,
    forwarded: 600,
    processorMs: [300, 100],
    latencies: [],
    answers: [],
    starts: [],
    ...overrides,
  };
}

describe("rounds", () => {
  it("run every peer once and rotate the order", async () => {
    const order: string[] = [];
    const measurements = ["a", "b", "c"].map(
      (name) => [name, async () => (order.push(name), result({ done: order.length }))] as const,
    );
    const rounds = await measureAlternately(new Map(measurements), 3);
    expect(order.join("")).toBe("abcbcacab");
    expect(rounds.get("a")?.map(({ done }) => done)).toEqual([1, 6, 8]);
  });

  it("are compared round by round", () => {
    const slow = [result({ done: 10 }), result({ done: 40 }), result({ done: 30 })];
    const fast = [result({ done: 10 }), result({ done: 20 }), result({ done: 10 })];
    expect(ratioOf(slow, fast, rate)).toBe(2);
    expect(medianOf(slow, rate)).toBe(15);
  });
});

describe("the metrics of a round", () => {
  it("are rates, costs per item, shares and quantiles", () => {
    expect(rate(result())).toBe(500);
    expect(costPerItem(result())).toBe(400);
    expect(coreShare(result())).toBe(20);
    expect(forwardedShare(result())).toBe(60);
    expect(quantileOf("latencies", 0.5)(result({ latencies: [0.3, 0.1, 0.2] }))).toBe(200);
  });
});
