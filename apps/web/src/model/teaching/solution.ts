/**
 * A teacher's own solution of a task. It stays on the device and belongs to the content that it
 * solves: an edit of the mazes, the goal or the rules needs a new one.
 */
import { lessonMark, type LessonTask } from "@corridor/challenge";
import type { ProgramDocument } from "@corridor/program";
import { parseProgram } from "@corridor/program";

export interface Solution {
  /** number of lines; 0 for a drive */
  lines: number;
  /** simulated time in the slowest given maze, in ticks */
  ticks: number;
  /** null for a drive */
  program: ProgramDocument | null;
}

/** Solutions by the mark of what they solve, the newest last. */
export type Solutions = ReadonlyMap<string, Solution>;

/** Maximum number of stored solutions of a lesson. */
const MAX_SOLUTIONS = 24;

const noWords = { task: "", short: "", hints: [] };

/**
 * A hash of everything that decides whether an attempt passes, except the time limit: whether a
 * solution is fast enough is known from its time.
 */
export function contentMark(task: LessonTask): string {
  const { allowed, mazes, checks } = task;
  return lessonMark({
    format: "corridor/challenge",
    version: 2,
    language: null,
    name: "",
    intro: "",
    order: "any",
    tasks: [
      {
        ...task,
        name: "",
        words: noWords,
        par: null,
        mazes: mazes.map((maze) => ({ ...maze, name: "" })),
        program: task.program && { ...task.program, name: "" },
        allowed: { ...allowed, tools: null, help: null },
        checks: { ...checks, seconds: 1 },
      },
    ],
    survey: [],
  });
}

/** The solution of a task as it is now; null if the teacher has not solved it. */
export function solutionOf(solutions: Solutions, task: LessonTask): Solution | null {
  return solutions.get(contentMark(task)) ?? null;
}

/** Adds a solution. The oldest ones are removed. */
export function withSolution(
  solutions: Solutions,
  task: LessonTask,
  solution: Solution,
): Solutions {
  const mark = contentMark(task);
  const others = [...solutions].filter(([each]) => each !== mark);
  return new Map([...others, [mark, solution] as const].slice(-MAX_SOLUTIONS));
}

/** Reads stored solutions. Damaged ones count as none. */
export function readSolutions(input: unknown): Solutions {
  if (!Array.isArray(input)) return new Map();
  const entries: unknown[] = input;
  return new Map(entries.flatMap(readEntry).slice(-MAX_SOLUTIONS));
}

function readEntry(entry: unknown): [string, Solution][] {
  if (!Array.isArray(entry)) return [];
  const [mark, value] = entry as unknown[];
  if (typeof mark !== "string" || typeof value !== "object" || value === null) return [];
  const { lines, ticks, program } = value as Record<string, unknown>;
  if (typeof lines !== "number" || typeof ticks !== "number") return [];
  const read = program === null ? null : parseProgram(program);
  if (read?.ok === false) return [];
  return [[mark, { lines, ticks, program: read?.value ?? null }]];
}
