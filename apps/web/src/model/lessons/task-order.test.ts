import { describe, expect, it } from "vitest";
import { isTaskOpen, nextTask } from "./task-order.ts";
import { sampleLesson } from "./testing/sample-lesson.ts";

const inTurn = { ...sampleLesson, order: "in turn" } as const;
const none = [false, false, false];

describe("the tasks of a lesson", () => {
  it("are all open in any order", () => {
    expect([0, 1, 2].map((index) => isTaskOpen(sampleLesson, none, index))).toEqual([
      true,
      true,
      true,
    ]);
  });

  it.each([
    [none, [true, false, false]],
    [
      [true, false, false],
      [true, true, false],
    ],
    [
      [true, false, true],
      [true, true, true],
    ],
  ])("open in turn: solved %j, open %j", (solved, open) => {
    expect([0, 1, 2].map((index) => isTaskOpen(inTurn, solved, index))).toEqual(open);
  });

  it.each([
    ["the following one", none, 0, 1],
    ["the first that is left", [false, true, true], 2, 0],
    ["none if all are solved", [true, true, true], 0, null],
    ["none if only the open one is left", [true, true, false], 2, null],
    ["the first of a lesson that opens", none, 3, 0],
  ])("lead on to %s", (_, solved, index, next) => {
    expect(nextTask(sampleLesson, solved, index)).toBe(next);
  });

  it("do not lead on to a locked one", () => {
    expect(nextTask(inTurn, none, 0)).toBeNull();
    expect(nextTask(inTurn, [true, false, false], 0)).toBe(1);
  });

  it("are closed beyond those that the teacher has opened", () => {
    const open = (solved: readonly boolean[], openTo: number) =>
      [0, 1, 2].map((index) => isTaskOpen(sampleLesson, solved, index, openTo));
    expect(open(none, 2)).toEqual([true, true, false]);
    expect(open([true, true, true], 1)).toEqual([true, false, false]);
    expect(nextTask(sampleLesson, [true, true, false], 1, 2)).toBeNull();
    expect(nextTask(sampleLesson, [true, true, false], 1, 3)).toBe(2);
  });
});
