import {
  checkedRow,
  checkMazeOf,
  countMazes,
  violationOf,
  violationRow,
  type Attempt,
  type LessonTask,
} from "@corridor/challenge";
import { describe, expect, it } from "vitest";
import { gradedLine, unreadableLine } from "./lesson-lines.ts";
import { programOf, sampleTask, tooLong } from "./testing/sample-task.ts";

function lineOf(task: LessonTask, attempt: Attempt) {
  const graded = { name: "a.json", attempt, number: 2, task };
  const violation = violationOf(task, attempt);
  if (violation !== null) return gradedLine(violationRow(graded, violation), graded);
  const mazes = Array.from({ length: countMazes(task) }, (_, maze) => maze);
  const outcomes = mazes.map((maze) => checkMazeOf(task, maze, attempt));
  return gradedLine(checkedRow(graded, outcomes), graded);
}

const given: LessonTask = { ...sampleTask, unseen: null };
const loops: LessonTask = {
  ...sampleTask,
  mazes: sampleTask.mazes.slice(0, 1),
  unseen: { kind: "loops", columns: 7, rows: 7, seed: 7, count: 5, pass: 4 },
};

describe("the line of a program and a task", () => {
  it("contains the time in the slowest given maze if the program passes", () => {
    expect(lineOf(sampleTask, programOf("right-wall"))).toEqual({
      row: {
        program: "a.json",
        task: 2,
        passed: true,
        code: null,
        maze: null,
        tick: null,
        lines: 2,
        seconds: 13.367,
        unseen: { count: 5, passed: 5, failed: [] },
      },
      message: null,
    });
  });

  it("names the given maze of the first failure", () => {
    const { row, message } = lineOf(given, programOf("left-wall"));
    expect(row).toMatchObject({ passed: false, code: "bump", maze: "maze 2", unseen: null });
    expect(row.seconds).toBeNull();
    expect(row.tick).toBeGreaterThan(0);
    expect(message).toBe("1 bump, at most 0 are allowed");
  });

  it("names the unseen maze of the first failure if all given mazes pass", () => {
    expect(lineOf(loops, programOf("farthest-distance")).row).toMatchObject({
      passed: false,
      code: "not-reached",
      maze: "loops 1 of seed 7",
      tick: 1_800,
      seconds: 7.967,
      unseen: { count: 5, passed: 3, failed: [1, 2] },
    });
  });

  it("lists failed unseen mazes of a program that passes in enough of them", () => {
    expect(lineOf(loops, programOf("left-wall")).row).toMatchObject({
      passed: true,
      code: null,
      maze: null,
      unseen: { count: 5, passed: 4, failed: [4] },
    });
  });

  it("calls a missed goal a time limit, never wrong", () => {
    const { row, message } = lineOf(given, programOf("back-and-forth"));
    expect(row).toMatchObject({ code: "not-reached", maze: "maze 1", tick: 1_800 });
    expect(message).toBe("time limit reached: goal not reached in 30 s; more time may be enough");
  });

  it.each<[LessonTask["goal"], string]>([
    [{ kind: "visit" }, "time limit reached: 4 of 8 open cells visited in 30 s; more time"],
    [{ kind: "drive", distance: 90_000 }, "cm driven in 30 s; more time may be enough"],
    [
      { kind: "stop", sensor: "front", from: 0, to: 1 },
      "time limit reached: robot not stopped within the bounds in 30 s; more time",
    ],
  ])("describes a time limit before the goal %j", (goal, message) => {
    expect(lineOf({ ...given, goal }, programOf("back-and-forth")).message).toContain(message);
  });

  it("has no maze if the task does not allow the program", () => {
    const { row, message } = lineOf(sampleTask, tooLong);
    expect(row).toMatchObject({
      passed: false,
      code: "too-many-lines",
      maze: null,
      tick: null,
      lines: 4,
      seconds: null,
      unseen: null,
    });
    expect(message).toBe("4 lines, at most 3 are allowed");
  });

  it("has no number of lines for a drive, which the task can forbid", () => {
    const drive = [{ tick: 0, command: { action: "forward" as const } }];
    const { row, message } = lineOf(given, drive);
    expect(row).toMatchObject({ passed: false, code: "driver", lines: null });
    expect(message).toBe("the task allows only a program");
    const manual: LessonTask = {
      ...given,
      goal: { kind: "drive", distance: 100 },
      allowed: { ...given.allowed, drivers: ["me"] },
    };
    expect(lineOf(manual, drive).row).toMatchObject({ passed: true, code: null, lines: null });
  });

  it("contains the problem of an unreadable hand-in", () => {
    const { row, message } = unreadableLine("line 3", "link: found nothing, expected a link");
    expect(row).toMatchObject({ program: "line 3", task: null, passed: false, code: "unreadable" });
    expect(row.problem).toBe("link: found nothing, expected a link");
    expect(message).toBe(row.problem);
  });
});
