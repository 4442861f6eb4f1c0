/** One document of each kind that a short link can store. */
import type { ChallengeDocument, LessonDocument } from "@corridor/challenge/document";
import type { ProjectDocument } from "@corridor/link/project";
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";

export const maze: MazeDocument = {
  format: "corridor/maze",
  version: 1,
  name: "First steps",
  blocks: ["#####", "#...#", "#####"],
  start: { column: 1, row: 1, heading: "east" },
  goals: [{ column: 3, row: 1 }],
};

export const program: ProgramDocument = {
  format: "corridor/program",
  version: 1,
  name: "Right wall",
  default: "forward",
  rules: [
    { when: { sensor: "right", is: ">", than: 62.5 }, do: "delayed right 90" },
    { when: { sensor: "left", is: "<", than: "right", plus: -10 }, do: "forward" },
    { when: null, do: "left 90" },
  ],
};

export const challenge: ChallengeDocument = {
  format: "corridor/challenge",
  version: 1,
  name: "Drive there",
  words: { task: "Drive to the goal.", short: "Drive", hints: ["Hold the key."] },
  mazes: [maze],
  program,
  goal: { kind: "reach" },
  allowed: {
    drivers: ["program"],
    lines: 5,
    conditions: null,
    actions: null,
    edits: ["action"],
    maze: false,
  },
  checks: { bumps: 0, seconds: 20 },
  par: null,
};

export const lesson: LessonDocument = {
  format: "corridor/challenge",
  version: 2,
  language: "en",
  name: "Two tasks",
  intro: "",
  order: "in turn",
  tasks: [1, 2].map((number) => ({
    name: `Task ${number}`,
    words: challenge.words,
    mazes: [maze],
    program: null,
    goal: { kind: "reach" },
    allowed: { ...challenge.allowed, tools: ["speed"], help: null },
    checks: { bumps: 0, seconds: 3_600 },
    par: null,
    unseen: { kind: "tree", columns: 11, rows: 11, seed: 7, count: 50, pass: 45 },
  })),
  survey: [{ id: "navigation", question: "Did it help?" }],
};

export const project: ProjectDocument = { format: "corridor/project", version: 1, maze, program };
