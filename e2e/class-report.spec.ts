/** How the lesson of a class ends: its report, and the links of its dashboard. */
import { readFile } from "node:fs/promises";
import { lessonMark } from "@corridor/challenge";
import { lessonOfTasks } from "@corridor/challenge/testing";
import type { Page } from "playwright/test";
import { shownCode } from "../apps/web/src/model/classes/shown-code.ts";
import { expect, test } from "./fixtures.ts";
import { expectNoAxeViolations } from "./support/axe.ts";
import { ClassTeacher } from "./support/class-teacher.ts";
import { lessonTask } from "./support/lesson-task.ts";
import {
  cardOf,
  claim,
  nameOf,
  opened,
  openDashboard,
  startClass,
} from "./support/one-line-class.ts";
import { ScriptedStudent } from "./support/scripted-student.ts";
import { wideWindow } from "./support/window-sizes.ts";

test.use(wideWindow);

test("the report opens during the lesson, which ends with one, or leads to it, and links open only their own class", async ({
  page,
  pageErrors,
  relay,
}) => {
  await test.step("the report opens during the lesson, which ends with one, and then nothing is left", () =>
    endWithReport(page, relay));
  await test.step("a lesson that ended without a saved report still leads to it", () =>
    endWithoutReport(page, relay));
  await test.step("each lesson of one class has its own report, on the device and as a file", () =>
    saveTwoLessons(page, relay));
  pageErrors.ignoreFailedRequests();
  await test.step("links of the dashboard: with the keys, without one, and with that of another class", () =>
    openLinks(page, relay));
});

async function endWithReport(page: Page, relay: string): Promise<void> {
  const teacher = await openDashboard(page, relay);
  const foot = page.getByRole("main").getByRole("button", { name: "Report" });
  await expect(page.getByRole("main").getByRole("button", { name: "End lesson" })).toBeVisible();
  await expect(foot).toHaveCount(0);
  const joinAndOpenReport = async (): Promise<ScriptedStudent> => {
    const student = await ScriptedStudent.join(relay, teacher.code);
    await expect(cardOf(page, student)).toBeVisible();
    const opening = page.context().waitForEvent("page");
    await foot.click();
    const report = await opening;
    await expect(report.getByRole("row", { name: nameOf(student) })).toBeVisible();
    await report.goto("/teach#report");
    // The next report replaces the one before it.
    await expect(report.getByRole("link", { name: /^Open the report/ })).toHaveCount(1);
    await report.close();
    return student;
  };
  const student = await joinAndOpenReport();
  const absent = await joinAndOpenReport();
  student.report(opened);
  student.bump(0);
  student.report(claim());
  await expect(cardOf(page, student)).toHaveAccessibleName(/Solved/);
  await page.getByRole("main").getByRole("button", { name: "End lesson" }).click();
  const download = page.waitForEvent("download");
  await page.getByRole("button", { name: "Save report" }).click();
  const saved = await download;
  expect(saved.suggestedFilename()).toMatch(/^one-line-\d{4}-\d\d-\d\d\.csv$/);
  const csv = await readFile(await saved.path(), "utf8");
  expect(csv.split("\r\n").slice(0, 2)).toEqual([
    "\uFEFFstudent,task,seconds,lines,attempts,runs,bumps,failed_checks,hints,mistakes",
    expect.stringMatching(new RegExp(`^${nameOf(student)},One line,\\d+,1,1,1,1,0,0,0$`)),
  ]);
  await expect(page.getByText("The report is saved on this device, under Reports.")).toBeVisible();
  await page.getByRole("button", { name: "End", exact: true }).click();
  await expect(page.getByRole("heading", { name: "The lesson is over" })).toBeVisible();
  await expectNoAxeViolations(page, "the lesson is over");
  const stored = await page.evaluate(() => Object.keys(localStorage).join());
  expect(stored).not.toContain("corridor.classroom");

  await page.getByRole("button", { name: "Open the report" }).click();
  // Who opened no task is one of the students, too.
  await expect(page.getByRole("row", { name: /^One line 1 of 2/ })).toHaveCount(2);
  await expect(page.getByRole("row", { name: nameOf(absent) })).toBeVisible();
  await expect(page.getByRole("heading", { name: "One line" })).toBeVisible();
  await expect(page.getByText(`Letters: ${shownCode(teacher.code)}`)).toBeVisible();
  await page.goto("/teach#report");
  // It has replaced the reports that were opened during the lesson.
  const reports = page.getByRole("link", { name: /^Open the report/ });
  await expect(reports).toHaveCount(1);
  await page.getByRole("button", { name: /^Delete the report/ }).click();
  await expect(reports).toHaveCount(0);
  await page.getByRole("button", { name: "Undo" }).click();
  await reports.click();
  await expect(page.getByRole("row", { name: /^One line 1 of 2/ })).toHaveCount(2);
  for (const each of [student, absent]) each.close();
}

