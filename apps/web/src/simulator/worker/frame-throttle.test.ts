import { snapshotOf } from "@corridor/protocol/testing";
import type { Snapshot } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { FrameThrottle } from "./frame-throttle.ts";
import { frameOf } from "../../stage/testing/frame-of.ts";
import type { Frame } from "../../stage/drawing/frame.ts";

/** A throttle with a clock that the test controls. */
function start() {
  let time = 0;
  const pace = new FrameThrottle(() => time);
  const at = (milliseconds: number, changes: Partial<Snapshot>, frame: Partial<Frame> = {}) => {
    time = milliseconds;
    pace.add(frameOf({ snapshot: snapshotOf(changes), ...frame }));
    return pace.take();
  };
  const wait = (milliseconds: number): Frame | null => {
    time = milliseconds;
    return pace.take();
  };
  return { at, wait };
}

describe("frames for the page while the robot drives", () => {
  it("come four times a second, with everything that the trail gained in between", () => {
    const { at, wait } = start();
    expect(at(0, { tick: 1 }, { corners: [1, 1], trailReset: true })).not.toBeNull();
    expect(at(16, { tick: 2 }, { corners: [2, 2] })).toBeNull();
    expect(at(33, { tick: 3 }, { corners: [3, 3] })).toBeNull();
    expect(wait(249)).toBeNull();
    expect(wait(250)).toMatchObject({ snapshot: { tick: 3 }, corners: [2, 2, 3, 3] });
    expect(wait(500)).toBeNull();
  });

  it.each([
    { name: "another line", changes: { line: 1 } },
    { name: "a pause", changes: { state: "paused" } },
    { name: "another driver", changes: { driver: "me" } },
    { name: "a bump", changes: { bumps: 1 } },
    { name: "the goal", changes: { goalReached: true } },
    { name: "another command", changes: { command: 7 } },
    { name: "the way back to the start", changes: { tick: 0 } },
  ] satisfies { name: string; changes: Partial<Snapshot> }[])(
    "comes at once for $name",
    ({ changes }) => {
      const { at } = start();
      const before: Partial<Snapshot> = { driver: "program", line: 0, state: "running", tick: 5 };
      at(0, before);
      expect(at(8, { ...before, tick: 6 })).toBeNull();
      expect(at(16, { ...before, tick: 6, ...changes })).not.toBeNull();
    },
  );

  it("are limited to four a second on average if every frame changes something important", () => {
    const { at } = start();
    let sent = 0;
    for (let time = 0; time < 10_000; time += 8) {
      if (at(time, { tick: time, line: time % 3 }) !== null) sent++;
    }
    expect(sent).toBeGreaterThan(36);
    expect(sent).toBeLessThan(46);
  });

  it("come at once for the goal, even if every frame before changed something important", () => {
    const { at } = start();
    let time = 0;
    const next = (changes: Partial<Snapshot>) => at(++time, { tick: time, ...changes });
    for (let command = 1; command < 20; command++) next({ command });
    expect(next({ command: 20 })).toBeNull();
    expect(next({ command: 20, goalReached: true })).not.toBeNull();
    // Once a run.
    expect(next({ command: 21, goalReached: true })).toBeNull();
  });

  it("come at once while the user seeks in the past", () => {
    const { at } = start();
    at(0, { tick: 90 });
    expect(at(1, { tick: 10 }, { view: "past" })).not.toBeNull();
    expect(at(2, { tick: 11 }, { view: "past" })).not.toBeNull();
  });
});
