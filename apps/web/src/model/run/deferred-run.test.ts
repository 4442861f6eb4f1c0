import { snapshotOf } from "@corridor/protocol/testing";
import { beforeEach, describe, expect, it } from "vitest";
import { DeferredRun } from "./deferred-run.ts";
import { createRunStore, type RunStore } from "./run-store.ts";

let run: RunStore;
let late: DeferredRun;
let frames: (() => void)[];

beforeEach(() => {
  frames = [];
  run = createRunStore();
  late = new DeferredRun(run, (task) => frames.push(task));
  show(1, 0);
});

function show(tick: number, line: number, state: "running" | "paused" = "running"): void {
  run.setState({ snapshot: snapshotOf({ tick, line, state }) });
}

function nextFrame(): void {
  for (const task of frames.splice(0)) task();
}

const displayed = () => late.words.getState().snapshot?.tick;

describe("deferred output", () => {
  it("follows one frame later while the robot drives", () => {
    show(2, 0);
    expect(displayed()).toBe(1);
    nextFrame();
    expect(displayed()).toBe(2);
    expect(frames).toEqual([]);
  });

  it("follows at once while the robot rests", () => {
    show(2, 0, "paused");
    show(3, 1, "paused");
    expect(displayed()).toBe(3);
    expect(frames).toEqual([]);
  });

  it("is exact when the robot rests, whatever was pending", () => {
    show(2, 1);
    show(3, 2, "paused");
    expect(displayed()).toBe(3);
  });

  it("misses nothing if the next update arrives before the next frame", () => {
    const received: number[] = [];
    late.words.subscribe(({ snapshot }) => received.push(snapshot?.tick ?? 0));
    show(2, 1);
    show(3, 0);
    show(4, 0);
    expect(received).toEqual([2, 3]);
    nextFrame();
    expect(received).toEqual([2, 3, 4]);
  });

  it("runs the tasks for its state in the same frame", () => {
    const done: string[] = [];
    const task = () => done.push(`after tick ${displayed()}`);
    show(2, 0);
    late.with(task);
    expect(done).toEqual([]);
    nextFrame();
    expect(done).toEqual(["after tick 2"]);
    show(4, 1, "paused");
    late.with(task);
    expect(done.at(-1)).toBe("after tick 4");
  });

  it("skips tasks that a newer update has replaced", () => {
    let done = 0;
    show(2, 1);
    late.with(() => (done += 1));
    show(3, 1);
    expect(done).toBe(1);
    show(4, 0);
    for (let frame = 0; frame < 4; frame++) nextFrame();
    expect([done, displayed()]).toEqual([1, 4]);
  });
});
