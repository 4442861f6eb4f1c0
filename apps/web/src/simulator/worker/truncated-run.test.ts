import type { ProgramDocument } from "@corridor/program";
import { describe, expect, it } from "vitest";
import { firstMaze, firstProgram } from "../protocol/first-project.ts";
import * as diagnostics from "./diagnose-run.ts";
import { RunLoop } from "./run-loop.ts";
import { loadRun } from "./testing/load-run.ts";
import type { RunEvent } from "../protocol/worker-messages.ts";

/** Drives straight on, into the wall. */
const straight: ProgramDocument = { ...firstProgram, rules: [] };

function newBench(program = straight) {
  let time = 0;
  const loop = new RunLoop(firstMaze, program, () => time);
  loop.updates.useDiagnostics(diagnostics);
  const truncated: number[] = [];
  const takeEvents = (): RunEvent[] => {
    const taken = loop.updates.take();
    if (taken === null) return [];
    if (taken.truncatedAfter !== null) truncated.push(taken.truncatedAfter);
    return taken.events;
  };
  const pass = (seconds: number) => {
    const moments: RunEvent[] = [];
    for (let i = 0; i < seconds * 60; i++) {
      time += 1000 / 60;
      loop.advance();
      moments.push(...takeEvents());
    }
    return moments;
  };
  return { loop, pass, takeEvents, truncated };
}

describe("a run that continues from an earlier tick", () => {
  it("discards on the page what came after it when it continues, not while it is displayed", () => {
    const { loop, pass, takeEvents, truncated } = newBench();
    loop.run();
    const [bump] = pass(5);
    expect(bump?.kind).toBe("bump");
    loop.seek(60);
    takeEvents();
    pass(1);
    expect(truncated).toEqual([]);
    loop.editProgram(firstProgram);
    loop.run();
    takeEvents();
    expect(truncated).toEqual([60]);
  });

  it("is reported once for several truncations in a frame, with the earliest", () => {
    const { loop, pass, takeEvents, truncated } = newBench();
    loop.run();
    pass(2);
    for (const tick of [90, 30]) {
      loop.seek(tick);
      loop.run();
    }
    takeEvents();
    expect(truncated).toEqual([30]);
  });

  it("explains the same bump again, and waits for the user again", () => {
    const { loop, pass } = newBench();
    loop.run();
    const [first] = pass(5);
    expect(loop.isRunning).toBe(false);
    loop.seek(60);
    loop.run();
    const [again] = pass(5);
    expect(again).toEqual(first);
    expect(again?.diagnosis).not.toBeNull();
    expect(loop.isRunning).toBe(false);
  });
});

describe("another run", () => {
  it.each([
    { name: "that is begun", begin: (loop: RunLoop) => loop.reset() },
    {
      name: "that is opened",
      begin: (loop: RunLoop) => {
        const saved = loop.saveRun();
        if (saved.ok) loadRun(loop, saved.run);
      },
    },
  ])("$name discards all events on the page", ({ begin }) => {
    const { loop, pass, takeEvents, truncated } = newBench();
    loop.run();
    pass(5);
    begin(loop);
    takeEvents();
    expect(truncated).toEqual([-1]);
  });
});
