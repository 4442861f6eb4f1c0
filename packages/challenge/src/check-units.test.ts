import { describe, expect, it } from "vitest";
import { checkMazeOf } from "./check-task.ts";
import { checkUnitAt, countCheckUnits, runCheckUnit, type CheckJob } from "./check-units.ts";
import { rightWall, sampleTask } from "./testing/sample-lesson.ts";

const onlyForward = { ...rightWall, rules: [] };
const job: CheckJob = {
  checks: [
    { task: { ...sampleTask, unseen: null }, attempts: [rightWall, onlyForward] },
    { task: sampleTask, attempts: [] },
    { task: sampleTask, attempts: [rightWall] },
  ],
};

describe("the units of a check", () => {
  it("are all attempts in each maze of each task", () => {
    const units = Array.from({ length: countCheckUnits(job) }, (_, unit) => checkUnitAt(job, unit));
    expect(units).toEqual([
      { check: 0, attempt: 0, maze: 0 },
      { check: 0, attempt: 1, maze: 0 },
      ...[0, 1, 2, 3, 4, 5].map((maze) => ({ check: 2, attempt: 0, maze })),
    ]);
  });

  it("run the attempt in the maze", () => {
    expect(runCheckUnit(job, 1)).toEqual(checkMazeOf(sampleTask, 0, onlyForward));
    expect(runCheckUnit(job, 7)).toEqual(checkMazeOf(sampleTask, 5, rightWall));
  });

  it("end with the last one", () => {
    expect(() => checkUnitAt(job, 8)).toThrow(RangeError);
    expect(() => runCheckUnit({ checks: [] }, 0)).toThrow(RangeError);
  });
});
