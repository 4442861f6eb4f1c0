import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { FAST_MS, Pulse, SLOW_MS } from "./pulse.ts";

beforeEach(() => {
  vi.useFakeTimers();
});

afterEach(() => {
  vi.useRealTimers();
});

/** @returns the number of turns per second, second by second */
function turnsOf(seconds: number, movesIn: (second: number) => boolean): number[] {
  const turns = Array.from({ length: seconds }, () => 0);
  let second = 0;
  const pulse = new Pulse(() => {
    turns[second] = (turns[second] ?? 0) + 1;
    return movesIn(second);
  });
  for (; second < seconds; second++) {
    if (movesIn(second)) pulse.wake();
    vi.advanceTimersByTime(1_000);
  }
  vi.clearAllTimers();
  return turns;
}

const fast = 1_000 / FAST_MS;
const slow = 1_000 / SLOW_MS;

test("turns stay fast while something moves", () => {
  expect(turnsOf(4, () => true)).toEqual([fast, fast, fast, fast]);
});

test("turns become slow a second after the last movement, and fast with the next", () => {
  expect(turnsOf(5, (second) => second === 3)).toEqual([fast, slow, slow, fast, fast]);
});
