/** A class with one small task, its dashboard, and what its students report. */
import { lessonMark, type LessonDocument } from "@corridor/challenge";
import { encodeLink } from "@corridor/link";
import type { Locator, Page } from "playwright/test";
import { answers } from "../../apps/web/src/model/lessons/missions/testing/answers.ts";
import {
  sampleLesson,
  sampleTask,
} from "../../apps/web/src/model/lessons/testing/sample-lesson.ts";
import { expect } from "../fixtures.ts";
import { ClassTeacher } from "./class-teacher.ts";
import type { ScriptedStudent } from "./scripted-student.ts";

const NAMES = ["Team 1", "Team 2", "Team 3", "Team 4", "Team 5"];

const lesson: LessonDocument = {
  ...sampleLesson,
  name: "One line",
  tasks: [sampleTask("one-line", "One line")],
};
/** For the task of the lesson. */
export const { solution, wrong } = answers["one-line"];

export const opened = { kind: "opened", lesson: lessonMark(lesson), task: 1 } as const;

/** A claim that the task is solved. */
export function claim(attempt: typeof solution = solution) {
  const completion = { lesson: lessonMark(lesson), task: 0, attempt };
  const link = encodeLink({ completion });
  if (!link.ok) throw new Error(link.code);
  return { kind: "solved", task: 1, lines: 1, code: link.text } as const;
}

export async function startClass(relay: string): Promise<ClassTeacher> {
  return ClassTeacher.start(relay, NAMES, lesson);
}

/** A class whose dashboard is open. */
export async function openDashboard(page: Page, relay: string): Promise<ClassTeacher> {
  const teacher = await startClass(relay);
  await page.goto(`/class/${teacher.created.id}#${teacher.created.teacherKey}`);
  await expect(page.getByRole("heading", { name: "One line" })).toBeVisible();
  return teacher;
}

export function nameOf(student: ScriptedStudent): string {
  return student.joined.name.text ?? "";
}

export function cardOf(page: Page, student: ScriptedStudent): Locator {
  return page.getByRole("button", { name: new RegExp(`^${nameOf(student)}, `) });
}
