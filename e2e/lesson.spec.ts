/** A student with a teacher's lesson of several tasks: opening it, working on it, saving it. */
import { encodeLink } from "@corridor/link";
import type { Page } from "playwright/test";
import { readFileSync } from "node:fs";
import { expect, test } from "./fixtures.ts";
import type { CorridorPage } from "./pages/corridor-page.ts";
import { drop, Lesson } from "./pages/lesson-card.ts";
import { TeachPage } from "./pages/teach-page.ts";
import { expectNoAxeViolations } from "./support/axe.ts";
import { horizontalOverflow } from "./support/layout.ts";
import { lesson, side, taskOf, type Opened } from "./support/student-lesson.ts";
import { wideWindow } from "./support/window-sizes.ts";

test.use(wideWindow);

const inTurn = { ...lesson, order: "in turn" as const };

test("opens a lesson from a file, keeps the work on each task, hides what a task does not allow, and refuses bad lessons", async ({
  corridor,
  page,
}) => {
  const opened = new Lesson(page);
  const student: Opened = { corridor, page, opened };
  await corridor.program.deleteAllLines();
  await corridor.program.addLine("front <", "50", "turn 180");
  await test.step("a bad lesson is refused in one sentence, and leaves the open work alone", () =>
    refuseBad(student));
  await test.step("goes through its tasks, and keeps the work on each", () => keepWork(student));
  await test.step("the texts of a lesson are texts, in its language", async () => {
    // cspell:ignore متاهتان
    await drop(page, {
      ...lesson,
      language: "ar",
      name: "<b>‮متاهتان</b>",
      intro: "{{seconds}} $t(card.label)",
    });
    const name = opened.card.getByText("<b>‮متاهتان</b>");
    await expect(name).toHaveAttribute("lang", "ar");
    await expect(name).toHaveAttribute("dir", "rtl");
    await expect(opened.card.getByText("{{seconds}} $t(card.label)")).toBeVisible();
  });
  await test.step("tools and help that a task does not allow are hidden", () => hideTools(student));
});

async function refuseBad({ corridor, page }: Opened): Promise<void> {
  const dialog = page.getByRole("dialog", { name: "This file cannot be opened" });
  const bad: [unknown, string][] = [
    [{ ...lesson, version: 3 }, "version 1 or 2, the newest that this Corridor reads"],
    [{ ...lesson, tasks: Array.from({ length: 13 }, () => lesson.tasks[0]) }, "at most 12 tasks"],
    [{ ...lesson, name: "<img src=x onerror=alert(1)>".repeat(9) }, "at most 100 characters"],
    ['{"format":"corridor/challenge","version":2', "a JSON document"],
  ];
  for (const [document, expected] of bad) {
    await drop(page, document);
    await expect(dialog).toContainText(expected);
    await expect(dialog).toContainText("Nothing changed.");
    await page.keyboard.press("Escape");
    await expect(dialog).toBeHidden();
  }
  await expect(corridor.program.number(1)).toHaveValue("50");
}

async function keepWork({ corridor, page, opened }: Opened): Promise<void> {
  await drop(page, lesson);
  await opened.expectTask(1);
  await expect(opened.card).toContainText("Two mazes, three lines");
  await expect(opened.card).toContainText("Write short programs.");
  await expect(opened.card).toContainText("Solve Straight on.");

  // With the browser's Back and Forward, and home.
  await opened.task(2).click();
  await opened.expectTask(2);
  await page.goBack();
  await opened.expectTask(1);
  await page.goForward();
  await opened.expectTask(2);
  await page.goBack();
  await page.goBack();
  await expect(opened.card).toBeHidden();
  await expect(corridor.mazeMenu).toHaveAccessibleName("Long way round, Maze menu");
  await page.goForward();
  await opened.expectTask(1);

  await corridor.program.addLine("front <", "50", "turn 180");
  await opened.task(2).click();
  await opened.expectTask(2);
  await expect(corridor.program.lines).toHaveCount(0);
  await corridor.program.addLine("right >", "60", "delayed right 90");
  await opened.task(1).click();
  await expect(corridor.program.number(1)).toHaveValue("50");
  await page.reload();
  await opened.expectTask(1);
  await expect(corridor.program.number(1)).toHaveValue("50");
  await opened.task(2).click();
  await expect(corridor.program.number(1)).toHaveValue("60");

  // Another maze closes the task, and the message leads back.
  await corridor.choosePreset("Long way round");
  await expect(opened.card).toBeHidden();
  const closed = corridor.message("You opened another maze, so the task is closed.");
  await expect(closed).toBeVisible();
  await page.getByRole("button", { name: "Back to the task" }).click();
  await opened.expectTask(2);
}

