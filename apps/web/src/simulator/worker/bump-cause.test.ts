import type { MazeDocument } from "@corridor/maze";
import { describe, expect, it } from "vitest";
import { firstMaze, firstProgram } from "../protocol/first-project.ts";
import { Bench } from "./testing/bench.ts";
import type { RunEvent } from "../protocol/worker-messages.ts";

/** Runs until the page would receive a bump; null without one within 20 seconds. */
function causeOfFirstBump(bench: Bench): RunEvent["cause"] {
  bench.loop.run();
  while (bench.time < 20_000) {
    bench.time += 8;
    bench.loop.advance();
    const cause = bench.loop.updates.take()?.events[0]?.cause ?? null;
    if (cause !== null) return cause;
  }
  return null;
}

describe("a bump", () => {
  it("is reported with the decision that led to it and the room that it had", () => {
    const bench = new Bench(firstMaze, { ...firstProgram, rules: [] });
    const cause = causeOfFirstBump(bench);
    expect(cause).toMatchObject({
      decidedAt: 0,
      startedAt: 0,
      action: "forward",
      part: 0,
      parts: 1,
      side: "front",
      needed: null,
    });
    // It drives until its edge, 25 from the middle, is at the wall.
    expect(cause?.driven).toBeCloseTo((cause?.reading ?? 0) - 25, 6);
    expect(cause?.readings.front).toBe(cause?.reading);
  });

  it("while a delayed turn leaves the junction names the part and the room that it needed", () => {
    const box: MazeDocument = {
      ...firstMaze,
      blocks: ["..", ".#"],
      start: { column: 0, row: 0, heading: "east" },
      goals: [],
    };
    const bench = new Bench(box, { ...firstProgram, rules: [], default: "delayed left 90" });
    const cause = causeOfFirstBump(bench);
    expect(cause).toMatchObject({ action: "delayed left 90", part: 2, parts: 3, needed: 60 });
    expect(cause?.driven).toBeCloseTo((cause?.reading ?? 0) - 25, 6);
  });
});
