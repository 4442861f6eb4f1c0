/** A lesson of three tasks for tests that need only its outline: the same corridor three times. */
import { lessonOfTasks, taskIn } from "@corridor/challenge/testing";
import type { MazeDocument } from "@corridor/maze";

const corridor: MazeDocument = {
  format: "corridor/maze",
  version: 1,
  name: "Straight on",
  blocks: ["#####", "#...#", "#####"],
  start: { column: 1, row: 1, heading: "east" },
  goals: [{ column: 3, row: 1 }],
};

export const threeTasks = lessonOfTasks(
  "Straight on",
  ["One", "Two", "Three"].map((name) =>
    taskIn([corridor], {
      name,
      allowed: { lines: 1, edits: ["lines"] },
      checks: { bumps: 0, seconds: 60 },
    }),
  ),
  { language: null },
);
