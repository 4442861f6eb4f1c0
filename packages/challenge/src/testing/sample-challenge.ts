/**
 * A small challenge for tests: a corridor with one corner, solvable with two lines without a bump.
 */
import type { ChallengeDocument } from "../challenge-document.ts";

export const sampleChallenge: ChallengeDocument = {
  format: "corridor/challenge",
  version: 1,
  name: "First steps",
  words: { task: "Reach the goal.", short: "Reach the goal", hints: ["Look at front."] },
  mazes: [
    {
      format: "corridor/maze",
      version: 1,
      name: "First steps",
      blocks: ["#######", "#.....#", "#####.#", "#####.#", "#######"],
      start: { column: 1, row: 1, heading: "east" },
      goals: [{ column: 5, row: 3 }],
    },
  ],
  program: {
    format: "corridor/program",
    version: 1,
    name: "Mine",
    default: "forward",
    rules: [
      { when: { sensor: "front", is: "<", than: 50 }, do: "forward" },
      { when: { sensor: "right", is: ">", than: 60 }, do: "forward" },
    ],
  },
  goal: { kind: "reach" },
  allowed: {
    drivers: ["program"],
    lines: 3,
    conditions: ["front <", "right >"],
    actions: ["forward", "right 90", "delayed right 90"],
    edits: ["condition", "number", "action", "otherwise", "order", "lines"],
    maze: false,
  },
  checks: { bumps: 0, seconds: 30 },
  par: { lines: 1, seconds: 10 },
};
