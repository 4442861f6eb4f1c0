import type { Progress } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { noWork, taskOf, withRecord } from "./student-work.ts";
import { record } from "./testing/class-of.ts";

/** The work after these events, one a second. */
function workAfter(...events: Progress[]) {
  return events
    .map((event, at) => record(at + 1, (at + 1) * 1_000, event))
    .reduce(withRecord, noWork(0));
}

const opened: Progress = { kind: "opened", lesson: "0123456ab", task: 1 };
const run = (line: number | null, change: Partial<Extract<Progress, { kind: "run" }>> = {}) =>
  ({
    kind: "run",
    task: 1,
    changed: true,
    bumps: line === null ? 0 : 1,
    mistakes: 0,
    failure: line === null ? null : { code: "bump", line },
    ...change,
  }) satisfies Progress;
const check = (passes: number): Progress => ({
  kind: "check",
  task: 1,
  changed: true,
  passes,
  mazes: 5,
  failure: passes === 5 ? null : { code: "bump", line: 0 },
});
const solved = (code: string): Progress => ({ kind: "solved", task: 1, lines: 2, code });

describe("the work of a student", () => {
  it("counts attempts, runs, bumps, failed checks, hints and mistakes of a task", () => {
    const hint: Progress = { kind: "hint", task: 1, hint: 1 };
    const again = run(0, { changed: false, mistakes: 2 });
    const work = taskOf(workAfter(opened, run(0), again, check(3), check(5), hint, hint), 1);
    expect(work).toMatchObject({
      openedAt: 1_000,
      attempts: 3,
      runs: 2,
      bumps: 2,
      failedChecks: 1,
      hints: 1,
      mistakes: 2,
    });
    expect(work.failures).toEqual([{ code: "bump", line: 0, count: 3 }]);
  });

  it.each([
    { what: "equal failures in a row", events: [run(0), run(0), run(0)], repeats: 3 },
    { what: "a failure of another line", events: [run(0), run(0), run(1)], repeats: 1 },
    { what: "an attempt that did not fail", events: [run(0), run(0), run(null)], repeats: 0 },
    { what: "the same program again", events: [run(0), run(0, { changed: false })], repeats: 1 },
    { what: "a solution", events: [run(0), run(0), solved("a")], repeats: 0 },
    { what: "another task", events: [run(0), run(0), { ...opened, task: 2 }], repeats: 0 },
  ] as { what: string; events: Progress[]; repeats: number }[])(
    "has $repeats repeats after $what",
    ({ events, repeats }) => {
      expect(workAfter(opened, ...events).repeats).toBe(repeats);
    },
  );

  it("knows when the last best result was", () => {
    expect(workAfter(opened, check(2), check(2)).bestAt).toBe(2_000);
    expect(workAfter(opened, check(2), check(3)).bestAt).toBe(3_000);
    expect(workAfter(opened, run(0)).bestAt).toBe(1_000);
  });

  it("has each claim once, with the attempts until then", () => {
    const { claims } = taskOf(workAfter(opened, run(0), solved("a"), solved("a"), solved("b")), 1);
    expect(claims).toEqual([
      { code: "a", lines: 2, attempts: 1, activeAt: 3_000 },
      { code: "b", lines: 2, attempts: 1, activeAt: 5_000 },
    ]);
  });

  it("belongs to the lesson in which a task was opened", () => {
    const other: Progress = { ...opened, lesson: "0123456cd" };
    expect(taskOf(workAfter(opened, run(0), other), 1).attempts).toBe(0);
    expect(taskOf(workAfter(opened, run(0), other, opened, run(0)), 1).attempts).toBe(2);
  });

  it("has the answers to the survey of the open lesson", () => {
    const other: Progress = { ...opened, lesson: "0123456cd" };
    const survey: Progress = { kind: "survey", answers: [{ id: "navigation", answer: 5 }] };
    expect(workAfter(opened, survey, other).answers).toBeNull();
    expect(workAfter(opened, survey, other, opened).answers).toEqual({ navigation: 5 });
  });

  it("has the answers to the survey", () => {
    const answers = [{ id: "navigation", answer: 5 }];
    expect(workAfter({ kind: "survey", answers }).answers).toEqual({ navigation: 5 });
  });
});
