/** Tasks and lessons of which a test states only what matters to it. */
import type { LessonDocument, LessonTask } from "../lesson-document.ts";

/**
 * A task that a program of at most three lines solves without a bump.
 * @param change what differs from that
 */
export function taskIn(
  mazes: LessonTask["mazes"],
  { allowed, ...change }: TaskChange = {},
): LessonTask {
  return {
    name: "Reach the goal",
    words: { task: "Reach the goal.", short: "Reach the goal", hints: [] },
    mazes,
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
      ...allowed,
    },
    checks: { bumps: 0, seconds: 30 },
    par: null,
    unseen: null,
    ...change,
  };
}

export type TaskChange = Partial<Omit<LessonTask, "allowed">> & {
  allowed?: Partial<LessonTask["allowed"]>;
};

/** @param change what differs from a lesson in any order, without a survey */
export function lessonOfTasks(
  name: string,
  tasks: LessonTask[],
  change: Partial<LessonDocument> = {},
): LessonDocument {
  return {
    format: "corridor/challenge",
    version: 2,
    language: "en",
    name,
    intro: "",
    order: "any",
    tasks,
    survey: [],
    ...change,
  };
}
