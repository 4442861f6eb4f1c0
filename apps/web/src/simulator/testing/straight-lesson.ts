/** A lesson of one task in a straight maze and in unseen ones, as the relay sends it. */
import { lessonOfTasks, taskIn } from "@corridor/challenge/testing";
import { mazePresets } from "@corridor/maze";

const task = taskIn(
  mazePresets.slice(1, 2).map(({ maze }) => maze),
  {
    name: "Straight",
    checks: { bumps: 0, seconds: 20 },
    allowed: { lines: 1, actions: ["forward", "turn 180"], edits: ["action"] },
    unseen: { kind: "tree", columns: 33, rows: 33, seed: 7, count: 50, pass: 45 },
  },
);

export const lesson = lessonOfTasks("Sensors", [task], { language: null });
