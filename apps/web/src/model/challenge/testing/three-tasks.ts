/** A lesson of three tasks for tests that need only its outline: the same corridor three times. */
import { lessonOf, taskOf, type ChallengeDocument, type LessonDocument } from "@corridor/challenge";

const corridor: ChallengeDocument = {
  format: "corridor/challenge",
  version: 1,
  name: "Straight on",
  words: { task: "Reach the goal.", short: "Reach the goal", hints: [] },
  mazes: [
    {
      format: "corridor/maze",
      version: 1,
      name: "Straight on",
      blocks: ["#####", "#...#", "#####"],
      start: { column: 1, row: 1, heading: "east" },
      goals: [{ column: 3, row: 1 }],
    },
  ],
  program: null,
  goal: { kind: "reach" },
  allowed: {
    drivers: ["program"],
    lines: 1,
    conditions: null,
    actions: null,
    edits: ["lines"],
    maze: false,
  },
  checks: { bumps: 0, seconds: 60 },
  par: null,
};

export const threeTasks: LessonDocument = {
  ...lessonOf(corridor),
  tasks: ["One", "Two", "Three"].map((name) => ({ ...taskOf(corridor), name })),
};
