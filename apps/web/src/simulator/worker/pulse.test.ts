import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { FAST_MS, SLOW_MS, startPulse } from "./pulse.ts";

beforeEach(() => {
  vi.useFakeTimers();
});

afterEach(() => {
  vi.clearAllTimers();
  vi.useRealTimers();
});

test("turns are fast while something moves, and slow while nothing does", () => {
  let moves = false;
  let turns = 0;
  const takeTurn = startPulse(() => {
    turns++;
    return moves;
  });
  const turnsIn = (milliseconds: number): number => {
    const before = turns;
    vi.advanceTimersByTime(milliseconds);
    return turns - before;
  };
  expect(turnsIn(1_000)).toBe(1_000 / SLOW_MS);
  moves = true;
  takeTurn();
  expect(turnsIn(1_000)).toBe(1_000 / FAST_MS);
  moves = false;
  expect(turnsIn(FAST_MS)).toBe(1);
  expect(turnsIn(1_000)).toBe(1_000 / SLOW_MS);
});
