/** What a teacher reads on the dashboard and the big screen while students work on two tasks. */
import { lessonMark, type LessonDocument } from "@corridor/challenge";
import { encodeLink } from "@corridor/link";
import type { Locator, Page } from "playwright/test";
import { answers } from "../apps/web/src/model/lessons/missions/testing/answers.ts";
import { sampleLesson, sampleTask } from "../apps/web/src/model/lessons/testing/sample-lesson.ts";
import { expect, test } from "./fixtures.ts";
import { DashboardPage } from "./pages/dashboard-page.ts";
import { expectNoAxeViolations } from "./support/axe.ts";
import { ClassTeacher } from "./support/class-teacher.ts";
import { ScriptedStudent } from "./support/scripted-student.ts";

const unseen = { kind: "tree", columns: 11, rows: 11, seed: 7, count: 50, pass: 45 } as const;
const lesson: LessonDocument = {
  ...sampleLesson,
  name: "Two tasks",
  tasks: [
    sampleTask("one-line", "One line"),
    { ...sampleTask("every-maze", "Every maze"), unseen },
  ],
};
const mark = lessonMark(lesson);
const start = { pose: [350, 150, 90] as [number, number, number], path: "" };
const bump = { code: "bump", line: 0 };

/** A class whose dashboard is open, and its students with the first task open. */
async function openClass(page: Page, relay: string, count: number) {
  const teacher = await ClassTeacher.start(relay, null, lesson);
  const { id, teacherKey, screenKey } = teacher.created;
  await page.goto(`/class/${id}#${teacherKey}.${screenKey}`);
  return joinClass(page, relay, teacher, count);
}

/** Students with the first task open, in a class whose dashboard is open. */
async function joinClass(page: Page, relay: string, teacher: ClassTeacher, count: number) {
  const { id, screenKey } = teacher.created;
  const students = [];
  for (let at = 0; at < count; at++) {
    const student = await ScriptedStudent.join(relay, teacher.code);
    student.report({ kind: "opened", lesson: mark, task: 1 });
    student.show(start);
    students.push(student);
  }
  const dashboard = new DashboardPage(page);
  await expect(dashboard.cards).toHaveCount(count);
  const screen = `${relay}/class/${id}#${screenKey}`;
  return { students, dashboard, screen, results: page.getByRole("region", { name: "Results" }) };
}

function solveFirst(student: ScriptedStudent | undefined): void {
  const { solution } = answers["one-line"];
  const link = encodeLink({ completion: { lesson: mark, task: 0, attempt: solution } });
  if (!link.ok) throw new Error(link.code);
  student?.report({ kind: "solved", task: 1, lines: 1, code: link.text });
}

async function boxOf(element: Locator) {
  const box = await element.boundingBox();
  if (box === null) throw new Error("not displayed");
  return { ...box, bottom: box.y + box.height, right: box.x + box.width };
}

function closeAll(students: readonly ScriptedStudent[]): void {
  for (const student of students) student.close();
}

/** The card of a student. */
function cardOf(page: Page, number: number): Locator {
  return page.locator(`[data-student="${number}"]`);
}

test("the letters, then eight students fit a small laptop, and numbers are only of students who have the task open", async ({
  page,
  relay,
}) => {
  await page.setViewportSize({ width: 1366, height: 768 });
  await test.step("the letters, then eight students fit, and nothing moves when a race is possible", () =>
    fillClass(page, relay));
  await test.step("the cards of a pause, and numbers only of students who have the task open", () =>
    pauseClass(page, relay));
});

async function fillClass(page: Page, relay: string): Promise<void> {
  const teacher = await ClassTeacher.start(relay, null, lesson);
  await page.goto(teacher.address());
  // The letters and the whole QR code are in sight until students join.
  const { code } = new DashboardPage(page);
  await expect(code).toContainText("or open the big screen");
  expect((await boxOf(code)).bottom).toBeLessThanOrEqual(768);
  const { students, dashboard, results } = await joinClass(page, relay, teacher, 8);
  const last = page
    .getByRole("list")
    .getByRole("listitem")
    .filter({ has: cardOf(page, 8) });
  expect((await boxOf(last)).bottom).toBeLessThanOrEqual(768);
  const before = await boxOf(results);
  for (const student of students.slice(0, 2)) solveFirst(student);
  await expect(page.getByRole("button", { name: "Race: 2 robots, one maze" })).toBeVisible();
  expect(await boxOf(results)).toEqual(before);
  // The sheet of a student covers neither the letters nor the cards.
  await cardOf(page, 8).click();
  const sheet = await boxOf(dashboard.sheet);
  expect((await boxOf(dashboard.code)).right).toBeLessThanOrEqual(sheet.x);
  expect((await boxOf(last)).right).toBeLessThanOrEqual(sheet.x);
  closeAll(students);
}

