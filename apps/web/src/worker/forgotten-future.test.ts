import type { ProgramDocument } from "@corridor/program";
import { describe, expect, it } from "vitest";
import { firstMaze, firstProgram } from "./first-project.ts";
import * as diagnostics from "./diagnose-run.ts";
import { RunLoop } from "./run-loop.ts";
import { loadRun } from "./testing/load-run.ts";
import type { RunEvent } from "./worker-messages.ts";

/** Drives straight on, into the wall. */
const straight: ProgramDocument = { ...firstProgram, rules: [] };

function newBench(program = straight) {
  let time = 0;
  const loop = new RunLoop(firstMaze, program, () => time);
  loop.useDiagnostics(diagnostics);
  const forgotten: number[] = [];
  const news = (): RunEvent[] => {
    const taken = loop.takeNews();
    if (taken === null) return [];
    if (taken.forgottenAfter !== null) forgotten.push(taken.forgottenAfter);
    return taken.moments;
  };
  const pass = (seconds: number) => {
    const moments: RunEvent[] = [];
    for (let i = 0; i < seconds * 60; i++) {
      time += 1000 / 60;
      loop.advance();
      moments.push(...news());
    }
    return moments;
  };
  return { loop, pass, news, forgotten };
}

describe("a run that goes on from an earlier moment", () => {
  it("makes the page forget what came after it when it goes on, not while it is looked at", () => {
    const { loop, pass, news, forgotten } = newBench();
    loop.run();
    const [bump] = pass(5);
    expect(bump?.kind).toBe("bump");
    loop.seek(60);
    news();
    pass(1);
    expect(forgotten).toEqual([]);
    loop.editProgram(firstProgram);
    loop.run();
    news();
    expect(forgotten).toEqual([60]);
  });

  it("says it once for several cuts in a frame, with the earliest", () => {
    const { loop, pass, news, forgotten } = newBench();
    loop.run();
    pass(2);
    for (const tick of [90, 30]) {
      loop.seek(tick);
      loop.run();
    }
    news();
    expect(forgotten).toEqual([30]);
  });

  it("explains the same bump again, and waits for the reader again", () => {
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
  ])("$name makes the page forget all that was told", ({ begin }) => {
    const { loop, pass, news, forgotten } = newBench();
    loop.run();
    pass(5);
    begin(loop);
    news();
    expect(forgotten).toEqual([-1]);
  });
});
