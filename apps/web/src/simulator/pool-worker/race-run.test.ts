import { checkMaze, type LessonTask } from "@corridor/challenge";
import type { MazeDocument } from "@corridor/maze";
import { programPresets } from "@corridor/program";
import { expect, it } from "vitest";
import { raceRun } from "./race-run.ts";

const found = programPresets.find(({ id }) => id === "right-wall");
if (found === undefined) throw new Error("the preset is gone");
const maze: MazeDocument = {
  format: "corridor/maze",
  version: 1,
  name: "Corner",
  blocks: ["#####", "#...#", "#.#.#", "#.#.#", "#####"],
  start: { column: 1, row: 3, heading: "north" },
  goals: [{ column: 3, row: 3 }],
};
const task: LessonTask = {
  name: "Corner",
  words: { task: "Reach the goal.", short: "Reach the goal", hints: [] },
  mazes: [maze],
  program: null,
  goal: { kind: "reach" },
  allowed: {
    drivers: ["program"],
    lines: 3,
    conditions: null,
    actions: null,
    edits: ["lines"],
    maze: false,
    tools: null,
    help: null,
  },
  checks: { bumps: 0, seconds: 120 },
  unseen: null,
  par: null,
};

it("a raced robot starts at the start, and solves the task on the tick of its check", () => {
  const { ticks, failure } = checkMaze(task, maze, found.program, 0);
  const run = raceRun(task, maze, found.program);
  expect(run).toMatchObject({ ticks, isSolved: failure === null });
  const { column, row } = maze.start;
  expect(Array.from(run.poses.slice(0, 2))).toEqual([column * 100 + 50, row * 100 + 50]);
  expect(run.poses).toHaveLength(3 * (Math.ceil(ticks / 6) + 1));
  const [goal] = maze.goals;
  if (failure !== null || goal === undefined) throw new Error("the sample is not solved");
  const [x = 0, y = 0] = run.poses.slice(-3);
  expect([Math.floor(x / 100), Math.floor(y / 100)]).toEqual([goal.column, goal.row]);
});

it("a robot whose program fails stays where it failed", () => {
  const program = { ...found.program, rules: [], default: "forward" as const };
  const run = raceRun({ ...task, checks: { seconds: 30, bumps: 0 } }, maze, program);
  expect(run.isSolved).toBe(false);
  expect(run.poses.every((value) => Number.isFinite(value))).toBe(true);
});
