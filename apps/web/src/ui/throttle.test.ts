import { describe, expect, it } from "vitest";
import { Throttle } from "./throttle.ts";

/** A throttle with a clock that the test controls. */
function start() {
  let time = 0;
  const throttle = new Throttle<string>(() => time);
  return (milliseconds: number, isMoving: boolean, key = "line 1") => {
    time = milliseconds;
    return throttle.isDue(isMoving, key);
  };
}

describe("a number for screen readers", () => {
  it("is reported at most once a second while it changes", () => {
    const isDue = start();
    const reported = Array.from({ length: 41 }, (_, at) => at * 100).filter((time) =>
      isDue(time, true),
    );
    expect(reported).toEqual([0, 1000, 2000, 3000, 4000]);
  });

  it("is exact at once when it stands still", () => {
    const isDue = start();
    expect(isDue(0, true)).toBe(true);
    expect(isDue(100, true)).toBe(false);
    expect(isDue(200, false)).toBe(true);
    expect(isDue(201, false)).toBe(true);
  });

  it("does not delay other changes than that of a number", () => {
    const isDue = start();
    isDue(0, true);
    expect(isDue(100, true, "line 2")).toBe(true);
    expect(isDue(200, true, "line 2")).toBe(false);
  });
});
