import { checkMaze } from "@corridor/challenge";
import { programPresets } from "@corridor/program";
import { expect, it } from "vitest";
import { lesson } from "../testing/straight-lesson.ts";
import { raceRun } from "./race-run.ts";

const [task] = lesson.tasks;
const [maze] = task?.mazes ?? [];
if (task === undefined || maze === undefined) throw new Error("the sample lesson is empty");

const solution = programPresets.find(({ id }) => id === "right-wall")?.program;
if (solution === undefined) throw new Error("the preset is gone");

it("a raced robot starts at the start, and solves the task on the tick of its check", () => {
  const { ticks, failure } = checkMaze(task, maze, solution, 0);
  const run = raceRun(task, maze, solution);
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
  const program = { ...solution, rules: [], default: "reverse" as const };
  const run = raceRun({ ...task, checks: { seconds: 30, bumps: 0 } }, maze, program);
  expect(run.isSolved).toBe(false);
  expect(run.poses.every((value) => Number.isFinite(value))).toBe(true);
});
