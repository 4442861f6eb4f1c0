import type { LessonTask } from "@corridor/challenge";
import { describe, expect, it } from "vitest";
import { programOf } from "../testing/sample-lesson.ts";
import { corridor, taskWith } from "../testing/teacher-task.ts";
import { readSolutions, solutionOf, withSolution } from "../../../model/teaching/solution.ts";

const solution = { lines: 2, ticks: 300, program: programOf("right-wall", "Mine") };
const task = taskWith();
const solutions = withSolution(new Map(), task, solution);
const { allowed } = task;

describe("a solution", () => {
  it.each<[string, Partial<LessonTask>]>([
    ["a name", { name: "Other" }],
    ["a text", { words: { task: "Drive.", short: "", hints: ["Look."] } }],
    ["the name of a maze", { mazes: [{ ...corridor, name: "Other" }] }],
    ["the reference values", { par: { lines: 1, seconds: 2 } }],
    ["the time limit", { checks: { bumps: 0, seconds: 10 } }],
    ["hidden tools and help", { allowed: { ...allowed, tools: [], help: [] } }],
  ])("stays after an edit of %s", (_, change) => {
    expect(solutionOf(solutions, taskWith(change))).toEqual(solution);
  });

  it.each<[string, Partial<LessonTask>]>([
    ["a maze", { mazes: [{ ...corridor, goals: [{ column: 4, row: 1 }] }] }],
    ["the goal", { goal: { kind: "visit" } }],
    ["the bumps", { checks: { bumps: 1, seconds: 120 } }],
    ["the lines", { allowed: { ...allowed, lines: 9 } }],
    ["the start program", { program: programOf("left-wall", "Start") }],
    [
      "the unseen mazes",
      { unseen: { kind: "tree", columns: 5, rows: 5, seed: 1, count: 1, pass: 1 } },
    ],
  ])("is no longer one after an edit of %s", (_, change) => {
    expect(solutionOf(solutions, taskWith(change))).toBeNull();
  });

  it("is read as it was stored, and damaged ones are skipped", () => {
    const text = JSON.stringify([...solutions, ["a", { lines: "2" }], ["b", null], 3]);
    expect(readSolutions(JSON.parse(text))).toEqual(solutions);
    expect(readSolutions({})).toEqual(new Map());
  });

  it("replaces the oldest of many", () => {
    let many = solutions;
    for (let lines = 20; lines < 44; lines++) {
      many = withSolution(many, taskWith({ allowed: { ...allowed, lines } }), solution);
    }
    expect(many.size).toBe(24);
    expect(solutionOf(many, task)).toBeNull();
  });
});
