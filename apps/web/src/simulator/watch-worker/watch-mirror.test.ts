import type { Snapshot } from "@corridor/protocol";
import { snapshotOf } from "@corridor/protocol/testing";
import { describe, expect, it } from "vitest";
import { WatchMirror } from "./watch-mirror.ts";

const EVERY_MS = 50;

/** A robot that is watched remotely, and a screen that is redrawn every 10 ms. */
function looking() {
  let now = 1_000;
  const mirror = new WatchMirror(() => now);
  let tick = 0;
  const at = (x: number, y = 150, change: Partial<Snapshot> = {}): Snapshot => {
    tick += 3;
    return snapshotOf({ tick, pose: { x, y, heading: 90 }, ...change });
  };
  const drawn: Snapshot[] = [];
  const trail: number[][] = [];
  const marks: number[] = [];
  const pass = (ms: number): void => {
    for (const end = now + ms; now < end; now += 10) {
      const frame = mirror.frame();
      if (frame === null) continue;
      drawn.push(frame.snapshot);
      if (frame.trailReset) trail.push([]);
      trail.at(-1)?.push(...frame.corners);
      marks.push(...frame.bumps);
    }
  };
  const see = (...snapshots: Snapshot[]): void => {
    for (const snapshot of snapshots) {
      mirror.add(snapshot);
      pass(EVERY_MS);
    }
  };
  return { mirror, at, see, pass, drawn, trail, marks };
}

const steps = (values: readonly number[]): number[] =>
  values.slice(1).map((value, index) => value - (values[index] ?? 0));

describe("a watched robot", () => {
  it("moves evenly between its snapshots, and comes to where it is", () => {
    const { at, see, pass, drawn } = looking();
    see(...Array.from({ length: 20 }, (_, n) => at(100 + 5 * n)));
    pass(500);
    const xs = drawn.map(({ pose }) => pose.x);
    expect(xs[0]).toBe(100);
    expect(xs.at(-1)).toBe(195);
    for (const step of steps(xs.slice(20, 80))) expect(step).toBeCloseTo(1, 1);
    expect(Math.min(...steps(xs))).toBeGreaterThanOrEqual(0);
  });

  it("never moves backwards if snapshots arrive unevenly", () => {
    const { mirror, at, pass, drawn } = looking();
    for (const [n, gap] of [20, 90, 10, 60, 120, 10, 10, 80, 40, 200].entries()) {
      mirror.add(at(100 + 5 * n));
      pass(gap);
    }
    pass(500);
    const xs = drawn.map(({ pose }) => pose.x);
    expect(Math.min(...steps(xs))).toBeGreaterThanOrEqual(0);
    expect(xs.at(-1)).toBe(145);
  });

  it("is not redrawn once it stands", () => {
    const { at, see, pass, drawn } = looking();
    see(at(100), at(105), at(105));
    pass(1_000);
    const { length } = drawn;
    pass(1_000);
    expect(drawn).toHaveLength(length);
    see(at(105));
    pass(1_000);
    expect(drawn.at(-1)?.pose.x).toBe(105);
  });

  it("turns the shorter way round", () => {
    const { at, see, pass, drawn } = looking();
    const facing = (heading: number) => at(150, 150, { pose: { x: 150, y: 150, heading } });
    see(facing(350), facing(355), facing(0), facing(5), facing(10));
    pass(500);
    for (const { pose } of drawn) expect(pose.heading > 345 || pose.heading < 15).toBe(true);
    expect(drawn.at(-1)?.pose.heading).toBe(10);
  });

  it("jumps when it is reset to its start, and its trail restarts", () => {
    const { at, see, pass, drawn, trail } = looking();
    see(at(150), at(155), at(160));
    see(at(950, 950, { tick: 0 }));
    pass(500);
    const between = drawn.filter(({ pose }) => pose.x > 165 && pose.x < 940);
    expect(between).toEqual([]);
    expect(drawn.at(-1)?.pose.x).toBe(950);
    expect(trail).toHaveLength(2);
  });

  it("leaves a trail of its corners alone", () => {
    const { at, see, pass, trail } = looking();
    see(at(100), at(110), at(120), at(120, 160), at(120, 170), at(130, 170), at(120, 170));
    pass(500);
    expect(trail).toEqual([[120, 150, 120, 170, 130, 170]]);
  });

  it("leaves a mark where it bumped", () => {
    const { at, see, pass, marks } = looking();
    see(at(100), at(110), at(115, 150, { bumps: 1, bumping: true }), at(115, 150, { bumps: 1 }));
    pass(500);
    expect(marks).toEqual([115, 150]);
  });

  it("shows readings of another wall at once, not on the way to them", () => {
    const { at, see, pass, drawn } = looking();
    const seeing = (front: number) =>
      at(150, 150, { sensors: { front, right: 50, back: 50, left: 50 } });
    see(seeing(300), seeing(295), seeing(40), seeing(35));
    pass(500);
    expect(drawn.filter(({ sensors }) => sensors.front > 41 && sensors.front < 294)).toEqual([]);
    expect(drawn.at(-1)?.sensors.front).toBe(35);
  });

  it("is where it is when a hidden tab shows again", () => {
    const { mirror, at, pass, drawn, trail } = looking();
    for (let n = 0; n < 2_000; n++) mirror.add(at(100 + (n % 7)));
    pass(500);
    expect(drawn.at(-1)?.pose.x).toBe(100 + (1_999 % 7));
    expect(trail).toHaveLength(1);
  });
});
