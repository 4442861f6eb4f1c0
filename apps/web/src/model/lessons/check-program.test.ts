import type { LessonTask } from "@corridor/challenge";
import { describe, expect, it } from "vitest";
import { lines } from "./missions/mission.ts";
import { sampleTask } from "./testing/sample-lesson.ts";
import { checkProgram } from "../../simulator/check-worker/check-program.ts";

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
