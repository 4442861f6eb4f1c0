/** The line and the progress that the page displays where a run has ended. */
import type { ChallengeDocument } from "@corridor/challenge";
import type { ProgramDocument } from "@corridor/program";
import { describe, expect, it } from "vitest";
import { challengeOf } from "./mission.ts";
import { missions } from "./missions.ts";
import { firstMaze } from "../../../simulator/protocol/first-project.ts";
import * as diagnostics from "../../../simulator/worker/diagnose-run.ts";
import { RunJudge } from "../../../simulator/worker/run-judge.ts";
import { Bench } from "../../../simulator/worker/testing/bench.ts";
import { loadRun } from "../../../simulator/worker/testing/load-run.ts";

/** Turns around only where the robot touches the wall already. */
const tooLate: ProgramDocument = {
  format: "corridor/program",
  version: 1,
  name: "Too late",
  default: "forward",
  rules: [{ when: { sensor: "front", is: "<", than: 26 }, do: "turn 180" }],
};

/** Mission 1 in the first maze. */
function challengeIn(seconds: number, bumps: number | null): ChallengeDocument {
  const [mission] = missions;
  if (mission === undefined) throw new Error("no mission");
  return {
    ...challengeOf(mission, "Short", { task: "", short: "", hints: [] }),
    mazes: [firstMaze],
    checks: { bumps, seconds },
  };
}

/** A run of a program, paused where it ended. */
function ended(program: ProgramDocument, challenge?: ChallengeDocument): Bench {
  const bench = new Bench(firstMaze, program);
  if (challenge !== undefined) bench.loop.updates.judgeBy(new RunJudge(challenge, 0));
  bench.loop.run();
  bench.pass(60_000);
  return bench;
}

/** A challenge whose time ends where the program chooses a turn. */
function shortChallenge(): { program: ProgramDocument; challenge: ChallengeDocument } {
  const program: ProgramDocument = {
    ...tooLate,
    rules: [{ when: { sensor: "front", is: "<", than: 60 }, do: "delayed right 90" }],
  };
  const { loop } = new Bench(firstMaze, program);
  while (loop.recording.run.line === "default") loop.recording.step();
  return { program, challenge: challengeIn((loop.recording.run.tick - 1) / 60, null) };
}

describe("where a run has ended", () => {
  it("at a wall, the line that drove into it is displayed, and no turn that has not begun", () => {
    const bench = ended(tooLate);
    expect(bench.loop.recording.run.line).toBe(0);
    expect(bench.frame()).toMatchObject({
      hasEnded: true,
      progress: null,
      snapshot: { bumps: 1, bumping: true, state: "paused", line: "default" },
    });
  });

  it("at the end of the time, the displayed line is the one that its readings make true", () => {
    const { program, challenge } = shortChallenge();
    const frame = ended(program, challenge).frame();
    expect(frame).toMatchObject({
      hasEnded: false,
      snapshot: { bumps: 0, state: "paused", line: 0 },
    });
    expect(frame?.snapshot.sensors.front).toBeLessThan(60);
  });

  it("a script still receives the line that decides next", () => {
    expect(ended(tooLate).loop.snapshot().line).toBe(0);
  });

  it("the same line is displayed when the run is opened again", () => {
    const saved = ended(tooLate).loop.saveRun();
    if (!saved.ok) throw new Error(saved.reason);
    const other = new Bench();
    loadRun(other.loop, saved.run);
    expect(other.frame()).toMatchObject({ hasEnded: true, snapshot: { line: "default" } });
  });

  it("the line that decides next is displayed as soon as the run goes on", () => {
    const bench = ended(tooLate);
    bench.loop.run();
    expect(bench.loop.updates.take()?.frame).toMatchObject({
      hasEnded: false,
      progress: { left: 180 },
      snapshot: { state: "running", line: 0 },
    });
  });

  it("an edit shows what the new program would do there", () => {
    const bench = ended(tooLate);
    const rule = { when: { sensor: "front", is: "<", than: 200 }, do: "left 90" } as const;
    bench.loop.editProgram({ ...tooLate, rules: [rule] });
    expect(bench.frame()).toMatchObject({ hasEnded: false, snapshot: { line: 0 } });
  });

  it("an earlier tick shows the line that drives on from it", () => {
    const bench = ended(tooLate);
    bench.loop.seek(bench.loop.recording.run.tick - 10);
    expect(bench.frame()).toMatchObject({ hasEnded: false, snapshot: { line: "default" } });
    bench.loop.now();
    expect(bench.frame()).toMatchObject({ hasEnded: true, snapshot: { line: "default" } });
  });
});

describe("a failed run", () => {
  function bumpedWhileLoading() {
    const bench = new Bench(firstMaze, tooLate);
    bench.loop.updates.awaitDiagnostics(true);
    bench.loop.updates.judgeBy(new RunJudge(challengeIn(60, 0), 0));
    bench.loop.run();
    bench.pass(60_000);
    return bench.loop;
  }

  it("is reported only together with its explanation, which may still load", () => {
    const loop = bumpedWhileLoading();
    expect(loop.updates.takeJudgement()).toBeNull();
    loop.updates.useDiagnostics(diagnostics);
    expect(loop.updates.takeJudgement()).toMatchObject({ kind: "failed", code: "bump" });
  });

  it("is reported without an explanation if none can load", () => {
    const loop = bumpedWhileLoading();
    loop.updates.awaitDiagnostics(false);
    expect(loop.updates.takeJudgement()).toMatchObject({ kind: "failed", code: "bump" });
  });
});
