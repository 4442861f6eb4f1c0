/** Teachers check the hand-ins of a class on `/teach`. */
import { readFileSync } from "node:fs";
import { lessonMark, type LessonDocument, type LessonTask } from "@corridor/challenge";
import { lessonOfTasks } from "@corridor/challenge/testing";
import { encodeLink, type LinkContent } from "@corridor/link";
import type { ProgramPresetId } from "@corridor/program";
import { Recording } from "@corridor/recording";
import type { Page } from "playwright/test";
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
import { chooseLanguage } from "./support/choose-language.ts";
import { KeyboardUser } from "./support/keyboard-user.ts";
import { horizontalOverflow, smallTouchTargets } from "./support/layout.ts";
import { phone } from "./support/phone.ts";
import { Texts } from "./support/texts.ts";
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

/** Closes the open lesson, so that another one can be opened. Hand-ins stay. */
async function openAnother(page: Page): Promise<void> {
  await page.getByRole("button", { name: "Open another lesson" }).click();
  await new TeachPage(page).lesson.waitFor();
}

test("begins with a lesson, checks hand-ins of every kind in the chosen tasks, saves the table as CSV, and stops with the results so far", async ({
  page,
}) => {
  await test.step("begins with a lesson, and on a phone with a class, in reading order, and works by keyboard alone", () =>
    useKeyboard(page));
  await test.step("leads from the lessons to the hand-ins, and checks hand-ins of every kind", () =>
    checkEveryKind(page));
  await page.getByRole("button", { name: "Remove files" }).click();
  await test.step("checks the chosen tasks, saves the table as CSV, and continues after a reload", () =>
    checkTasks(page));
  await test.step("shows results as they come, and stops with those so far", () => stopCheck(page));
});

async function useKeyboard(page: Page): Promise<void> {
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
}

async function checkEveryKind(page: Page): Promise<void> {
  await new CorridorPage(page).open();
  await new LessonsPanel(page).openPath();
  const forTeachers = page.getByRole("link", { name: "For teachers" });
  await expect(forTeachers).toBeInViewport();
  await forTeachers.click();
  await expect(page).toHaveTitle("For teachers – Corridor");
  await page.getByRole("link", { name: /^Check hand-ins/ }).click();
  await expect(page).toHaveTitle("Check hand-ins – Corridor");
  const teach = new TeachPage(page);

  // The lesson that was checked last is open.
  await openAnother(page);
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
  await student.page.close();
}

async function checkTasks(page: Page): Promise<void> {
  const teach = new TeachPage(page);
  const other = { ...everyMaze, name: "One maze", mazes: [mazeOf("first-steps")], unseen: null };
  const twoTasks = linkOf({ lesson: lessonOf(everyMaze, other) });
  await openAnother(page);
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
}

async function stopCheck(page: Page): Promise<void> {
  const teach = new TeachPage(page);
  const unseen = { ...everyMaze.unseen, columns: 33, rows: 33, count: 1_000, pass: 1 };
  const long = { ...everyMaze, checks: { bumps: null, seconds: 600 }, unseen };
  await openAnother(page);
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
}

test("a phone has the links for teachers in sight, and the hand-ins fit it, and 320 px, also in a right-to-left language", async ({
  openWindow,
}) => {
  const { page } = await openWindow(phone);
  await test.step("a phone has the links for teachers in sight, without scrolling", () =>
    findLinks(page));

  await page.goto("/teach");
  await expect(page.getByRole("main").getByRole("link")).toHaveCount(3);
  await expectStartFits(page, (state) => expectNoAxeViolations(page, state), "English");
  await checkOnPhone(page);
  await expectTableFits(page, (state) => expectNoAxeViolations(page, state), "English");

  await page.setViewportSize(wideWindow.viewport);
  await chooseLanguage(page, Texts.load("en"), "ar");
  await page.setViewportSize(phone.viewport);
  // Both languages have the same colours.
  const expectAccessible = async (state: string): Promise<void> =>
    expect(await axeViolations(page, allButColours), state).toEqual([]);
  await expectTableFits(page, expectAccessible, "Arabic");
  await page.goto("/teach#");
  await expectStartFits(page, expectAccessible, "Arabic");
});

async function findLinks(page: Page): Promise<void> {
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
}

async function expectStartFits(
  page: Page,
  expectAccessible: (state: string) => Promise<void>,
  language: string,
): Promise<void> {
  await expect(page.getByRole("main").getByRole("link").first()).toBeVisible();
  await expectAccessible(`${language}, start`);
  expect(await horizontalOverflow(page), language).toEqual([]);
}

/** Checks a program that fails, and a text that is no hand-in. */
async function checkOnPhone(page: Page): Promise<void> {
  // The link is saved as a lesson, whose hand-ins open next.
  await page.goto(`/teach#${lessonLink}`);
  await page.waitForURL(/#lesson=/);
  await page.goto(page.url().replace("#lesson=", "#hand-ins="));
  const lines = page.getByRole("main").getByRole("textbox");
  await lines.fill([linkOf({ program: comet }), "Anna"].join("\n"));
  await page.getByRole("main").locator("section button").last().click();
}

async function expectTableFits(
  page: Page,
  expectAccessible: (state: string) => Promise<void>,
  language: string,
): Promise<void> {
  await expect(page.getByRole("table").getByRole("link")).toBeVisible();
  await expectAccessible(`${language}, table`);
  expect(await smallTouchTargets(page), language).toEqual([]);
  for (const width of [390, 320]) {
    await page.setViewportSize({ width, height: 640 });
    await expect.poll(() => horizontalOverflow(page), `${language}, ${width} px`).toEqual([]);
  }
}
