/** The lessons with which a teacher begins. */
import { lessonOf, type LessonDocument, type LessonTask } from "@corridor/challenge";
import type { LinkContent } from "@corridor/link";
import { sizeOf, type MazeDocument } from "@corridor/maze";
import type { i18n } from "i18next";
import { missionDocument } from "../../../model/lessons/mission-document.ts";
import type { Mission } from "../../../model/lessons/missions/mission.ts";
import { emptyMaze } from "../../../model/workspace/empty-maze.ts";

/** A maze without blocks, with the goal in the corner opposite the start. */
export function emptyTaskMaze(name: string): MazeDocument {
  const maze = emptyMaze(name);
  return { ...maze, goals: [{ column: sizeOf(maze).columns - 1, row: 0 }] };
}

/** A task in one maze, in which students write a program of their own. */
export function newTask(maze: MazeDocument, name: string): LessonTask {
  return {
    name,
    words: { task: "", short: "", hints: [] },
    mazes: [maze],
    program: null,
    goal: { kind: maze.goals.length > 0 ? "reach" : "visit" },
    allowed: {
      drivers: ["program"],
      lines: 10,
      conditions: null,
      actions: null,
      edits: ["condition", "number", "action", "otherwise", "order", "lines"],
      maze: false,
      tools: null,
      help: null,
    },
    checks: { bumps: 0, seconds: 120 },
    par: null,
    unseen: null,
  };
}

/** A lesson of one task. */
export function newLesson(task: LessonTask, name: string): LessonDocument {
  return {
    format: "corridor/challenge",
    version: 2,
    language: null,
    name,
    intro: "",
    order: "any",
    tasks: [task],
    survey: [],
  };
}

/**
 * A lesson of a shared maze. Students begin with the program that is shared with the maze. They do not
 * begin with that of a run, which may be the solution.
 * @returns null without a maze
 */
export function lessonOfMaze(
  { run, maze = run?.maze, program }: Pick<LinkContent, "maze" | "program" | "run">,
  taskName: string,
): LessonDocument | null {
  if (maze === undefined) return null;
  const task = newTask(maze, taskName);
  const lines = Math.max(task.allowed.lines, program?.rules.length ?? 0);
  return newLesson(
    { ...task, program: program ?? null, allowed: { ...task.allowed, lines } },
    maze.name,
  );
}

/**
 * A copy of a mission in the language of the page.
 * @param words with the namespace "missions" loaded
 */
export function missionLesson(mission: Mission, words: Pick<i18n, "t">): LessonDocument {
  return lessonOf(missionDocument(mission, words));
}