async function hideTools({ corridor, page, opened }: Opened): Promise<void> {
  const bare = { ...taskOf("").allowed, drivers: ["program", "remote"], tools: [], help: [] };
  await drop(page, {
    ...lesson,
    tasks: [{ ...taskOf("Bare"), mazes: [side], allowed: bare }, taskOf("All")],
  });
  await expect(opened.card).toContainText("Solve Bare.");
  const banner = page.getByRole("banner");
  await expect(banner.getByRole("button", { name: "Presets" })).toBeHidden();
  await expect(banner.getByRole("button", { name: "Share" })).toBeHidden();
  await expect(page.getByRole("radio", { name: "Measure" })).toBeHidden();
  await expect(page.getByRole("radio", { name: "Remote" })).toBeHidden();
  await expect(corridor.speed).toBeHidden();
  await expect(page.getByRole("slider")).toBeHidden();
  await expect(opened.card.getByRole("button", { name: /hint/ })).toBeHidden();
  await corridor.mazeMenu.click();
  await expect(page.getByRole("button", { name: "Save maze", exact: true })).toBeHidden();
  await page.keyboard.press("Escape");
  await corridor.program.addLine("right >", "60", "right 90");
  const line = page.getByRole("listitem", { name: /^Line 1/ });
  await expect(line).toHaveAccessibleName("Line 1: if right is more than 60, right 90.");
  await corridor.run.click();
  await expect(opened.outcome).toHaveText(/^Bump at \d+\.\d s\./);
  await expect(opened.outcome).not.toContainText("Line 1");
  await expect(page.locator("#spoken")).not.toContainText(/line 1|true/i);
  await opened.task(2).click();
  await expect(banner.getByRole("button", { name: "Presets" })).toBeVisible();
  await expect(corridor.speed).toBeVisible();
}

test("opens a lesson from a link, shares it with a small phone, solves tasks in turn, with a completion code for the teacher, and saves the lesson", async ({
  corridor,
  page,
  openWindow,
}) => {
  const opened = new Lesson(page);
  const student: Opened = { corridor, page, opened };
  const other = await openWindow({ ...wideWindow, hasTouch: true });
  await test.step("opens a lesson from a link, and shares it as a short link", () =>
    shareLesson(student, other));
  await page.keyboard.press("Escape");
  await other.page.setViewportSize(wideWindow.viewport);

  await drop(page, inTurn);
  await opened.expectTask(1);
  await test.step("a locked task says what opens it", async () => {
    await expect(opened.task(2)).toHaveAccessibleName("2 Side opening locked");
    await expect(opened.tasks).toContainText("Task 2 opens when you solve task 1.");
    // Playwright does not click what is disabled, but a student may.
    await opened.task(2).press("Enter");
    await opened.expectTask(1);
    await corridor.speed.selectOption("max");
    await corridor.run.click();
    await expect(opened.outcome).toHaveText("Task solved. Lines used: 0 of 3");
    await expect(opened.task(1)).toHaveAccessibleName("1 Straight on solved");
    await expect(opened.task(2)).toHaveAccessibleName("2 Side opening");
  });
  await test.step("the completion code is copied, and accepted on /teach", () =>
    handIn(student, other.page));
  await test.step("a solved task stays solved after a reload, and leads to the next one", () =>
    continueSolved(student));
  await test.step("the lesson is saved as it was opened, and one task as version 1", async () => {
    const save = async (): Promise<unknown> => {
      await corridor.mazeMenu.click();
      const saving = page.waitForEvent("download");
      await page.getByRole("button", { name: "Save lesson" }).click();
      const file = await (await saving).path();
      return JSON.parse(readFileSync(file, "utf8"));
    };
    expect(await save()).toEqual(inTurn);
    const {
      tasks: [task],
    } = lesson;
    const plain = { ...lesson, name: "", intro: "", language: null, tasks: [task] };
    await drop(page, plain);
    await expect(opened.card).toBeHidden();
    expect(await save()).toMatchObject({ version: 1, name: "Straight on" });
  });
});

