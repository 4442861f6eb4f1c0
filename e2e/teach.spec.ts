/** Teachers check the hand-ins of a class on `/teach`. */
import { readFileSync } from "node:fs";
import { lessonMark, type LessonDocument, type LessonTask } from "@corridor/challenge";
import { lessonOfTasks } from "@corridor/challenge/testing";
import { encodeLink, type LinkContent } from "@corridor/link";
import type { ProgramPresetId } from "@corridor/program";
import { Recording } from "@corridor/recording";
import {
  mazeOf,
  programOf,
  sampleTask,
} from "../apps/web/src/features/teach/testing/sample-lesson.ts";
import { expect, test } from "./fixtures.ts";
import { CorridorPage } from "./pages/corridor-page.ts";
import { LessonsPanel } from "./pages/lessons-panel.ts";
import { TeachPage } from "./pages/teach-page.ts";
import { allButColours, axeViolations, expectNoAxeViolations } from "./support/axe.ts";
import { KeyboardUser } from "./support/keyboard-user.ts";
import { horizontalOverflow, smallTouchTargets } from "./support/layout.ts";
import { phone } from "./support/phone.ts";
import { wideWindow } from "./support/window-sizes.ts";

test.use(wideWindow);

function linkOf(content: LinkContent): string {
  const link = encodeLink(content);
  if (!link.ok) throw new Error(link.code);
  return link.text;
}

/** Right-wall passes in all mazes; left-wall bumps in maze 2. */
const everyMaze: LessonTask = {
  ...sampleTask,
  name: "Every maze",
  checks: { bumps: 0, seconds: 120 },
  unseen: { kind: "tree", columns: 11, rows: 11, seed: 7, count: 48, pass: 40 },
};

function lessonOf(...tasks: LessonTask[]): LessonDocument {
  return lessonOfTasks("Two mazes, three lines", tasks);
}

const lesson = lessonOf(everyMaze);
const lessonLink = linkOf({ lesson });
const juniper = programOf("right-wall", "Juniper");
const comet = programOf("left-wall", "Comet");

function runFile(): string {
  const recording = new Recording(mazeOf("first-steps"), juniper);
  for (let tick = 0; tick < 100; tick++) recording.step();
  const written = recording.toDocument("Run");
  if (!written.ok) throw new Error(written.reason);
  return written.text;
}

test("leads from the lessons to the hand-ins, and checks hand-ins of every kind", async ({
  page,
}) => {
  await new CorridorPage(page).open();
  await new LessonsPanel(page).openPath();
  const forTeachers = page.getByRole("link", { name: "For teachers" });
  await expect(forTeachers).toBeInViewport();
  await forTeachers.click();
  await expect(page).toHaveTitle("For teachers – Corridor");
  await page.getByRole("link", { name: /^Check hand-ins/ }).click();
  await expect(page).toHaveTitle("Check hand-ins – Corridor");
  const teach = new TeachPage(page);

  await teach.lesson.fill("nonsense");
  await teach.openLesson.click();
  await expect(page.getByRole("alert")).toContainText("This is not a link of Corridor");
  await teach.lesson.fill(`https://corridor.example/#${lessonLink}`);
  await teach.openLesson.click();
  await expect(page.getByRole("heading", { name: "Two mazes, three lines" })).toBeVisible();
  await expect(page.getByText("Mazes: 2 given, 48 unseen")).toBeVisible();

  await teach.chooseFiles([
    { name: "juniper.program.json", text: JSON.stringify(juniper) },
    { name: "juniper.run.json", text: runFile() },
    { name: "broken.json", text: JSON.stringify({ ...juniper, default: "fly" }) },
  ]);
  const mark = lessonMark(lesson);
  await teach.checkLines([
    linkOf({ program: comet }),
    `https://corridor.example/#${linkOf({ completion: { lesson: mark, task: 0, attempt: juniper } })}`,
    linkOf({ completion: { lesson: "000000000", task: 0, attempt: juniper } }),
    linkOf({ program: juniper }).slice(0, -3),
    "Anna",
  ]);
  await expect(teach.rows).toHaveCount(8);
  const row = (number: number) => teach.rows.nth(number - 1);
  await expect(row(1)).toContainText(/juniper\.program\.json.*50 of 50.*passes.*13\.3/s);
  await expect(row(1).getByRole("cell").last()).toHaveText("2");
  await expect(row(2)).toContainText("50 of 50");
  await expect(row(3)).toContainText('default: found "fly", expected one of forward');
  await expect(row(4)).toContainText(/Line 1.*does not pass.*Maze 2: bump at 1\.3 s, line 1/s);
  await expect(row(5)).toContainText("50 of 50");
  await expect(row(6)).toContainText("Not checked: this code is not from this lesson.");
  await expect(row(7)).toContainText("Not checked: a part of this link is missing.");
  await expect(row(8)).toContainText("Not checked: this is not a link of Corridor");
  await expectNoAxeViolations(page, "hand-ins");

  // Watch plays the last two seconds in the student's page.
  const opened = page.context().waitForEvent("page");
  await row(4).getByRole("link", { name: "Watch" }).click();
  const student = new CorridorPage(await opened);
  await student.waitUntilReady();
  await expect(student.mazeMenu).toHaveAccessibleName("Maze 2, Maze menu");
  await expect(student.program.name).toHaveValue("Comet");
  await expect(student.page).toHaveURL(/\/$/);
});

