import type { LessonTask } from "@corridor/challenge";
import { describe, expect, it } from "vitest";
import { lines } from "./missions/mission.ts";
import { FakePoolWorker } from "../../simulator/testing/fake-pool-worker.ts";
import { WorkerPool } from "../../simulator/worker-pool.ts";
import { ProgramCheck, type CheckEnd } from "./program-check.ts";
import { checkProgram } from "./testing/check-program.ts";
import { sampleTask } from "./testing/sample-lesson.ts";

const unseen = { kind: "tree", columns: 11, rows: 11, seed: 7, count: 5, pass: 5 } as const;
const task: LessonTask = {
  ...sampleTask("every-maze", "Every maze"),
  unseen,
  checks: { bumps: 0, seconds: 900 },
};
const rightWall = lines(
  "forward",
  { when: { sensor: "right", is: ">", than: 60 }, do: "delayed right 90" },
  { when: { sensor: "front", is: "<", than: 50 }, do: "left 90" },
);

describe("the check of a program", () => {
  it("passes in the given and the unseen mazes", () => {
    const { verdict } = checkProgram({ task, program: rightWall });
    expect(verdict).toMatchObject({ passed: true, failure: null, unseenFailures: [] });
    expect(verdict.mazes).toHaveLength(task.mazes.length);
  });

  it("fails where too few unseen mazes pass, and says why in the first of them", () => {
    const straight = sampleTask("one-line", "One line");
    const alone: LessonTask = { ...straight, unseen, checks: task.checks };
    const program = lines("forward", {
      when: { sensor: "front", is: "<", than: 50 },
      do: "turn 180",
    });
    const { verdict, diagnoses, unseenDiagnosis } = checkProgram({ task: alone, program });
    expect(verdict).toMatchObject({ passed: false, failedUnseen: 1 });
    expect(verdict.failure?.maze).toBeNull();
    expect(diagnoses).toEqual([null]);
    expect(unseenDiagnosis).not.toBeNull();
  });

  it("names no line where the task hides what caused a failure", () => {
    const allowed = { ...task.allowed, help: ["truth" as const] };
    const { diagnoses } = checkProgram({ task: { ...task, allowed }, program: lines("forward") });
    expect(diagnoses[0]).toMatchObject({ event: { kind: "bump", line: null }, cause: null });
  });

  it("runs nothing if the task does not allow the program", () => {
    const program = lines("forward", ...rightWall.rules, ...rightWall.rules, ...rightWall.rules);
    const { verdict } = checkProgram({ task, program });
    expect(verdict).toMatchObject({
      passed: false,
      mazes: [],
      failure: { code: "too-many-lines" },
    });
  });
});

describe("the progress of a check", () => {
  function setUp() {
    const workers: FakePoolWorker[] = [];
    const due: (() => void)[] = [];
    const ends: CheckEnd[] = [];
    const pool = new WorkerPool(() => {
      const worker = new FakePoolWorker();
      workers.push(worker);
      return worker;
    }, 2);
    const check = new ProgramCheck(pool, (show) => due.push(show));
    return {
      check,
      workers,
      ends,
      start: (program = rightWall) => check.start({ task, program }, (end) => ends.push(end)),
      /** Shows what is due. */
      pass: () => {
        for (const show of due.splice(0)) show();
      },
      answerAll: () => {
        while (workers.filter((worker) => worker.answer()).length > 0);
      },
      progress: () => check.progress.getState(),
    };
  }

  it("shows the first maze at once, the others together, and the end at once", () => {
    const { start, workers, pass, answerAll, progress } = setUp();
    start();
    expect(progress()).toMatchObject({ state: "running", done: 0, count: 8 });
    workers[1]?.answer();
    expect(progress().done).toBe(1);
    workers[0]?.answer();
    workers[1]?.answer();
    expect(progress().done).toBe(1);
    pass();
    expect(progress()).toMatchObject({ done: 3, passed: 3, first: null });
    answerAll();
    expect(progress()).toMatchObject({ state: "done", done: 8, passed: 8, failures: [] });
    // The first mazes are given.
    const { passes } = progress();
    expect(passes.map(({ maze }) => maze)).toEqual([3, 4, 5, 6, 7]);
    expect(Math.min(...passes.map(({ ticks }) => ticks))).toBeGreaterThan(0);
  });

  it("names the first failure in the order of the mazes, whichever worker ends first", () => {
    const { start, workers, pass, answerAll, progress } = setUp();
    start(lines("forward"));
    workers[1]?.answer();
    workers[1]?.answer();
    pass();
    expect(progress().first).toBeNull();
    answerAll();
    const { first, failures, passed, passes } = progress();
    expect([first?.maze, passed + failures.length]).toEqual([0, 8]);
    expect(passes).toHaveLength(passed);
    expect(failures.map(({ maze }) => maze)).toEqual(
      failures.map(({ maze }) => maze ?? 0).toSorted((one, other) => one - other),
    );
  });

  it("ends with the verdict alone if another job takes the workers from its diagnosis", () => {
    const { check, start, workers, ends } = setUp();
    start(lines("forward"));
    while (check.progress.getState().state === "running") {
      for (const worker of workers) worker.answer();
    }
    check.pool.stop();
    expect(ends).toMatchObject([
      { ok: true, answer: { verdict: { passed: false }, diagnoses: [null, null, null] } },
    ]);
  });

  it("ends as failed if a worker does not load", () => {
    const { start, workers, ends, progress } = setUp();
    start();
    workers[0]?.onerror?.({ message: "" } as ErrorEvent);
    expect([ends, progress().state]).toEqual([[{ ok: false, reason: "failed" }], "idle"]);
  });

  it("starts no more workers than a task has mazes", () => {
    const { check, workers } = setUp();
    const [maze] = task.mazes;
    if (maze === undefined) throw new Error("no maze");
    check.prepare({ ...task, mazes: [maze], unseen: null });
    expect(workers).toHaveLength(1);
  });
});
