import { pino } from "pino";
import { expect, it } from "vitest";
import { FakeClock } from "../../platform/testing/fake-clock.ts";
import { RedisClock } from "./redis-clock.ts";

/** A relay's clock, and a Redis whose clock is ahead by `aheadMs`. */
async function withRedis(aheadMs: number, answerMs = 0) {
  const machine = new FakeClock();
  const redis = { aheadMs, isDown: false };
  const ask = async (): Promise<number> => {
    if (redis.isDown) throw new Error("nobody answers");
    const there = machine.now() + redis.aheadMs;
    if (answerMs > 0) await machine.pass(answerMs);
    return there;
  };
  const log = pino({ level: "silent" });
  const clock = await RedisClock.open({ clock: machine, log, ask });
  return { machine, redis, clock, ahead: () => clock.now() - machine.now() };
}

it.each([60_000, -60_000])("returns the time of Redis, %d ms from its own", async (aheadMs) => {
  const { ahead } = await withRedis(aheadMs);
  expect(ahead()).toBe(aheadMs);
});

it("differs by at most half of the response time", async () => {
  const { ahead } = await withRedis(60_000, 100);
  expect(Math.abs(ahead() - 60_000)).toBeLessThanOrEqual(50);
});

it("jumps ahead immediately, and continues while Redis is unavailable", async () => {
  const { machine, redis, ahead } = await withRedis(0);
  redis.aheadMs = 30_000;
  await machine.pass(5_000);
  expect(ahead()).toBe(30_000);
  redis.isDown = true;
  await machine.pass(60_000);
  expect(ahead()).toBe(30_000);
});

it("gives no extra time: slows down if Redis is slightly behind, and ignores Redis if it is far behind", async () => {
  const { machine, redis, clock, ahead } = await withRedis(0);
  redis.aheadMs = -10;
  for (let second = 0, before = clock.now(); second < 20; second++) {
    await machine.pass(1_000);
    expect(clock.now() - before).toBeGreaterThan(990);
    before = clock.now();
  }
  expect(ahead()).toBe(-10);
  redis.aheadMs = -3_600_000;
  await machine.pass(60_000);
  expect(ahead()).toBe(-10);
});
