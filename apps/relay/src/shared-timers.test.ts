import { expect, it } from "vitest";
import { SharedTimers } from "./shared-timers.ts";
import { FakeClock } from "./testing/fake-clock.ts";

it("wakes each one once, not early and at most 5 ms late, and those of the same 5 ms together", async () => {
  const clock = new FakeClock();
  const timers = new SharedTimers(clock);
  const began = clock.now();
  const woken: [name: number, at: number][] = [];
  const wishes = [12, 3, 14, 15, 16, 0, 50];
  for (const ms of wishes) {
    timers.wakeAfter(ms, { wake: () => woken.push([ms, clock.now() - began]) });
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

it("takes who sleeps again while others are woken", async () => {
  const clock = new FakeClock();
  const timers = new SharedTimers(clock);
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
