import type { LessonTask } from "@corridor/challenge";
import { expect, it } from "vitest";
import { withSolution, type Solution } from "../../../model/teaching/solution.ts";
import { programOf } from "../testing/sample-lesson.ts";
import { corridor, lessonWith, taskWith } from "../testing/teacher-task.ts";
import { warningsOf } from "./lesson-warnings.ts";

const closed = { ...corridor, blocks: ["#######", "#..#..#", "#######"] };
const noGoal = { ...corridor, goals: [] };
const twoLines = programOf("right-wall", "Two lines");
const seconds = (limit: number) => ({ bumps: 0, seconds: limit });
const { allowed } = taskWith();
const byHand = { ...allowed, drivers: ["me" as const] };

const cases: [string, Partial<LessonTask>, string[]][] = [
  ["nothing, in a task that can be solved", {}, ["unsolved"]],
  ["a maze without the goal to reach", { mazes: [corridor, noGoal] }, ["no-goal 2", "unsolved"]],
  ["a goal without a path", { mazes: [corridor, closed] }, ["no-path 2", "unsolved"]],
  [
    "squares without a path, where every square must be visited",
    { mazes: [closed], goal: { kind: "visit" } },
    ["closed-squares 1", "unsolved"],
  ],
  [
    "no path, where none is needed",
    { mazes: [closed], goal: { kind: "last", seconds: 9 } },
    ["unsolved"],
  ],
  [
    "fewer lines than the start program has",
    { program: twoLines, allowed: { ...allowed, lines: 1 } },
    ["too-few-lines", "unsolved"],
  ],
  ["just enough lines", { program: twoLines, allowed: { ...allowed, lines: 2 } }, ["unsolved"]],
  // Four squares: the robot is inside the goal's square after 375 cm, which take 3.75 s.
  [
    "less time than the way to the goal needs",
    { checks: seconds(3) },
    ["too-little-time 1", "unsolved"],
  ],
  ["just enough time", { checks: seconds(4) }, ["unsolved"]],
  [
    "a time that a diagonal may save, for other drivers than a program",
    { checks: seconds(3), allowed: byHand },
    ["unsolved"],
  ],
  [
    "less time than a distance needs",
    { goal: { kind: "drive", distance: 301 }, checks: seconds(3) },
    ["too-little-time 1", "unsolved"],
  ],
  [
    "less time than all squares need",
    { goal: { kind: "visit" }, checks: seconds(3) },
    ["too-little-time 1", "unsolved"],
  ],
];

function codes(task: LessonTask, solution: Solution | null = null): string[] {
  const solutions = solution === null ? new Map() : withSolution(new Map(), task, solution);
  return warningsOf(lessonWith(task), solutions).map(({ code, maze }) =>
    maze === null ? code : `${code} ${maze + 1}`,
  );
}

it.each(cases)("warns of %s", (_, change, expected) => {
  expect(codes(taskWith(change))).toEqual(expected);
});

it("warns of a time limit below the teacher's solution, and of no other", () => {
  const solution = { lines: 1, ticks: 301, program: twoLines };
  expect(codes(taskWith({ checks: seconds(5) }), solution)).toEqual(["slower-solution"]);
  expect(codes(taskWith({ checks: seconds(6) }), solution)).toEqual([]);
});

it("names the task of each warning", () => {
  const lesson = lessonWith(taskWith(), taskWith({ mazes: [noGoal] }));
  expect(warningsOf(lesson, new Map()).map(({ task, code }) => [task, code])).toEqual([
    [0, "unsolved"],
    [1, "no-goal"],
    [1, "unsolved"],
  ]);
});

it("warns of a lesson without a name first", () => {
  const lesson = { ...lessonWith(taskWith()), name: " " };
  expect(warningsOf(lesson, new Map())).toEqual([
    { code: "unnamed", task: null, maze: null },
    { code: "unsolved", task: 0, maze: null },
  ]);
});
