import { snapshotOf } from "@corridor/protocol/testing";
import type { Progress } from "@corridor/simulation";
import { beforeEach, describe, expect, it } from "vitest";
import { LateRun } from "./late-run.ts";
import { createRunStore, type RunStore } from "./run-store.ts";

let run: RunStore;
let late: LateRun;
let frames: (() => void)[];

beforeEach(() => {
  frames = [];
  run = createRunStore();
  late = new LateRun(run, (work) => frames.push(work));
  show(1, 0);
});

function show(tick: number, line: number, state: "running" | "paused" = "running"): void {
  run.setState({ snapshot: snapshotOf({ tick, line, state }) });
}

function nextFrame(): void {
  for (const work of frames.splice(0)) work();
}

const shown = () => late.store.getState().snapshot?.tick;

describe("what moves other parts of the page", () => {
  it("follows at once while the same line drives", () => {
    show(2, 0);
    expect(shown()).toBe(2);
    expect(frames).toEqual([]);
  });

  it("follows one frame after the numbers when another line drives", () => {
    show(2, 1);
    nextFrame();
    expect(shown()).toBe(1);
    nextFrame();
    expect(shown()).toBe(2);
  });

  it("follows the numbers when a manoeuvre begins", () => {
    const progress: Progress = {
      action: "left 90",
      kind: "turn",
      part: 0,
      parts: 1,
      left: 90,
      of: 90,
      way: 1,
    };
    run.setState({ snapshot: snapshotOf({ tick: 2, line: 0, state: "running" }), progress });
    expect(late.store.getState().progress).toBeNull();
    for (let frame = 0; frame < 2; frame++) nextFrame();
    expect(late.store.getState().progress).toEqual(progress);
    expect(frames).toEqual([]);
  });

  it("is exact when the robot rests, whatever waited", () => {
    show(2, 1);
    show(3, 2, "paused");
    expect(shown()).toBe(3);
  });

  it("misses nothing when the next news are there before the next frame", () => {
    const told: number[] = [];
    late.store.subscribe(({ snapshot }) => told.push(snapshot?.tick ?? 0));
    show(2, 1);
    show(3, 0);
    show(4, 0);
    expect(told).toEqual([2, 3, 4]);
  });

  it("is followed by what belongs to it, in a frame of its own", () => {
    const done: string[] = [];
    show(2, 0);
    late.after(() => done.push("at once"));
    show(3, 1);
    late.after(() => done.push(`after tick ${shown()}`));
    for (let frame = 0; frame < 2; frame++) nextFrame();
    expect(done).toEqual(["at once"]);
    nextFrame();
    expect(done).toEqual(["at once", "after tick 3"]);
  });

  it("does not do twice what newer news have overtaken", () => {
    let done = 0;
    show(2, 1);
    late.after(() => (done += 1));
    show(3, 1);
    expect(done).toBe(1);
    show(4, 0);
    for (let frame = 0; frame < 5; frame++) nextFrame();
    expect([done, shown()]).toEqual([1, 4]);
  });
});
