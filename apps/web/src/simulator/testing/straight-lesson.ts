/** A lesson of one task in a straight maze and in unseen ones, as the relay sends it. */
import type { LessonDocument } from "@corridor/challenge";
import { mazePresets } from "@corridor/maze";

const task: LessonDocument["tasks"][number] = {
  name: "Straight",
  words: { task: "Reach the goal.", short: "Reach the goal", hints: [] },
  mazes: mazePresets.slice(1, 2).map(({ maze }) => maze),
  goal: { kind: "reach" },
  program: null,
  checks: { bumps: 0, seconds: 20 },
  allowed: {
    drivers: ["program"],
    lines: 1,
    conditions: null,
    actions: ["forward", "turn 180"],
    edits: ["action"],
    maze: false,
    tools: null,
    help: null,
  },
  par: null,
  unseen: { kind: "tree", columns: 33, rows: 33, seed: 7, count: 50, pass: 45 },
};

export const lesson: LessonDocument = {
  format: "corridor/challenge",
  version: 2,
  language: null,
  name: "Sensors",
  intro: "",
  order: "any",
  tasks: [task],
  survey: [],
};
