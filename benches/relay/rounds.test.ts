import { describe, expect, it } from "vitest";
import type { Seen } from "./load/jobs.ts";
import {
  coreShare,
  costEach,
  measureInTurn,
  passedShare,
  quantileOf,
  rate,
  timesAsMuch,
  typical,
} from "./rounds.ts";

function seen(some: Partial<Seen> = {}): Seen {
  return {
    seconds: 2,
    done: 1000,
    passed: 600,
    processorMs: [300, 100],
    ways: [],
    answers: [],
    beginnings: [],
    ...some,
  };
}

describe("rounds", () => {
  it("run every contender once in each, from another one on", async () => {
    const order: string[] = [];
    const measurements = ["a", "b", "c"].map(
      (name) => [name, async () => (order.push(name), seen({ done: order.length }))] as const,
    );
    const rounds = await measureInTurn(new Map(measurements), 3);
    expect(order.join("")).toBe("abcbcacab");
    expect(rounds.get("a")?.map(({ done }) => done)).toEqual([1, 6, 8]);
  });

  it("are compared round by round", () => {
    const slow = [seen({ done: 10 }), seen({ done: 40 }), seen({ done: 30 })];
    const fast = [seen({ done: 10 }), seen({ done: 20 }), seen({ done: 10 })];
    expect(timesAsMuch(slow, fast, rate)).toBe(2);
    expect(typical(slow, rate)).toBe(15);
  });
});

describe("what one round says", () => {
  it("is told for each thing done, and for a core", () => {
    expect(rate(seen())).toBe(500);
    expect(costEach(seen())).toBe(400);
    expect(coreShare(seen())).toBe(20);
    expect(passedShare(seen())).toBe(60);
    expect(quantileOf("ways", 0.5)(seen({ ways: [0.3, 0.1, 0.2] }))).toBe(200);
  });
});
