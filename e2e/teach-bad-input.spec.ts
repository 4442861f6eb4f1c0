/** What teachers open by mistake, or receive from others: one sentence each, and nothing else changes. */
import { writeFileSync } from "node:fs";
import type { LessonDocument } from "@corridor/challenge";
import type { Page } from "playwright/test";
import { sampleLesson, sampleTask } from "../apps/web/src/features/teach/testing/sample-lesson.ts";
import { expect, test } from "./fixtures.ts";
import { ClassTeacher } from "./support/class-teacher.ts";
import { wideWindow } from "./support/window-sizes.ts";

test.use(wideWindow);

const hostile = "<img src=x onerror=alert(1)> {{all}} $t(report:csv)";

interface NamedText {
  name: string;
  text: string;
}

const json = (name: string, document: unknown): NamedText => ({
  name,
  text: JSON.stringify(document),
});

/** The browser reads a file of more characters from the disk itself. */
const LARGE = 1_000_000;

/** Writes a file into the folder of the test. @returns its path */
function written(name: string, text: string): string {
  const path = test.info().outputPath(name);
  writeFileSync(path, text);
  return path;
}

/** Chooses a file by the button of this name. */
async function choose(page: Page, button: RegExp | string, { name, text }: NamedText) {
  const file = { name, mimeType: "text/plain", buffer: Buffer.from(text) };
  const chosen = text.length > LARGE ? written(name, text) : file;
  const chooser = page.waitForEvent("filechooser");
  await page.getByRole("button", { name: button }).click();
  await (await chooser).setFiles(chosen);
}

const bad: [NamedText, string | RegExp][] = [
  [
    json("version-3.json", { ...sampleLesson, version: 3 }),
    /A newer Corridor made this lesson\. Reload this page.*version: found 3/,
  ],
  [
    json("13-tasks.json", { ...sampleLesson, tasks: Array.from({ length: 13 }, () => sampleTask) }),
    /not a lesson that Corridor can read\. Correct the file, or choose another one\..*at most 12 tasks/,
  ],
  [
    json("long-name.json", { ...sampleLesson, name: "<img src=x onerror=alert(1)>".repeat(9) }),
    /Correct the file, or choose another one\..*name: .*at most 100 characters/,
  ],
  [{ name: "cut-off.json", text: '{"format":"corridor/challenge"' }, /Correct the file/],
  [{ name: "letter.txt", text: "Dear parents" }, /Correct the file/],
  [{ name: "large.json", text: " ".repeat(9_500_000) }, "bigger than 9 MB. A lesson is smaller"],
];

/** 60 empty mazes of 33 by 33 squares. */
function largeLesson(): LessonDocument {
  const [maze] = sampleTask.mazes;
  if (maze === undefined) throw new Error("no maze");
  const rows = Array.from({ length: 33 }, () => ".".repeat(33));
  const large = {
    ...maze,
    blocks: rows,
    start: { column: 0, row: 0, heading: "east" as const },
    goals: [{ column: 32, row: 32 }],
  };
  const task = { ...sampleTask, mazes: Array.from({ length: 10 }, () => large), unseen: null };
  return { ...sampleLesson, name: "Sixty mazes", tasks: Array.from({ length: 6 }, () => task) };
}

test("a bad lesson is refused in one sentence and not saved, one that is too large says what to shorten, and hostile texts are texts", async ({
  page,
  relay,
}) => {
  await test.step("a bad lesson is refused in one sentence and not saved", () => refuseBad(page));
  await test.step("hostile texts are texts, in the list, the editor and a report", () =>
    openHostile(page));
  await test.step("a lesson that is too large says what to shorten", () => shareLarge(page));
  await test.step("hostile texts are texts in the relay and the dashboard, too", async () => {
    const teacher = await ClassTeacher.start(relay, null, { ...sampleLesson, name: hostile });
    await page.goto(teacher.address());
    await expect(page.getByRole("heading", { name: hostile })).toBeVisible();
  });
});

async function refuseBad(page: Page): Promise<void> {
  await page.goto("/teach#make");
  for (const [file, sentence] of bad) {
    await choose(page, /^A file/, file);
    await expect(page.getByRole("alert")).toHaveCount(1);
    await expect(page.getByRole("alert")).toContainText(sentence);
  }
  await page.goto("/teach#");
  await expect(page.getByRole("heading", { name: "For teachers" })).toBeVisible();
  await expect(page.getByRole("heading", { name: "On this device" })).toHaveCount(0);
}

async function openHostile(page: Page): Promise<void> {
  await page.goto("/teach#make");
  await choose(page, /^A file/, json("hostile.json", { ...sampleLesson, name: hostile }));
  await expect(page.getByRole("heading", { name: hostile })).toBeVisible();
  await page.goto("/teach#");
  await expect(page.getByRole("link", { name: hostile })).toBeVisible();
  await expect(page.getByRole("button", { name: `More for ${hostile}` })).toBeVisible();

  await page.goto("/teach#report");
  const rows = ["student,task,seconds", `"${hostile}","${hostile}",60`, `"'=1+1","${hostile}",90`];
  await choose(page, "Choose CSV files", { name: `${hostile}.csv`, text: rows.join("\n") });
  await expect(page.getByRole("heading", { name: `${hostile}.csv` })).toBeVisible();
  await expect(page.getByRole("list", { name: `Time of each student: ${hostile}` })).toBeVisible();
  await expect(page.getByRole("row", { name: `${hostile} 1:00` })).toBeVisible();
  await expect(page.getByRole("row", { name: "=1+1 1:30" })).toBeVisible();
  await expect(page.locator("img")).toHaveCount(0);
}

async function shareLarge(page: Page): Promise<void> {
  await page.goto("/teach#make");
  await choose(page, /^A file/, json("large.json", largeLesson()));
  await expect(page.getByRole("heading", { name: "Sixty mazes" })).toBeVisible();
  await page.getByRole("button", { name: "Start class" }).click();
  const start = page.getByRole("dialog", { name: "Start a class" });
  await start.getByRole("button", { name: "Start class" }).click();
  const size = String.raw`it has \d+ KB, and 64 KB fit\. Remove mazes from task 1, or make them smaller\.`;
  await expect(start.getByRole("alert")).toHaveText(
    new RegExp(`This lesson is too big for a class: ${size}`),
  );
  await page.keyboard.press("Escape");
  await page.getByRole("button", { name: "Share lesson" }).click();
  const share = page.getByRole("dialog", { name: "Share lesson" });
  await share.getByRole("button", { name: "Share anyway" }).click();
  await expect(share).toContainText(new RegExp(`This lesson is too big for a short link: ${size}`));
}
