import { expect, it } from "vitest";
import { CoalescedTimers } from "./coalesced-timers.ts";
import { FakeClock } from "../testing/fake-clock.ts";

it("wakes each waiter once, at most 5 ms late and never early, and groups those of the same 5 ms", async () => {
  const clock = new FakeClock();
  const timers = new CoalescedTimers(clock);
  const start = clock.now();
  const woken: [name: number, at: number][] = [];
  const delays = [12, 3, 14, 15, 16, 0, 50];
  for (const ms of delays) {
    timers.wakeAfter(ms, { wake: () => woken.push([ms, clock.now() - start]) });
  }
  await clock.pass(1_000);
  expect(woken.toSorted(([a], [b]) => a - b)).toEqual([
    [0, 0],
    [3, 5],
    [12, 15],
    [14, 15],
    [15, 15],
    [16, 20],
    [50, 50],
  ]);
});

it("accepts a new wait during a wake-up", async () => {
  const clock = new FakeClock();
  const timers = new CoalescedTimers(clock);
  let times = 0;
  const sleeper = {
    wake: () => {
      times += 1;
      if (times < 3) timers.wakeAfter(0, sleeper);
    },
  };
  timers.wakeAfter(5, sleeper);
  await clock.pass(100);
  expect(times).toBe(3);
});