async function shareLesson(
  { corridor, page, opened }: Opened,
  recipient: CorridorPage,
): Promise<void> {
  const link = encodeLink({ lesson });
  if (!link.ok) throw new Error(link.code);
  await corridor.open(`/#${link.text}`);
  // This message disappears by itself.
  await expect(corridor.message("You opened a lesson.")).toBeVisible();
  await opened.expectTask(1);
  expect(new URL(page.url()).hash).toBe("");
  await opened.task(2).click();
  await opened.expectTask(2);
  await page.goBack();
  await opened.expectTask(1);

  await corridor.share.click();
  const dialog = corridor.dialog("Share this lesson");
  await expect(dialog.getByRole("checkbox", { name: "Lesson with all its tasks" })).toBeChecked();
  await expect(dialog.getByRole("checkbox", { name: "My program" })).toBeDisabled();
  const field = dialog.getByRole("textbox", { name: "Link" });
  expect(new URL(await field.inputValue()).hash).toBe(`#${link.text}`);
  await dialog.getByRole("button", { name: "Short link", exact: true }).click();
  await expect(field).toHaveValue(/\/m\/[A-Z]{4,6}$/);

  await recipient.page.setViewportSize({ width: 320, height: 640 });
  await recipient.open(await field.inputValue());
  const small = new Lesson(recipient.page);
  await small.expectTask(1);
  expect(new URL(recipient.page.url()).pathname).toBe("/");

  // Twelve tasks and their targets fit 320 px.
  const names = Array.from({ length: 12 }, (_, at) => taskOf(`A task with a long name ${at + 1}`));
  await drop(recipient.page, { ...lesson, order: "in turn", tasks: names });
  await expect(small.tasks.getByRole("button")).toHaveCount(12);
  expect(await horizontalOverflow(recipient.page)).toEqual([]);
  for (const button of await small.tasks.getByRole("button").all()) {
    const box = await button.boundingBox();
    expect(box?.height).toBeGreaterThanOrEqual(44);
    expect(box?.width).toBeGreaterThanOrEqual(44);
  }
  await expectNoAxeViolations(recipient.page, "a lesson of twelve tasks");
}

async function handIn({ corridor, page }: Opened, teacher: Page): Promise<void> {
  const code = page.getByRole("region", { name: "Completion code" });
  await expect(code).toContainText("not who wrote it, when, or with what help.");
  await expectNoAxeViolations(page, "a completion code");
  await code.getByRole("button", { name: "QR code" }).click();
  await expect(code.locator("svg[viewBox]").last()).toBeVisible();
  await code.getByRole("button", { name: "Copy code" }).click();
  await expect(code.getByRole("status")).toHaveText(
    "Completion code copied. It shows that this program passes, not who wrote it.",
  );
  const copied = await page.evaluate(() => navigator.clipboard.readText());
  expect(copied).toMatch(/^[\w-]{10,40}$/);

  const link = encodeLink({ lesson: inTurn });
  const teach = new TeachPage(teacher);
  await teach.openHandIns(link.ok ? link.text : "");
  await teach.lines.fill(copied);
  await teacher.getByRole("button", { name: "Check 1" }).click();
  await expect(teacher.getByRole("row").nth(1)).toContainText("1 of 1");

  // An edited program has not passed yet.
  await corridor.program.addLine("front <", "50", "left 90");
  await expect(code).toBeHidden();
  await corridor.program.deleteAllLines();
}

async function continueSolved({ corridor, page, opened }: Opened): Promise<void> {
  await page.reload();
  await expect(opened.task(1)).toHaveAccessibleName("1 Straight on solved");
  await opened.task(2).press("Enter");
  await opened.expectTask(2);
  await opened.task(1).click();
  await opened.expectTask(1);
  // The same lesson again continues where the student left it.
  await drop(page, inTurn);
  await opened.expectTask(2);
  await opened.task(1).click();
  await opened.expectTask(1);
  await corridor.run.click();
  const card = page.getByRole("region", { name: "Solved!" });
  await card.getByRole("button", { name: "Next task" }).click();
  await opened.expectTask(2);
}
