/** A task for tests, in two given and five unseen mazes, and programs that pass or fail it. */
import { lessonOf, type ChallengeDocument, type LessonTask } from "@corridor/challenge";
import { mazePresets, type MazePresetId } from "@corridor/maze";
import { programPresets, type ProgramDocument, type Rule } from "@corridor/program";

function mazeOf(id: MazePresetId) {
  const preset = mazePresets.find((each) => each.id === id);
  if (preset === undefined) throw new Error(`no maze ${id}`);
  return preset.maze;
}

export function programOf(id: string): ProgramDocument {
  const preset = programPresets.find((each) => each.id === id);
  if (preset === undefined) throw new Error(`no program ${id}`);
  return preset.program;
}

/** Right-wall and farthest-distance pass; left-wall bumps in maze 2; back-and-forth is too slow. */
export const sampleChallenge: ChallengeDocument = {
  format: "corridor/challenge",
  version: 1,
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
  },
  checks: { bumps: 0, seconds: 30 },
  par: null,
};

const [plain] = lessonOf(sampleChallenge).tasks;
if (plain === undefined) throw new Error("no task");

export const sampleTask: LessonTask = {
  ...plain,
  unseen: { kind: "tree", columns: 7, rows: 7, seed: 7, count: 5, pass: 4 },
};

const turn: Rule = { when: { sensor: "front", is: "<", than: 50 }, do: "left 90" };
export const tooLong: ProgramDocument = { ...programOf("right-wall"), rules: Array(4).fill(turn) };
