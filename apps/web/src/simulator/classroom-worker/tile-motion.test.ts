import type { Tile } from "@corridor/protocol";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { TileMotion, type ShownTile } from "./tile-motion.ts";

const FRAME_MS = 10;
const EVERY_MS = 500;

function tileAt(pose: Tile["pose"], change: Partial<Tile> = {}): Tile {
  return {
    seq: 1,
    task: 1,
    maze: "g1",
    state: "driving",
    pose,
    path: "",
    line: 1,
    tick: 0,
    bumps: 0,
    passes: null,
    ...change,
  };
}

/** A robot on a card that is redrawn every 10 ms while it moves. */
function looking() {
  let now = 1_000;
  const motion = new TileMotion();
  const poses: { x: number; y: number; heading: number }[] = [];
  const seen: ShownTile[] = [];
  const pass = (ms: number): void => {
    for (const end = now + ms; now < end; now += FRAME_MS) {
      if (!motion.isMoving) continue;
      const shown = motion.shown(now);
      if (shown === null) continue;
      seen.push(shown);
      poses.push(shown.pose);
    }
  };
  const see = (tiles: readonly Tile[], everyMs = EVERY_MS): void => {
    for (const tile of tiles) {
      motion.add(tile, now);
      pass(everyMs);
    }
  };
  return { motion, poses, seen, pass, see };
}

const steps = (values: readonly number[]): number[] =>
  values.slice(1).map((value, index) => value - (values[index] ?? 0));

/** A robot that drives east from x = 50. */
const eastwards = (...xs: number[]): Tile[] =>
  xs.map((x) => tileAt([x, 50, 90], { path: x < 100 ? "" : `e${Math.floor(x / 100)}` }));

