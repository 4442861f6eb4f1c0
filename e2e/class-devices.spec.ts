/** A teacher with two devices: which of them controls the big screen, and that both know it. */
import type { Locator, Page } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import { DashboardPage } from "./pages/dashboard-page.ts";
import { cardOf, openDashboard, opened } from "./support/one-line-class.ts";
import { ScriptedStudent } from "./support/scripted-student.ts";
import { wideWindow } from "./support/window-sizes.ts";

test.use(wideWindow);

function onScreen(page: Page): Locator {
  return page.getByRole("button", { name: "Show on big screen" });
}

function offScreen(page: Page): Locator {
  return page.getByRole("button", { name: "Take off the big screen" });
}

test("the big screen follows the device of the newest choice, and the other one offers its run again", async ({
  page: laptop,
  relay,
  openWindow,
}) => {
  test.slow();
  const teacher = await openDashboard(laptop, relay);
  const students = [
    await ScriptedStudent.join(relay, teacher.code),
    await ScriptedStudent.join(relay, teacher.code),
  ] as const;
  for (const [at, student] of students.entries()) {
    student.report(opened);
    student.show({ state: "driving", tick: 60, pose: [350, 150 + 200 * at, 90], path: "e1" });
  }
  const { page: phone } = await openWindow(wideWindow);
  await phone.goto(teacher.address());
  const { page: screen } = await openWindow(wideWindow);
  await screen.goto(`${relay}/class/${teacher.created.id}#${teacher.created.screenKey}`);
  const robot = screen.locator("figure svg > g[transform*=rotate]");

  await cardOf(laptop, students[0]).click();
  await onScreen(laptop).click();
  await expect(robot).toHaveAttribute("transform", /translate\(3\.5 1\.5\)/);
  await cardOf(phone, students[1]).click();
  await onScreen(phone).click();
  await expect(robot).toHaveAttribute("transform", /translate\(3\.5 3\.5\)/);
  // One press brings the run of the laptop back.
  await onScreen(laptop).click();
  await expect(robot).toHaveAttribute("transform", /translate\(3\.5 1\.5\)/);
  await expect(offScreen(laptop)).toBeVisible();
  await expect(onScreen(phone)).toBeVisible();

  // The run of a device that is gone does not stay.
  await laptop.close();
  await expect(screen.getByText("Where robots bump")).toBeVisible();
  await expect(new DashboardPage(phone).cards).toHaveCount(2);
  for (const student of students) student.close();
});
