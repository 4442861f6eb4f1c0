/** Valid documents that a decoder passes to the coding functions, which ignore them. */
import type { LessonDocument, LessonTask } from "@corridor/challenge";
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { RunDocument } from "@corridor/recording";
import type { CompletionCode } from "./completion-code.ts";

export const placeholderMaze: MazeDocument = {
  format: "corridor/maze",
  version: 1,
  name: "",
  blocks: ["."],
  start: { column: 0, row: 0, heading: "north" },
  goals: [],
};

export const placeholderProgram: ProgramDocument = {
  format: "corridor/program",
  version: 1,
  name: "",
  default: "forward",
  rules: [],
};

export const placeholderRun: RunDocument = {
  format: "corridor/run",
  version: 1,
  name: "",
  maze: placeholderMaze,
  program: placeholderProgram,
  seed: 0,
  ticks: 0,
  inputs: [],
  digest: "0000000000000000",
};

export const placeholderTask: LessonTask = {
  name: "",
  words: { task: "", short: "", hints: [] },
  mazes: [placeholderMaze],
  program: null,
  goal: { kind: "reach" },
  allowed: {
    drivers: [],
    lines: 0,
    conditions: null,
    actions: null,
    edits: [],
    maze: false,
    tools: null,
    help: null,
  },
  checks: { bumps: null, seconds: 1 },
  par: null,
  unseen: null,
};

export const placeholderLesson: LessonDocument = {
  format: "corridor/challenge",
  version: 2,
  language: null,
  name: "",
  intro: "",
  order: "any",
  tasks: [placeholderTask],
  survey: [],
};

export const placeholderCode: CompletionCode = {
  lesson: "000000000",
  task: 0,
  attempt: placeholderProgram,
};
