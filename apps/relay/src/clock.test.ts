import { describe, expect, it } from "vitest";
import { steadyClock } from "./clock.ts";

function atNoon() {
  const time = { wall: 1_000_000, passed: 50 };
  const jumps: number[] = [];
  const clock = steadyClock((ms) => jumps.push(ms), {
    wall: () => time.wall,
    monotonic: () => time.passed,
  });
  const pass = (ms: number, jump = 0): number => {
    time.passed += ms;
    time.wall += ms + jump;
    return clock.now();
  };
  return { clock, pass, jumps };
}

describe("the relay's clock", () => {
  it("tells the time", () => {
    const { clock, pass, jumps } = atNoon();
    expect(clock.now()).toBe(1_000_000);
    expect(pass(1_000)).toBe(1_001_000);
    expect(jumps).toEqual([]);
  });

  it("goes on evenly when the machine's clock is set back, and says so once", () => {
    const { pass, jumps } = atNoon();
    expect(pass(1_000, -60_000)).toBe(1_001_000);
    expect(pass(1_000)).toBe(1_002_000);
    expect(jumps).toEqual([-60_000]);
  });

  it("follows when the machine's clock goes ahead, as after a sleep", () => {
    const { pass, jumps } = atNoon();
    expect(pass(1_000, 60_000)).toBe(1_061_000);
    expect(pass(1_000)).toBe(1_062_000);
    expect(jumps).toEqual([60_000]);
  });

  it("knows at once how long the machine slept, also when it was just asked for the time", () => {
    const { pass } = atNoon();
    pass(1_000);
    expect(pass(1, 60_000)).toBe(1_061_001);
  });

  it("takes no notice of the small corrections of a good clock", () => {
    const { pass, jumps } = atNoon();
    expect(pass(1_000, -1_500)).toBe(1_001_000);
    expect(pass(1_000, 1_500)).toBe(1_002_000);
    expect(jumps).toEqual([]);
  });
});
