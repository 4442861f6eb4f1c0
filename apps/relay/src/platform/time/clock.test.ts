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
  it("returns the wall-clock time", () => {
    const { clock, pass, jumps } = atNoon();
    expect(clock.now()).toBe(1_000_000);
    expect(pass(1_000)).toBe(1_001_000);
    expect(jumps).toEqual([]);
  });

  it("continues evenly when the wall clock is set back, and reports the jump once", () => {
    const { pass, jumps } = atNoon();
    expect(pass(1_000, -60_000)).toBe(1_001_000);
    expect(pass(1_000)).toBe(1_002_000);
    expect(jumps).toEqual([-60_000]);
  });

  it("follows when the wall clock jumps ahead, as after sleep", () => {
    const { pass, jumps } = atNoon();
    expect(pass(1_000, 60_000)).toBe(1_061_000);
    expect(pass(1_000)).toBe(1_062_000);
    expect(jumps).toEqual([60_000]);
  });

  it("accounts for sleep immediately, even right after a reading", () => {
    const { pass } = atNoon();
    pass(1_000);
    expect(pass(1, 60_000)).toBe(1_061_001);
  });

  it("ignores small clock corrections", () => {
    const { pass, jumps } = atNoon();
    expect(pass(1_000, -1_500)).toBe(1_001_000);
    expect(pass(1_000, 1_500)).toBe(1_002_000);
    expect(jumps).toEqual([]);
  });
});