async function endWithoutReport(page: Page, relay: string): Promise<void> {
  const teacher = await openDashboard(page, relay);
  const student = await ScriptedStudent.join(relay, teacher.code);
  student.report(opened);
  student.report(claim());
  await expect(cardOf(page, student)).toHaveAccessibleName(/Solved/);
  await page.getByRole("main").getByRole("button", { name: "End lesson" }).click();
  await page.getByRole("button", { name: "End", exact: true }).click();
  await page.getByRole("button", { name: "Open the report" }).click();
  await expect(page).toHaveURL(/\/teach#report=[\w-]+$/);
  await expect(page.getByRole("row", { name: /^One line 1 of 1/ })).toHaveCount(2);
  student.close();
}

/** A class whose teacher sends a second lesson, and saves a report of each. */
async function saveTwoLessons(page: Page, relay: string): Promise<void> {
  const teacher = await openDashboard(page, relay);
  const student = await ScriptedStudent.join(relay, teacher.code);
  student.report(opened);
  student.report(claim());
  await expect(cardOf(page, student)).toHaveAccessibleName(/Solved/);
  const save = async (): Promise<[string, string]> => {
    await page.getByRole("main").getByRole("button", { name: "End lesson" }).click();
    const download = page.waitForEvent("download");
    await page.getByRole("button", { name: "Save report" }).click();
    const saved = await download;
    await page.keyboard.press("Escape");
    return [saved.suggestedFilename(), await readFile(await saved.path(), "utf8")];
  };
  const [firstName, first] = await save();
  const second = lessonOfTasks("Two lines", [lessonTask("Straight on", [])]);
  await teacher.direct("PUT", "/lesson", second);
  await expect(page.getByRole("heading", { name: "Two lines" })).toBeVisible();
  student.report({ kind: "opened", lesson: lessonMark(second), task: 1 });
  student.bump(0);
  await expect(cardOf(page, student)).toHaveAccessibleName(/, 1 attempt$/);
  const [secondName, csv] = await save();
  expect([firstName, secondName]).toEqual([
    expect.stringMatching(/^one-line-/),
    expect.stringMatching(/^two-lines-/),
  ]);
  expect(first).toMatch(new RegExp(`^${nameOf(student)},One line,\\d+,1,0,0,0,0,0,0$`, "m"));
  expect(csv).toMatch(new RegExp(`^${nameOf(student)},Straight on,,,1,1,1,0,0,0$`, "m"));
  expect(csv).not.toContain("One line");

  // Both stay after the class, each with its own results.
  await page.getByRole("main").getByRole("button", { name: "End lesson" }).click();
  await page.getByRole("button", { name: "End", exact: true }).click();
  await expect(page.getByRole("heading", { name: "The lesson is over" })).toBeVisible();
  const open = async (lesson: string): Promise<void> => {
    await page.goto("about:blank");
    await page.goto("/teach#report");
    await page
      .getByRole("link", { name: `Open the report “${lesson}”` })
      .first()
      .click();
    await expect(page.getByRole("heading", { name: lesson, exact: true }).first()).toBeVisible();
  };
  await open("One line");
  await expect(page.getByRole("row", { name: /^One line 1 of 1/ })).toHaveCount(2);
  await open("Two lines");
  await expect(page.getByRole("row", { name: /^Straight on 0 of 1/ })).toBeVisible();
  await expect(page.getByRole("row", { name: /^One line/ })).toHaveCount(0);
  student.close();
}

async function openLinks(page: Page, relay: string): Promise<void> {
  const teacher = await startClass(relay);
  const { id, teacherKey, screenKey } = teacher.created;
  const open = async (keys: string): Promise<void> => {
    // Only another document reads the keys.
    await page.goto("about:blank");
    await page.goto(`/class/${id}${keys}`);
  };
  const refused = page.getByRole("heading", { name: "This link does not work" });
  await open("");
  await expect(refused).toBeVisible();
  // A device that has only the teacher's key says where the button of the big screen is.
  await open(`#${teacherKey}`);
  await page.getByRole("button", { name: "More" }).click();
  const item = page.getByRole("dialog").getByRole("button", { name: /^Big screen/ });
  await expect(item).toBeDisabled();
  await expect(item).toContainText("on the device that started the class");
  // The key of another class opens nothing, and does not replace the right one.
  const other = await ClassTeacher.start(relay);
  await open(`#${other.created.teacherKey}`);
  await expect(refused).toBeVisible();
  await expect(page.getByText("Open the class from the device that started it.")).toBeVisible();
  await page.reload();
  await expect(page.getByRole("heading", { name: "One line" })).toBeVisible();
  // A second device of the teacher opens the big screen, too.
  await open(`#${teacherKey}.${screenKey}`);
  const screen = page.getByRole("link", { name: "Big screen" });
  await expect(screen).toHaveAttribute("href", `${relay}/class/${id}#${screenKey}`);
  expect(new URL(page.url()).hash).toBe("");
}
