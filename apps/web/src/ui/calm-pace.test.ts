import { describe, expect, it } from "vitest";
import { CalmPace } from "./calm-pace.ts";

/** A pace whose time passes when the test says so. */
function start() {
  let time = 0;
  const pace = new CalmPace<string>(() => time);
  return (milliseconds: number, isMoving: boolean, news = "line 1") => {
    time = milliseconds;
    return pace.isDue(isMoving, news);
  };
}

describe("a number for those who listen", () => {
  it("is told at most once a second while it moves", () => {
    const isDue = start();
    const told = Array.from({ length: 41 }, (_, at) => at * 100).filter((time) =>
      isDue(time, true),
    );
    expect(told).toEqual([0, 1000, 2000, 3000, 4000]);
  });

  it("is right at once when it stands still", () => {
    const isDue = start();
    expect(isDue(0, true)).toBe(true);
    expect(isDue(100, true)).toBe(false);
    expect(isDue(200, false)).toBe(true);
    expect(isDue(201, false)).toBe(true);
  });

  it("does not keep back what is more than another number", () => {
    const isDue = start();
    isDue(0, true);
    expect(isDue(100, true, "line 2")).toBe(true);
    expect(isDue(200, true, "line 2")).toBe(false);
  });
});
