import type { RunDocument } from "@corridor/recording";
import { describe, expect, it } from "vitest";
import { firstMaze, firstProgram } from "./first-work.ts";
import { RunLoader } from "./run-loader.ts";
import { RunLoop } from "./run-loop.ts";
import type { FromWorker } from "./worker-messages.ts";

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

/** A worker whose slices come when the test says so. */
function newLoader(open?: () => never) {
  const loop = new RunLoop(firstMaze, firstProgram, now);
  const posted: FromWorker[] = [];
  let waiting = 0;
  const loader = new RunLoader({
    now,
    later: () => void waiting++,
    post: (message) => void posted.push(message),
    open: open ?? ((recording) => loop.open(recording)),
  });
  const slice = () => {
    waiting--;
    loader.goOn();
  };
  const finish = () => {
    while (waiting > 0) slice();
  };
  const answers = () => posted.filter(({ type }) => type === "run-loaded");
  return { loop, loader, posted, slice, finish, answers, isBusy: () => waiting > 0 };
}

describe("opening a recorded run", () => {
  it("of some length leaves room for other messages, tells how far it is, and ends", () => {
    const run = longRun(6_000);
    const { loader, loop, posted, finish, answers, isBusy } = newLoader();
    loader.load({ type: "load-run", id: 7, run });
    expect(isBusy()).toBe(true);
    expect(answers()).toEqual([]);
    expect(loop.snapshot().tick).toBe(0);
    finish();
    expect(answers()).toMatchObject([{ id: 7, loaded: { ok: true, maze: run.maze } }]);
    expect(loop.snapshot().tick).toBe(run.ticks);
    const parts = posted.flatMap((each) => (each.type === "run-loading" ? [each.part] : []));
    expect(parts.length).toBeGreaterThan(0);
    expect(parts).toEqual(parts.toSorted((a, b) => a - b));
    expect(parts.every((part) => part > 0 && part < 1)).toBe(true);
  });

  it("is given up for another one, by who asked, or by whatever else is opened", () => {
    const run = longRun(6_000);
    const { loader, loop, slice, finish, answers } = newLoader();
    const cancelled = { ok: false, reason: "cancelled" };
    loader.load({ type: "load-run", id: 1, run });
    loader.load({ type: "load-run", id: 2, run });
    expect(answers()).toMatchObject([{ id: 1, loaded: cancelled }]);
    loader.cancel(1);
    slice();
    loader.cancel(2);
    expect(answers().slice(1)).toMatchObject([{ id: 2, loaded: cancelled }]);
    loader.load({ type: "load-run", id: 3, run });
    loader.cancel();
    finish();
    expect(answers().slice(2)).toMatchObject([{ id: 3, loaded: cancelled }]);
    expect(loop.snapshot().tick).toBe(0);
  });

  it("is refused where it ends in other bits, and nothing has changed", () => {
    const run = { ...longRun(300), digest: "0123456789abcdef" };
    const { loader, loop, finish, answers } = newLoader();
    loader.load({ type: "load-run", id: 1, run });
    finish();
    const refused = { ok: false, reason: "refused", problems: [{ path: "digest" }] };
    expect(answers()).toMatchObject([{ id: 1, loaded: refused }]);
    expect(loop.snapshot().tick).toBe(0);
  });

  it("is answered all the same where it breaks", () => {
    const { loader, finish, answers } = newLoader(() => {
      throw new Error("broken");
    });
    const load = () => {
      loader.load({ type: "load-run", id: 1, run: longRun(10) });
      finish();
    };
    expect(load).toThrow("broken");
    expect(answers()).toEqual([
      { type: "run-loaded", id: 1, loaded: { ok: false, reason: "fault" } },
    ]);
  });
});
