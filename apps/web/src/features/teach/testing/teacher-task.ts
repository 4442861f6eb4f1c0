/** A task of a straight corridor of five squares, as a teacher begins it. */
import type { LessonTask } from "@corridor/challenge";
import type { MazeDocument } from "@corridor/maze";
import { newLesson, newTask } from "../lessons/new-lesson.ts";

export const corridor: MazeDocument = {
  format: "corridor/maze",
  version: 1,
  name: "Corridor",
  blocks: ["#######", "#.....#", "#######"],
  start: { column: 1, row: 1, heading: "east" },
  goals: [{ column: 5, row: 1 }],
};

export function taskWith(change: Partial<LessonTask> = {}): LessonTask {
  return { ...newTask(corridor, "Straight on"), ...change };
}

export function lessonWith(...tasks: [LessonTask, ...LessonTask[]]) {
  return { ...newLesson(tasks[0], "Corridors"), tasks };
}
