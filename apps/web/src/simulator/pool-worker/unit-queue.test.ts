import { programPresets } from "@corridor/program";
import { describe, expect, it } from "vitest";
import type { FromPoolWorker, PoolJob } from "../protocol/pool-messages.ts";
import { UnitQueue } from "./unit-queue.ts";

const program = programPresets[0]?.program;
if (program === undefined) throw new Error("a preset is gone");
const job: PoolJob = { kind: "trial", program, mazes: { kind: "tree", side: 5 }, first: 1 };

/** @param unitMs time that each unit takes */
function setUp(unitMs: number) {
  let now = 0;
  const posted: number[][] = [];
  const queue = new UnitQueue({
    run: () => {
      now += unitMs;
      return { kind: "check", outcome: { ...outcome } };
    },
    post: ({ results }: FromPoolWorker) => posted.push(results.map(({ unit }) => unit)),
    now: () => now,
  });
  return { queue, posted };
}

const outcome = { failure: null, ticks: 1, bumps: 0, visited: 1, open: 1, distance: 0 };

describe("the units of a worker", () => {
  it("run in slices of 25 milliseconds, each with one message", () => {
    const { queue, posted } = setUp(10);
    queue.receive({ type: "begin", id: 1, job });
    queue.receive({ type: "units", from: 0, to: 3 });
    queue.receive({ type: "units", from: 7, to: 9 });
    queue.runSlice();
    expect([posted, queue.size]).toEqual([[[0, 1, 2]], 2]);
    queue.runSlice();
    expect([posted, queue.size]).toEqual([
      [
        [0, 1, 2],
        [7, 8],
      ],
      0,
    ]);
    queue.runSlice();
    expect(posted).toHaveLength(2);
  });

  it("run one at a time if each takes longer than a slice, so that a stop is received in between", () => {
    const { queue, posted } = setUp(100);
    queue.receive({ type: "begin", id: 1, job });
    queue.receive({ type: "units", from: 0, to: 9 });
    queue.runSlice();
    queue.receive({ type: "stop" });
    queue.runSlice();
    expect([posted, queue.size]).toEqual([[[0]], 0]);
  });

  it("of an earlier job do not run", () => {
    const { queue, posted } = setUp(1);
    queue.receive({ type: "begin", id: 1, job });
    queue.receive({ type: "units", from: 0, to: 2 });
    queue.receive({ type: "begin", id: 2, job });
    queue.receive({ type: "units", from: 5, to: 6 });
    queue.runSlice();
    expect(posted).toEqual([[5]]);
  });
});