async function pauseClass(page: Page, relay: string): Promise<void> {
  const { students, results } = await openClass(page, relay, 3);
  // A run that the pause stopped is an attempt.
  students[0]?.show({ state: "driving", tick: 60 });
  await expect(cardOf(page, 1)).toHaveAccessibleName(/Driving.* 1 attempt$/);
  await page.getByRole("button", { name: "Pause everyone (5 min)" }).click();
  students[0]?.show({ state: "writing", tick: 60 });
  await expect(cardOf(page, 1)).toHaveAccessibleName(/Paused.* 1 attempt$/);
  await page.getByRole("button", { name: "End the pause" }).click();
  await expect(cardOf(page, 1)).toHaveAccessibleName(/Writing.* 1 attempt$/);

  const group = (name: string): Locator =>
    results.locator("dl > div").filter({ has: page.getByText(name, { exact: true }) });
  students[0]?.show({ state: "bumped", bumps: 1, tick: 60 });
  await expect(group("bumped")).toHaveText("bumped1");
  await results.getByRole("combobox").selectOption("Task 2 of 2");
  await expect(group("bumped")).toHaveText("bumped0");
  await expect(group("in another task")).toHaveText("in another task3");
  students[1]?.report({ kind: "opened", lesson: mark, task: 2 });
  students[1]?.show({ task: 2, state: "driving", tick: 5 });
  await expect(group("driving")).toHaveText("driving1");
  await expect(page.getByRole("radio", { name: "Task 2 working 1" })).toBeAttached();
  await page.getByRole("radio", { name: "Another task 2" }).check({ force: true });
  await expect(new DashboardPage(page).cards).toHaveCount(2);
  closeAll(students);
}

test("bumps are on the map at once, and the sheet has the time, the program and the attempts, but no hint once it is solved", async ({
  page,
  relay,
  openWindow,
}) => {
  const { students, dashboard, screen, results } = await openClass(page, relay, 1);
  const { page: board } = await openWindow({ viewport: { width: 1920, height: 1080 } });
  await board.goto(screen);
  const [student] = students;
  student?.report({ kind: "opened", lesson: mark, task: 2 });
  student?.show({ task: 2, tick: 5 });
  await results.getByRole("combobox").selectOption("Task 2 of 2");
  await expect(page.getByText("No bumps yet")).toBeVisible();
  await expect(cardOf(page, 1)).toHaveAccessibleName(/, Task 2,/);
  student?.show({ state: "bumped", bumps: 1, tick: 60 });
  await expect(board.getByText("maze 1: 1", { exact: true })).toBeVisible();
  // Those of checks are there, too.
  student?.report({
    kind: "check",
    task: 2,
    changed: true,
    passes: 30,
    mazes: 51,
    bumpPlaces: [{ maze: "u3", column: 1, row: 1 }],
    failure: bump,
  });
  for (const place of [page, board]) {
    await expect(place.getByText("maze 1: 1, unseen mazes: 1")).toBeVisible();
  }
  await results.getByRole("combobox").selectOption("Task 1 of 2");
  student?.report({ kind: "opened", lesson: mark, task: 1 });
  student?.show({ task: 1, state: "writing", bumps: 0, tick: 0 });

  const run = { kind: "run", task: 1, changed: true, bumps: 1, mistakes: 0 } as const;
  student?.report({ ...run, failure: bump });
  await cardOf(page, 1).click();
  const { sheet } = dashboard;
  await expect(sheet).toContainText("Time on the task:");
  await expect(sheet.getByText("Run: Bump, line 1")).toBeVisible();
  const check = { kind: "check", task: 1, changed: true, passes: 0, mazes: 1 } as const;
  student?.report({ ...check, failure: { code: "late", line: null } });
  await expect(sheet.getByText("Check, 0 of 1 mazes: Time limit reached")).toBeVisible();
  const { solution } = answers["one-line"];
  if (!("rules" in solution)) throw new Error("not a program");
  const link = encodeLink({ program: solution });
  student?.write(link.ok ? link.text : "");
  student?.show({ state: "driving", line: 0, tick: 60 });
  await expect(sheet.getByRole("listitem").filter({ hasText: "if front < 50" })).toBeVisible();
  await sheet.getByRole("button", { name: "Show on big screen" }).click();
  await expect(board.getByText("1 line", { exact: true })).toBeVisible();
  await expect(board.getByRole("list", { name: "Program" })).toContainText("if front < 50");
  await expectNoAxeViolations(board, "a run on the big screen");
  await expect(sheet.getByRole("button", { name: "Show hint 1" })).toBeVisible();
  solveFirst(student);
  await expect(sheet.getByText("Solved", { exact: true })).toBeVisible();
  await expect(sheet.getByRole("button", { name: "Show hint 1" })).toHaveCount(0);
  await expect(board.getByText("most often 1 line: 1 of 1")).toBeVisible();
  await expectNoAxeViolations(page, "the sheet of a student");
  closeAll(students);
});
