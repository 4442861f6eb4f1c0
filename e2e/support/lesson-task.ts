/** A small task of a lesson, in a maze that "forward" solves. */
import type { LessonTask } from "@corridor/challenge";

export const straight: LessonTask["mazes"][number] = {
  format: "corridor/maze",
  version: 1,
  name: "Straight on",
  blocks: ["#######", "#.....#", "#######"],
  start: { column: 1, row: 1, heading: "east" },
  goals: [{ column: 5, row: 1 }],
};

/** @param change what differs from a task with three lines in the straight maze */
export function lessonTask(
  name: string,
  hints: string[],
  change: Partial<LessonTask> = {},
): LessonTask {
  return {
    name,
    words: { task: `Solve ${name}.`, short: `Solve ${name}`, hints },
    mazes: [straight],
    program: null,
    goal: { kind: "reach" },
    allowed: {
      drivers: ["program"],
      lines: 3,
      conditions: null,
      actions: null,
      edits: ["condition", "number", "action", "otherwise", "order", "lines"],
      maze: false,
      tools: null,
      help: null,
    },
    checks: { bumps: 0, seconds: 60 },
    par: null,
    unseen: null,
    ...change,
  };
}
