import { snapshotOf } from "@corridor/protocol/testing";
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

const shown = () => late.words.getState().snapshot?.tick;

describe("what is displayed later", () => {
  it("follows one frame later while the robot drives", () => {
    show(2, 0);
    expect(shown()).toBe(1);
    nextFrame();
    expect(shown()).toBe(2);
    expect(frames).toEqual([]);
  });

  it("follows at once while the robot rests", () => {
    show(2, 0, "paused");
    show(3, 1, "paused");
    expect(shown()).toBe(3);
    expect(frames).toEqual([]);
  });

  it("is exact when the robot rests, whatever waited", () => {
    show(2, 1);
    show(3, 2, "paused");
    expect(shown()).toBe(3);
  });

  it("misses nothing when the next news are there before the next frame", () => {
    const told: number[] = [];
    late.words.subscribe(({ snapshot }) => told.push(snapshot?.tick ?? 0));
    show(2, 1);
    show(3, 0);
    show(4, 0);
    expect(told).toEqual([2, 3]);
    nextFrame();
    expect(told).toEqual([2, 3, 4]);
  });

  it("is followed by what belongs to it, in the same frame", () => {
    const done: string[] = [];
    const work = () => done.push(`after tick ${shown()}`);
    show(2, 0);
    late.after(work);
    expect(done).toEqual([]);
    nextFrame();
    expect(done).toEqual(["after tick 2"]);
    show(4, 1, "paused");
    late.after(work);
    expect(done.at(-1)).toBe("after tick 4");
  });

  it("does not do twice what newer news have overtaken", () => {
    let done = 0;
    show(2, 1);
    late.after(() => (done += 1));
    show(3, 1);
    expect(done).toBe(1);
    show(4, 0);
    for (let frame = 0; frame < 4; frame++) nextFrame();
    expect([done, shown()]).toEqual([1, 4]);
  });
});
