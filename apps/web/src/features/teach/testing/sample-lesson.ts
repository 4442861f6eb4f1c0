/** A lesson of two tasks, and hand-ins that pass or fail them. */
import type { LessonDocument, LessonTask } from "@corridor/challenge";
import { encodeLink } from "@corridor/link";
import { mazePresets, type MazePresetId } from "@corridor/maze";
import { programPresets, type ProgramDocument, type ProgramPresetId } from "@corridor/program";

export function mazeOf(id: MazePresetId) {
  const preset = mazePresets.find((each) => each.id === id);
  if (preset === undefined) throw new Error(`no maze ${id}`);
  return preset.maze;
}

export function programOf(id: ProgramPresetId, name: string): ProgramDocument {
  const preset = programPresets.find((each) => each.id === id);
  if (preset === undefined) throw new Error(`no program ${id}`);
  return { ...preset.program, name };
}

export function linkOf(program: ProgramDocument): string {
  const link = encodeLink({ program });
  if (!link.ok) throw new Error(link.code);
  return link.text;
}

/** Right-wall passes; left-wall bumps in maze 2; back-and-forth is too slow. */
export const sampleTask: LessonTask = {
  name: "Two mazes",
  words: { task: "Reach the goal.", short: "Reach the goal", hints: [] },
  mazes: [mazeOf("first-steps"), mazeOf("comb")],
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
  checks: { bumps: 0, seconds: 30 },
  par: null,
  unseen: { kind: "tree", columns: 7, rows: 7, seed: 7, count: 5, pass: 4 },
};

export const sampleLesson: LessonDocument = {
  format: "corridor/challenge",
  version: 2,
  language: "en",
  name: "Two tasks",
  intro: "",
  order: "any",
  tasks: [sampleTask, { ...sampleTask, name: "One maze", unseen: null }],
  survey: [],
};
