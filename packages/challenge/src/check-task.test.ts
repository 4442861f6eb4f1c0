import { describe, expect, it } from "vitest";
import { generateMaze } from "@corridor/maze";
import { checkMazeOf, countMazes, mazeOf, taskVerdict, type TaskVerdict } from "./check-task.ts";
import type { Attempt } from "./check-challenge.ts";
import type { LessonTask } from "./lesson-document.ts";
import { rightWall, sampleTask } from "./testing/sample-lesson.ts";

function check(task: LessonTask, attempt: Attempt): TaskVerdict {
  const outcomes = Array.from({ length: countMazes(task) }, (_, index) =>
    checkMazeOf(task, index, attempt),
  );
  return taskVerdict(task, outcomes);
}

const onlyForward = { ...rightWall, rules: [] };

describe("the mazes of a task", () => {
  it("are the given ones, then those that anybody can generate from kind, size and seed", () => {
    expect(countMazes(sampleTask)).toBe(6);
    expect(mazeOf(sampleTask, 0)).toBe(sampleTask.mazes[0]);
    const name = "tree 5 of seed 7";
    const fifth = generateMaze({ kind: "tree", columns: 7, rows: 7, seed: 7_005, name });
    expect(mazeOf(sampleTask, 5)).toEqual(fifth);
    expect(() => mazeOf(sampleTask, 6)).toThrow(RangeError);
    expect(countMazes({ ...sampleTask, unseen: null })).toBe(1);
  });
});

describe("a check of a task", () => {
  it("passes a program that solves the given and all unseen mazes", () => {
    const passed = { passed: true, failure: null, failedUnseen: null, unseenFailures: [] };
    expect(check(sampleTask, rightWall)).toEqual(passed);
  });

  it("reports the first failure in a given maze, and every unseen maze that fails", () => {
    const verdict = check(sampleTask, onlyForward);
    expect(verdict).toMatchObject({ passed: false, failedUnseen: null });
    expect(verdict.failure).toMatchObject({ code: "bump", maze: 0 });
    expect(verdict.unseenFailures.map(({ number }) => number)).toEqual([1, 2, 3, 4, 5]);
  });

  it("passes with fewer unseen mazes than there are if the task says so", () => {
    const unseen = { kind: "loops", columns: 9, rows: 9, seed: 1, count: 20, pass: 20 } as const;
    const lenient = { ...sampleTask, checks: { bumps: 0, seconds: 25 } };
    const strict = check({ ...lenient, unseen }, rightWall);
    const passing = 20 - strict.unseenFailures.length;
    expect(passing).toBeGreaterThan(0);
    expect(passing).toBeLessThan(20);
    const [first] = strict.unseenFailures;
    expect(strict).toMatchObject({ passed: false, failure: first?.failure });
    expect(strict.failedUnseen).toBe(first?.number);
    expect(strict.failure).toMatchObject({ code: "not-reached", maze: null, tick: 1_500 });
    const enough = check({ ...lenient, unseen: { ...unseen, pass: passing } }, rightWall);
    expect(enough).toMatchObject({ passed: true, failure: null });
    expect(enough.unseenFailures).toEqual(strict.unseenFailures);
    const oneMore = check({ ...lenient, unseen: { ...unseen, pass: passing + 1 } }, rightWall);
    expect(oneMore.passed).toBe(false);
  });
});