describe("a robot on a card", () => {
  it("moves evenly between its tiles, and comes to its newest one", () => {
    const { see, pass, poses } = looking();
    see(eastwards(50, 100, 150, 200, 250, 300, 350));
    pass(1_000);
    const xs = poses.map(({ x }) => x);
    expect(xs.at(-1)).toBe(350);
    for (const step of steps(xs.slice(10, 200))) expect(step).toBeCloseTo(1, 0);
  });

  it("does not move any more once it has reached its newest tile", () => {
    const { motion, see, pass, poses } = looking();
    see(eastwards(50, 150));
    pass(1_000);
    const { length } = poses;
    pass(5_000);
    expect([motion.isMoving, poses.length]).toEqual([false, length]);
  });

  it.each([
    ["a bump while it stands", tileAt([50, 50, 90], { state: "bumped", bumps: 1, tick: 90 })],
    ["another maze", tileAt([60, 50, 90], { maze: "g2", tick: 90 })],
    ["another task", tileAt([60, 50, 90], { task: 2, tick: 90 })],
    ["a reset", tileAt([60, 50, 90], { tick: 0 })],
    ["a place to which it did not drive", tileAt([350, 50, 90], { tick: 90 })],
  ])("shows %s at once", (_what, next) => {
    const motion = new TileMotion();
    motion.add(tileAt([50, 50, 90], { tick: 60 }), 1_000);
    motion.add(next, 1_500);
    expect(motion.isMoving).toBe(false);
    expect(motion.shown(1_500)?.tile).toBe(next);
  });

  it("drives round a corner, not through the wall beside it", () => {
    const { see, pass, poses } = looking();
    see([tileAt([150, 50, 90], { path: "e1" }), tileAt([250, 150, 180], { path: "e2s1" })]);
    pass(1_000);
    for (const { x, y } of poses) expect(x === 250 || y === 50, `${x} ${y}`).toBe(true);
    expect(poses.some(({ x, y }) => x === 250 && y > 60 && y < 140)).toBe(true);
  });

  it("does not drive back to a corner that it has turned", () => {
    const { see, pass, poses } = looking();
    see([tileAt([250, 70, 180], { path: "e2" }), tileAt([250, 150, 180], { path: "e2s1" })]);
    pass(1_000);
    expect(Math.min(...poses.map(({ y }) => y))).toBe(70);
  });

  it("turns the shorter way round", () => {
    const { see, pass, poses } = looking();
    see([tileAt([50, 50, 350]), tileAt([50, 50, 10])]);
    pass(1_000);
    for (const { heading } of poses) expect(heading >= 350 || heading <= 10).toBe(true);
  });

  it("has a path that ends at the robot", () => {
    const motion = new TileMotion();
    motion.add(tileAt([250, 130, 180], { path: "e2s1" }), 1_000);
    motion.add(tileAt([360, 250, 90], { path: "e2s2e1" }), 1_500);
    const points = (at: number) => motion.shown(at)?.trail.map(({ x, y }) => [x, y]);
    const start = [
      [50, 50],
      [250, 50],
    ];
    expect(points(1_500)).toEqual([...start, [250, 130]]);
    expect(points(1_830)).toEqual([...start, [250, 245]]);
    expect(points(2_500)).toEqual([...start, [250, 250], [360, 250]]);
  });

  it("has a path that goes exactly through it, also beside the centres of the cells", () => {
    const { motion, see, pass, seen } = looking();
    see([
      tileAt([50, 50, 90]),
      tileAt([120, 54, 90], { path: "e1" }),
      tileAt([262, 56, 90], { path: "e2" }),
      tileAt([263, 56, 170], { path: "e2" }),
      tileAt([264, 90, 180], { path: "e2" }),
      tileAt([265, 210, 180], { path: "e2s2" }),
      tileAt([320, 247, 90], { path: "e2s2e1" }),
      // It drives back.
      tileAt([210, 246, 270], { path: "e2s2e1w1" }),
    ]);
    pass(2_000);
    expect(seen.length).toBeGreaterThan(100);
    const isTilted = ({ trail }: ShownTile): boolean =>
      trail.some(({ x, y }, at) => {
        const from = trail[at - 1];
        return from !== undefined && from.x !== x && from.y !== y;
      });
    expect(seen.filter(isTilted)).toEqual([]);
    const ends = seen.map(({ trail }) => trail.at(-1));
    expect(ends).toEqual(seen.map(({ pose: { x, y } }) => ({ x, y })));
    const newest = motion.newest()?.trail.map(({ x, y }) => [x, y]);
    expect(newest).toEqual([
      [50, 56],
      [265, 56],
      [265, 246],
      [320, 246],
      [210, 246],
    ]);
  });

  it("jumps from tile to tile if motion is reduced", () => {
    const { motion, see } = looking();
    see(eastwards(50, 150), 0);
    expect(motion.newest()?.pose.x).toBe(150);
    expect(motion.isMoving).toBe(false);
  });

  it("is where it is when a hidden tab shows again", () => {
    const motion = new TileMotion();
    eastwards(...Array.from({ length: 1_000 }, (_, n) => 50 + n)).forEach((tile, n) =>
      motion.add(tile, EVERY_MS * n),
    );
    expect(motion.shown(EVERY_MS * 1_002)?.pose.x).toBe(1_049);
  });

  it("never moves backwards or beyond its newest tile, however unevenly tiles arrive", () => {
    const tile = fc.record({
      by: fc.integer({ min: 0, max: 90 }),
      after: fc.integer({ min: 0, max: 3_000 }),
    });
    fc.assert(
      fc.property(fc.array(tile, { maxLength: 20 }), (tiles) => {
        const { motion, poses, pass, see } = looking();
        let x = 50;
        for (const { by, after } of tiles) {
          x += by;
          see(eastwards(x), after);
          expect(poses.at(-1)?.x ?? 0).toBeLessThanOrEqual(x);
        }
        pass(2_000);
        expect(Math.min(0, ...steps(poses.map((pose) => pose.x)))).toBe(0);
        expect(motion.shown(Number.MAX_SAFE_INTEGER)?.pose.x ?? x).toBe(x);
      }),
    );
  });
});
