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

const shown = () => late.words.getState().snapshot?.tick;
const numbers = () => late.numbers.getState().snapshot?.tick;

describe("what moves other parts of the page", () => {
  it("follows one frame later while the same line drives", () => {
    show(2, 0);
    expect([numbers(), shown()]).toEqual([1, 1]);
    nextFrame();
    expect([numbers(), shown()]).toEqual([2, 2]);
    expect(frames).toEqual([]);
  });

  it("follows at once while the robot rests", () => {
    show(2, 0, "paused");
    show(3, 1, "paused");
    expect([numbers(), shown()]).toEqual([3, 3]);
    expect(frames).toEqual([]);
  });

  it("follows the mark of another line: numbers in one frame, words in the next", () => {
    show(2, 1);
    expect([numbers(), shown()]).toEqual([1, 1]);
    nextFrame();
    expect([numbers(), shown()]).toEqual([2, 1]);
    nextFrame();
    expect(shown()).toBe(2);
  });

  it("follows the mark when a manoeuvre begins", () => {
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
    expect(late.words.getState().progress).toBeNull();
    for (let frame = 0; frame < 2; frame++) nextFrame();
    expect(late.words.getState().progress).toEqual(progress);
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

  it("is followed by what belongs to it, in the frame of its words", () => {
    const done: string[] = [];
    const work = () => done.push(`after tick ${shown()}`);
    show(2, 0);
    late.after(work);
    nextFrame();
    expect(done).toEqual(["after tick 2"]);
    show(3, 1);
    late.after(work);
    nextFrame();
    expect([numbers(), done.length]).toEqual([3, 1]);
    nextFrame();
    expect(done).toEqual(["after tick 2", "after tick 3"]);
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
