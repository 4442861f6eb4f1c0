import { expect, it } from "vitest";
import { TryLimit } from "./try-limit.ts";

const rule = { wrong: { count: 3, inMs: 1_000 }, delay: { firstMs: 100, mostMs: 350 } };

it("lets nobody try for a while after too many wrong ones, each time for longer", () => {
  const limit = new TryLimit(rule);
  const waits = [0, 10, 20, 120, 320, 670].map((now) => {
    expect(limit.waitMs(now)).toBe(0);
    limit.begin(now);
    return limit.waitMs(now);
  });
  expect(waits).toEqual([0, 0, 100, 200, 350, 350]);
  expect(limit.waitMs(670 + 349)).toBe(1);
});

it("forgets wrong ones after their time, and the delay with them", () => {
  const limit = new TryLimit(rule);
  for (const now of [0, 1, 2]) limit.begin(now);
  expect(limit.isFresh(1_001)).toBe(false);
  expect(limit.isFresh(1_003)).toBe(true);
  for (const now of [2_000, 2_001, 2_002]) limit.begin(now);
  expect(limit.waitMs(2_002)).toBe(100);
});

it("does not count a try that turns out right", () => {
  const limit = new TryLimit(rule);
  for (let now = 0; now < 50; now += 1) limit.begin(now)();
  expect(limit.isFresh(50)).toBe(true);
});

it("looks at no more tries at once than one after the other", () => {
  const limit = new TryLimit(rule);
  const rights = [0, 0, 0].map((now) => limit.begin(now));
  expect(limit.waitMs(0)).toBe(100);
  rights[2]?.();
  expect(limit.waitMs(0)).toBe(0);
});
