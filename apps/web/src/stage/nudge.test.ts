import { describe, expect, it } from "vitest";
import { easeNudge, nudgeOffset, type Nudge } from "./nudge.ts";

const recoil: Nudge = { kind: "recoil", dx: 1, dy: 0, startedAt: 1000 };
const hop: Nudge = { kind: "hop", dx: 0, dy: 0, startedAt: 1000 };
const times = Array.from({ length: 421 }, (_, at) => 1000 + at);

describe("the robot's nudge", () => {
  it("overshoots and ends at rest", () => {
    expect(easeNudge(0)).toBeCloseTo(0, 2);
    expect(easeNudge(1)).toBe(1);
    expect(Math.max(...times.map((_, at) => easeNudge(at / 420)))).toBeGreaterThan(1);
  });

  it("recoils 6 px at first, away from the wall, and back", () => {
    expect(nudgeOffset(recoil, 1000)?.x).toBeCloseTo(6, 1);
    expect(nudgeOffset(recoil, 1000)?.y).toBe(0);
    expect(Math.abs(nudgeOffset(recoil, 1415)?.x ?? 9)).toBeLessThan(0.5);
  });

  it("hops up to about 8 px, never sideways, and down again", () => {
    const offsets = times.flatMap((time) => nudgeOffset(hop, time) ?? []);
    const highest = Math.min(...offsets.map(({ y }) => y));
    expect(highest).toBeLessThan(-7);
    expect(highest).toBeGreaterThan(-12);
    expect(offsets.every(({ x }) => x === 0)).toBe(true);
  });

  it("happens once", () => {
    expect(nudgeOffset(recoil, 999)).toBeNull();
    expect(nudgeOffset(recoil, 1420)).toBeNull();
    expect(nudgeOffset(hop, 9000)).toBeNull();
  });
});
