import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { atFullSecond } from "./full-seconds.ts";

/** A time at a full second. */
const START = 1_700_000_000_000;

beforeEach(() => void vi.useFakeTimers({ now: START }));
afterEach(() => void vi.useRealTimers());

it("all that is due within a second runs in one task, at its end", () => {
  const ran: string[] = [];
  for (const after of [200, 900, 1_000]) atFullSecond(START + after, () => ran.push(`${after}`));
  atFullSecond(START + 1_001, () => ran.push("1001"));
  expect(vi.getTimerCount()).toBe(2);
  vi.advanceTimersByTime(999);
  expect(ran).toEqual([]);
  vi.advanceTimersByTime(1);
  expect(ran).toEqual(["200", "900", "1000"]);
  vi.advanceTimersByTime(1_000);
  expect(ran).toEqual(["200", "900", "1000", "1001"]);
});

it("what was cancelled does not run, and the rest does", () => {
  const ran: string[] = [];
  const cancel = atFullSecond(START + 500, () => ran.push("cancelled"));
  atFullSecond(START + 600, () => ran.push("runs"));
  cancel();
  vi.advanceTimersByTime(5_000);
  expect(ran).toEqual(["runs"]);
});

it("what waits again while it runs is due at its own time", () => {
  const ran: number[] = [];
  const again = (): void => {
    ran.push(Date.now() - START);
    if (ran.length < 3) atFullSecond(Date.now() + 60_000, again);
  };
  atFullSecond(START + 1, again);
  vi.advanceTimersByTime(200_000);
  expect(ran).toEqual([1_000, 61_000, 121_000]);
});
