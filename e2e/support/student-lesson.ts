/** A lesson of two tasks, and the page of a student who has it open. */
import type { LessonTask } from "@corridor/challenge";
import { lessonOfTasks } from "@corridor/challenge/testing";
import type { Page } from "playwright/test";
import type { CorridorPage } from "../pages/corridor-page.ts";
import type { Lesson } from "../pages/lesson-card.ts";
import { lessonTask, straight } from "./lesson-task.ts";

export const side: LessonTask["mazes"][number] = {
  ...straight,
  name: "Side opening",
  blocks: ["#######", "#.....#", "###.###", "###.###", "#######"],
  goals: [{ column: 3, row: 3 }],
};

export function taskOf(name: string, change: Partial<LessonTask> = {}): LessonTask {
  return lessonTask(name, ["Look at right."], change);
}

const tasks = [taskOf("Straight on"), taskOf("Side opening", { mazes: [side] })];
export const lesson = lessonOfTasks("Two mazes, three lines", tasks, {
  intro: "Write short programs.",
});

/** A student's page and its lesson. */
export interface Opened {
  corridor: CorridorPage;
  page: Page;
  opened: Lesson;
}
