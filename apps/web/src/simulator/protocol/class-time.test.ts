import { expect, it } from "vitest";
import { activeMsAt, withPause } from "./class-time.ts";

const time = { at: 1_000, activeMs: 60_000, pauseEndsAt: null, ahead: 0 };

it("the time of a class stands still in a pause, and goes on when it ends by the clock", () => {
  expect(activeMsAt(time, 3_000)).toBe(62_000);
  const paused = withPause(time, 3_000, 10_000);
  expect(activeMsAt(paused, 8_000)).toBe(62_000);
  expect(activeMsAt(paused, 14_000)).toBe(63_000);
  expect(activeMsAt(withPause(paused, 8_000, null), 9_000)).toBe(63_000);
});
