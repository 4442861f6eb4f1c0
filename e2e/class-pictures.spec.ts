/** The pictures and the clocks on the cards of a dashboard. */
import { lessonMark } from "@corridor/challenge";
import type { Locator, Page } from "playwright/test";
import { sampleLesson } from "../apps/web/src/model/lessons/testing/sample-lesson.ts";
import { expect, test } from "./fixtures.ts";
import { DashboardPage } from "./pages/dashboard-page.ts";
import { ClassTeacher } from "./support/class-teacher.ts";
import { ScriptedStudent } from "./support/scripted-student.ts";

const opened = { kind: "opened", lesson: lessonMark(sampleLesson), task: 1 } as const;
const parked = { pose: [150, 150, 90] as [number, number, number], path: "" };
const moved = { pose: [350, 150, 90] as [number, number, number], path: "e2" };

function pictureOf(page: Page, student: number): Locator {
  return page.locator(`[data-picture="${student}"]`).first();
}

async function pixels(picture: Locator): Promise<string> {
  return (await picture.screenshot()).toString("base64");
}

/** A picture without a maze has fewer bytes. */
const LEAST_LENGTH = 1_000;

/** The pixels of a picture that is drawn, and does not change any more. */
async function settled(picture: Locator): Promise<string> {
  let last = "";
  await expect
    .poll(async () => {
      const before = last;
      last = await pixels(picture);
      return last === before && last.length > LEAST_LENGTH;
    })
    .toBe(true);
  return last;
}

test("the picture of a student follows the robot and the card", async ({ page, relay }) => {
  const teacher = await ClassTeacher.start(relay);
  const students = [
    await ScriptedStudent.join(relay, teacher.code),
    await ScriptedStudent.join(relay, teacher.code),
  ];
  for (const student of students) student.show(parked);
  await page.goto(teacher.address());
  await expect(new DashboardPage(page).cards).toHaveCount(2);
  const [first, second] = [pictureOf(page, 1), pictureOf(page, 2)];
  const before = [await settled(first), await settled(second)];
  students[1]?.show({ ...moved, tick: 60 });
  await expect.poll(() => pixels(second)).not.toBe(before[1]);
  expect(await pixels(first)).toBe(before[0]);
  const after = await settled(second);
  // The cards change places, and take their pictures along.
  students[1]?.askForHelp();
  await expect(page.locator("[data-student]").first()).toHaveAttribute("data-student", "2");
  await expect.poll(() => pixels(page.locator("[data-picture]").nth(0))).not.toBe(before[0]);
  await expect.poll(() => pixels(page.locator("[data-picture]").nth(1))).not.toBe(after);
  for (const student of students) student.close();
});

test("the times of the cards stand while the class is paused", async ({ page, relay }) => {
  const teacher = await ClassTeacher.start(relay);
  const student = await ScriptedStudent.join(relay, teacher.code);
  student.report(opened);
  await page.goto(teacher.address());
  await expect(new DashboardPage(page).cards).toHaveCount(1);
  const time = page.locator("[data-student] ~ div [dir=ltr]");
  const picture = (): Promise<string> => pixels(time);
  const start = await picture();
  await expect.poll(picture).not.toBe(start);
  await teacher.direct("PUT", "/pause", { seconds: 300 });
  await expect(time).toHaveText(/^\d+:\d\d$/);
  student.close();
});
