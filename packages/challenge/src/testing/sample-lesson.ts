/** A lesson of one task in a given maze and in unseen ones, solved by the paper's right-wall program. */
import type { ProgramDocument } from "@corridor/program";
import { lessonOf, type LessonDocument, type LessonTask } from "../lesson-document.ts";
import { sampleChallenge } from "./sample-challenge.ts";

export const rightWall: ProgramDocument = {
  format: "corridor/program",
  version: 1,
  name: "Right wall",
  default: "forward",
  rules: [
    { when: { sensor: "right", is: ">", than: 60 }, do: "delayed right 90" },
    { when: { sensor: "front", is: "<", than: 50 }, do: "left 90" },
  ],
};

const [plain] = lessonOf(sampleChallenge).tasks as [LessonTask];

export const sampleTask: LessonTask = {
  ...plain,
  program: null,
  allowed: { ...plain.allowed, actions: null },
  checks: { bumps: 0, seconds: 120 },
  unseen: { kind: "tree", columns: 7, rows: 7, seed: 7, count: 5, pass: 4 },
};

export const sampleLesson: LessonDocument = {
  ...lessonOf(sampleChallenge),
  language: "en",
  name: "Every maze",
  intro: "Two lines are enough.",
  tasks: [sampleTask],
  survey: [{ id: "navigation", question: "Did the lines help you to understand navigation?" }],
};
