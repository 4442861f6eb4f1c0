/**
 * Each mission has an address: for opening, for sharing, and for Back and Forward of the browser.
 */
import { expect, test } from "./fixtures.ts";
import { LessonsPanel } from "./pages/lessons-panel.ts";
import { smallWindow } from "./support/window-sizes.ts";

test.use(smallWindow);

test("opens a mission by its address, which stays while the mission is open, and which Share gives", async ({
  openWindow,
}) => {
  const corridor = await openWindow(smallWindow);
  await corridor.open("/#mission/side-opening");
  const { page } = corridor;
  const lessons = new LessonsPanel(page);
  await lessons.expectMission(7);
  await expect(page).toHaveURL(/\/#mission\/side-opening$/);
  await corridor.program.action(1).selectOption("delayed right 90");
  await page.reload();
  await lessons.expectMission(7);
  await expect(corridor.program.action(1)).toHaveValue("delayed right 90");
  await expect(page).toHaveURL(/\/#mission\/side-opening$/);
  await corridor.share.click();
  const dialog = corridor.dialog("Share this challenge");
  await expect(dialog.getByRole("textbox", { name: "Link" })).toHaveValue(
    /^http[^#]*\/#mission\/side-opening$/,
  );
});

test("goes back and forward between missions and the user's own maze", async ({
  corridor,
  page,
}) => {
  const lessons = new LessonsPanel(page);
  await lessons.openMission(3);
  await expect(page).toHaveURL(/#mission\/one-line$/);
  await lessons.openMission(4);
  await expect(page).toHaveURL(/#mission\/first-true-line$/);
  await page.goBack();
  await lessons.expectMission(3);
  await page.goBack();
  await expect(lessons.card).toBeHidden();
  await expect(corridor.mazeMenu).toHaveAccessibleName("Long way round, Maze menu");
  await expect(page).not.toHaveURL(/#/);
  await page.goForward();
  await lessons.expectMission(3);
  await lessons.button("Back to my maze").click();
  await expect(lessons.card).toBeHidden();
  await expect(page).not.toHaveURL(/#/);
});

test("reports that an address has no mission, and leads to the list of lessons", async ({
  openWindow,
}) => {
  const corridor = await openWindow(smallWindow);
  await corridor.open("/#mission/no-such-mission");
  await expect(corridor.message("There is no mission at this address.")).toBeVisible();
  await expect(corridor.page).not.toHaveURL(/#/);
  await corridor.page.getByRole("button", { name: "Show all lessons" }).click();
  await expect(new LessonsPanel(corridor.page).path).toBeVisible();
});
