import type { RunDocument } from "@corridor/recording";
import { describe, expect, it } from "vitest";
import { firstMaze, firstProgram } from "../protocol/first-project.ts";
import { RunLoader } from "./run-loader.ts";
import { RunLoop } from "./run-loop.ts";
import type { LoadedRun } from "../protocol/worker-messages.ts";

/** A run of the first program, longer than a slice. */
function longRun(ticks: number): RunDocument {
  const loop = new RunLoop(firstMaze, { ...firstProgram, default: "stop", rules: [] }, now);
  loop.setSpeed(16);
  loop.run();
  while (loop.snapshot().tick < ticks) loop.advance();
  const written = loop.saveRun();
  if (!written.ok) throw new Error(written.reason);
  return written.run;
}
let time = 0;
function now(): number {
  return (time += 5);
}

/** A worker whose slices run when the test requests them. */
function newLoader(open?: () => never) {
  const loop = new RunLoop(firstMaze, firstProgram, now);
  const parts: number[] = [];
  const answers: { id: number; loaded: LoadedRun }[] = [];
  let waiting = 0;
  const loader = new RunLoader({
    now,
    later: () => void waiting++,
    onPart: (_id, part) => void parts.push(part),
    answer: (id, loaded) => void answers.push({ id, loaded }),
  });
  const load = (id: number, run: RunDocument) =>
    loader.load({ id, run }, open ?? ((recording) => loop.open(recording)));
  const slice = () => {
    waiting--;
    loader.next();
  };
  const finish = () => {
    while (waiting > 0) slice();
  };
  return { loop, loader, load, parts, slice, finish, answers, isBusy: () => waiting > 0 };
}

describe("opening a recorded run", () => {
  it("of some length leaves room for other messages, reports its progress, and ends", () => {
    const run = longRun(6_000);
    const { load, loop, parts, finish, answers, isBusy } = newLoader();
    load(7, run);
    expect(isBusy()).toBe(true);
    expect(answers).toEqual([]);
    expect(loop.snapshot().tick).toBe(0);
    finish();
    expect(answers).toMatchObject([{ id: 7, loaded: { ok: true, maze: run.maze } }]);
    expect(loop.snapshot().tick).toBe(run.ticks);
    expect(parts.length).toBeGreaterThan(0);
    expect(parts).toEqual(parts.toSorted((a, b) => a - b));
    expect(parts.every((part) => part > 0 && part < 1)).toBe(true);
  });

  it("is cancelled by another one, by its requester, or by anything else that opens", () => {
    const run = longRun(6_000);
    const { load, loader, loop, slice, finish, answers } = newLoader();
    const cancelled = { ok: false, reason: "cancelled" };
    load(1, run);
    load(2, run);
    expect(answers).toMatchObject([{ id: 1, loaded: cancelled }]);
    loader.cancel(1);
    slice();
    loader.cancel(2);
    expect(answers.slice(1)).toMatchObject([{ id: 2, loaded: cancelled }]);
    load(3, run);
    loader.cancel();
    finish();
    expect(answers.slice(2)).toMatchObject([{ id: 3, loaded: cancelled }]);
    expect(loop.snapshot().tick).toBe(0);
  });

  it("is rejected if it ends in other bits, and nothing has changed", () => {
    const run = { ...longRun(300), digest: "0123456789abcdef" };
    const { load, loop, finish, answers } = newLoader();
    load(1, run);
    finish();
    const refused = { ok: false, reason: "refused", problems: [{ path: "digest" }] };
    expect(answers).toMatchObject([{ id: 1, loaded: refused }]);
    expect(loop.snapshot().tick).toBe(0);
  });

  it("is answered even if it breaks", () => {
    const { load, finish, answers } = newLoader(() => {
      throw new Error("broken");
    });
    const loadAll = () => {
      load(1, longRun(10));
      finish();
    };
    expect(loadAll).toThrow("broken");
    expect(answers).toEqual([{ id: 1, loaded: { ok: false, reason: "fault" } }]);
  });
});
