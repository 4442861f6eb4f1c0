/** A small task of a lesson, in a maze that "forward" solves. */
import type { LessonTask } from "@corridor/challenge";
import { taskIn, type TaskChange } from "@corridor/challenge/testing";

export const straight: LessonTask["mazes"][number] = {
  format: "corridor/maze",
  version: 1,
  name: "Straight on",
  blocks: ["#######", "#.....#", "#######"],
  start: { column: 1, row: 1, heading: "east" },
  goals: [{ column: 5, row: 1 }],
};

/** @param change what differs from a task with three lines in the straight maze */
export function lessonTask(name: string, hints: string[], change: TaskChange = {}): LessonTask {
  return taskIn([straight], {
    name,
    words: { task: `Solve ${name}.`, short: `Solve ${name}`, hints },
    checks: { bumps: 0, seconds: 60 },
    ...change,
  });
}
