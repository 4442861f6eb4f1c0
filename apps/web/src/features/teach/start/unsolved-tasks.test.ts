import { expect, it } from "vitest";
import { sampleLesson } from "../../../model/lessons/testing/sample-lesson.ts";
import { withSolution } from "../../../model/teaching/solution.ts";
import { unsolvedTasks } from "./unsolved-tasks.ts";

const [first] = sampleLesson.tasks;
const solution = { lines: 1, ticks: 60, program: null };

it("tasks without a solution on this device are unsolved", () => {
  if (first === undefined) throw new Error("no task");
  expect(unsolvedTasks(sampleLesson, [])).toEqual([1, 2, 3]);
  // The solution of a task counts in every lesson that has the task.
  const solved = { solutions: withSolution(new Map(), first, solution) };
  expect(unsolvedTasks(sampleLesson, [{ solutions: new Map() }, solved])).toEqual([2, 3]);
  const other = { ...first, checks: { ...first.checks, bumps: 7 } };
  expect(unsolvedTasks({ ...sampleLesson, tasks: [other] }, [solved])).toEqual([1]);
});
