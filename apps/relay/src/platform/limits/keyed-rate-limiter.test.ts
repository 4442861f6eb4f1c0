import { expect, it } from "vitest";
import { FakeClock } from "../testing/fake-clock.ts";
import { KeyedRateLimiter } from "./keyed-rate-limiter.ts";

const MINUTE_MS = 60_000;

it("limits each key separately", () => {
  const limiter = new KeyedRateLimiter(new FakeClock(), { perSecond: 1, burst: 2 });
  const waits = ["a", "a", "a", "b"].map((key) => limiter.take(key));
  expect(waits).toEqual([0, 0, 1_000, 0]);
});

it("deletes a key within a minute after it may use its whole burst again", async () => {
  const clock = new FakeClock();
  const limiter = new KeyedRateLimiter(clock, { perSecond: 1 / 60, burst: 2 });
  for (let use = 0; use < 2; use++) limiter.take("heavy");
  limiter.take("light");
  await clock.pass(MINUTE_MS);
  expect(limiter.size).toBe(1);
  expect(limiter.take("heavy")).toBe(0);
  await clock.pass(3 * MINUTE_MS);
  expect(limiter.size).toBe(0);
});