test("checks the chosen tasks, saves the table as CSV, and continues after a reload", async ({
  page,
}) => {
  const teach = new TeachPage(page);
  const other = { ...everyMaze, name: "One maze", mazes: [mazeOf("first-steps")], unseen: null };
  const twoTasks = linkOf({ lesson: lessonOf(everyMaze, other) });
  await teach.openHandIns(twoTasks);
  await expect(page).toHaveURL(/\/teach#hand-ins$/);
  await teach.checkLines([linkOf({ program: comet })]);
  await expect(teach.rows).toHaveCount(2);
  await page.getByRole("checkbox", { name: "1. Every maze" }).uncheck();
  await teach.checkLines([linkOf({ program: comet })]);
  await expect(teach.rows).toHaveCount(1);
  await expect(teach.rows).toContainText("1 of 1");
  await page.getByRole("checkbox", { name: "2. One maze" }).uncheck();
  await teach.check().click();
  await expect(page.getByRole("alert")).toHaveText("Choose at least one task.");

  await test.step("the CSV has no formulas", async () => {
    await page.getByRole("checkbox", { name: "1. Every maze" }).check();
    await teach.chooseFiles([{ name: "=1+1.json", text: JSON.stringify(juniper) }]);
    await teach.checkLines([linkOf({ program: comet })]);
    const download = page.waitForEvent("download");
    await page.getByRole("button", { name: "Save as CSV" }).click();
    const file = await (await download).path();
    const [header, first, second] = readFileSync(file, "utf8").split("\r\n");
    expect(header).toBe(
      "\uFEFFnumber,program,task,passed,code,maze,tick,lines,seconds,unseenCount,unseenPassed,unseenFailed,problem,sameAs",
    );
    expect(first).toBe(`1,"'=1+1.json",1,true,,,,2,13.367,48,48,,,`);
    expect(second).toContain("2,line 1,1,false,bump,maze 2,");
  });

  await test.step("the open lesson and the lines are there after a reload", async () => {
    await teach.lines.fill(linkOf({ program: juniper }));
    await page.reload();
    await expect(teach.lines).toHaveValue(linkOf({ program: juniper }));
    await expect(page.getByRole("heading", { name: "Two mazes, three lines" })).toBeVisible();
    // A link that cannot be opened changes nothing.
    await page.goto(`/teach#${lessonLink.slice(0, -2)}`);
    await expect(page.getByRole("alert")).toContainText("A part of this link is missing.");
    await page.goBack();
    await expect(teach.lines).toHaveValue(linkOf({ program: juniper }));
  });
});

test("shows results as they come, and stops with those so far", async ({ page }) => {
  const teach = new TeachPage(page);
  const unseen = { ...everyMaze.unseen, columns: 33, rows: 33, count: 1_000, pass: 1 };
  const long = { ...everyMaze, checks: { bumps: null, seconds: 600 }, unseen };
  await teach.openHandIns(linkOf({ lesson: lessonOf(long as LessonTask) }));
  await teach.lines.fill(
    ["right-wall", "left-wall", "back-and-forth"]
      .map((id) => linkOf({ program: programOf(id as ProgramPresetId, id) }))
      .join("\n"),
  );
  await teach.check().click();
  await expect(page.getByText(/^Checking \d+ of 3,006\.$/)).toBeVisible();
  await expect(page.getByText(/^Checking [1-9]/)).toBeVisible();
  await page.getByRole("button", { name: "Stop" }).click();
  const stopped = page.getByRole("paragraph").filter({ hasText: /^Stopped after \d+ of 3,006\.$/ });
  const done = await stopped.textContent();
  await expect(page.getByRole("button", { name: "Stop" })).toBeHidden();
  await expect(teach.rows).toHaveCount(3);
  await expect(stopped).toHaveText(done ?? "");
});

test("begins with a lesson, and on a phone with a class, in reading order, and works by keyboard alone", async ({
  page,
}) => {
  const keyboard = new KeyboardUser(page);
  const entries = page.getByRole("main").getByRole("list").first().getByRole("listitem");
  await page.setViewportSize({ width: 390, height: 844 });
  await page.goto("/teach");
  await expect(entries).toHaveText([/^Start/, /^Make/, /^Check/, /^Reports/]);
  await page.setViewportSize(wideWindow.viewport);
  await expect(entries).toHaveText([/^Make/, /^Start/, /^Check/, /^Reports/]);
  const entry = page.getByRole("link", { name: /^Check hand-ins/ });
  await expect(entry).toBeVisible();
  await page.keyboard.press("Tab");
  const skip = page.getByRole("link", { name: "Skip to the content" });
  await expect(skip).toBeFocused();
  await page.keyboard.press("Enter");
  await expect(page.getByRole("main")).toBeFocused();
  await keyboard.press(entry);
  const teach = new TeachPage(page);
  await keyboard.tabTo(teach.lesson);
  await page.keyboard.insertText(lessonLink);
  await page.keyboard.press("Enter");
  await keyboard.tabTo(teach.lines);
  await page.keyboard.insertText(linkOf({ program: comet }));
  await keyboard.press(teach.check());
  await keyboard.tabTo(teach.rows.getByRole("link", { name: "Watch the failure of hand-in 1" }));
});

test("a phone has the links for teachers in sight, without scrolling", async ({ openWindow }) => {
  const { page } = await openWindow(phone);
  await new CorridorPage(page).open();
  await page.getByRole("banner").getByRole("button", { name: "More" }).click();
  await page.getByRole("dialog", { name: "More" }).getByRole("button", { name: "Lessons" }).click();
  for (const name of ["Join a class", "For teachers"]) {
    await expect(page.getByRole("link", { name })).toBeInViewport({ ratio: 1 });
  }
  await page.keyboard.press("Escape");
  await page.getByRole("banner").getByRole("button", { name: "Share" }).click();
  const link = page.getByRole("link", { name: "Teaching? Make a lesson of this" });
  await expect(link).toBeInViewport({ ratio: 1 });
});

test("fits a phone and 320 px, also in a right-to-left language", async ({ openWindow }) => {
  test.slow();
  for (const locale of ["en-US", "ar-EG"]) {
    const { page } = await openWindow({ ...phone, locale });
    // Both languages have the same colours.
    const expectAccessible = async (state: string): Promise<void> =>
      locale === "en-US"
        ? expectNoAxeViolations(page, state)
        : expect(await axeViolations(page, allButColours), state).toEqual([]);
    await page.goto("/teach");
    await expect(page.getByRole("main").getByRole("link")).toHaveCount(3);
    await expectAccessible(`${locale}, start`);
    expect(await horizontalOverflow(page)).toEqual([]);
    // The link is saved as a lesson, whose hand-ins open next.
    await page.goto(`/teach#${lessonLink}`);
    await page.waitForURL(/#lesson=/);
    await page.goto(page.url().replace("#lesson=", "#hand-ins="));
    const lines = page.getByRole("main").getByRole("textbox");
    await lines.fill([linkOf({ program: comet }), "Anna"].join("\n"));
    await page.getByRole("main").locator("section button").last().click();
    await expect(page.getByRole("table").getByRole("link")).toBeVisible();
    await expectAccessible(`${locale}, table`);
    expect(await smallTouchTargets(page)).toEqual([]);
    for (const width of [390, 320]) {
      await page.setViewportSize({ width, height: 640 });
      await expect.poll(() => horizontalOverflow(page), `${locale}, ${width} px`).toEqual([]);
    }
  }
});

test.describe("offline", () => {
  test.use({ serviceWorkers: "allow" });

  test("checks hand-ins without a network after one visit", async ({ context, page }) => {
    const teach = new TeachPage(page);
    await teach.openHandIns(lessonLink);
    const isControlled = () => navigator.serviceWorker.controller !== null;
    await page.waitForFunction(isControlled, undefined, { timeout: 120_000 });
    await context.setOffline(true);
    await page.reload();
    await teach.checkLines([linkOf({ program: juniper })]);
    await expect(teach.rows).toContainText("50 of 50");
  });
});
