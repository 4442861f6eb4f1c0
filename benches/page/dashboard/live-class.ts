/** A class at the relay whose students drive, and the page of its dashboard. */
import { fork } from "node:child_process";
import { once } from "node:events";
import { join } from "node:path";
import type { Browser, Page } from "playwright";
import { ClassTeacher } from "../../../e2e/support/class-teacher.ts";
import { dashboardLesson } from "./dashboard-lesson.ts";
import type { StudentsJob } from "./student-process.ts";

/** All cards of a class of 40 are visible. */
export const VIEWPORT = { width: 1_920, height: 1_600 };

export async function startClass(relay: string): Promise<ClassTeacher> {
  return ClassTeacher.start(relay, null, dashboardLesson());
}

/** @returns a function that ends the students */
export async function startStudents(job: StudentsJob): Promise<() => Promise<void>> {
  const child = fork(join(import.meta.dirname, "student-process.ts"));
  const ended = once(child, "exit");
  child.send(job);
  await Promise.race([
    once(child, "message"),
    ended.then(() => Promise.reject(new Error("the students have ended"))),
  ]);
  return async () => {
    child.disconnect();
    await ended;
  };
}

/** Opens the dashboard, and waits for the cards in view. @param origin of the page */
export async function openDashboard(
  browser: Browser,
  origin: string,
  { created }: ClassTeacher,
  students: number,
): Promise<Page> {
  const page = await browser.newPage({ viewport: VIEWPORT });
  page.setDefaultTimeout(120_000);
  await page.goto(`${origin}/class/${created.id}#${created.teacherKey}`);
  await page.waitForFunction((count) => {
    const cards = document.querySelectorAll("[data-student]").length;
    return cards === count && document.querySelector("main canvas") !== null;
  }, students);
  return page;
}
