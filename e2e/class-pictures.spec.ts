/** The pictures on the cards of a dashboard. */
import type { Locator, Page } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import { DashboardPage } from "./pages/dashboard-page.ts";
import { ClassTeacher } from "./support/class-teacher.ts";
import { ScriptedStudent } from "./support/scripted-student.ts";

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
  // The card moves to the place of the other one, and takes its picture along.
  students[1]?.askForHelp();
  await expect(new DashboardPage(page).cards.first()).toHaveAccessibleName(/Asks for help/);
  await expect.poll(() => pixels(second)).toBe(after);
  expect(await pixels(first)).toBe(before[0]);
  for (const student of students) student.close();
});
