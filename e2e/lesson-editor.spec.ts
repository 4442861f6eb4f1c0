/** Teachers make, try, solve and save lessons on `/teach`. */
import { encodeLink } from "@corridor/link";
import { shortLinkSchema } from "@corridor/protocol";
import type { Page } from "playwright/test";
import { sampleLesson } from "../apps/web/src/features/teach/testing/sample-lesson.ts";
import { expect, test } from "./fixtures.ts";
import { CorridorPage } from "./pages/corridor-page.ts";
import { MazeGrid } from "./pages/maze-grid.ts";
import { allButColours, axeViolations, expectNoAxeViolations } from "./support/axe.ts";
import { horizontalOverflow, smallTouchTargets } from "./support/layout.ts";
import { phone } from "./support/phone.ts";

const link = encodeLink({ lesson: sampleLesson });
const lessonAddress = `/teach#${link.ok ? link.text : ""}`;

/** The lesson editor. */
class LessonEditor {
  readonly page: Page;
  readonly name;
  readonly status;
  readonly tasks;
  readonly maze;

  constructor(page: Page) {
    this.page = page;
    this.name = page.getByRole("banner").getByRole("heading", { level: 2 });
    this.status = page.getByRole("banner").getByText("Saved", { exact: true });
    this.tasks = page
      .getByRole("navigation", { name: "Parts of the lesson" })
      .getByRole("listitem");
    this.maze = new MazeGrid(page);
  }

  /** Opens a task in the form. @param number from 1 */
  async openTask(number: number): Promise<void> {
    await this.tasks
      .nth(number - 1)
      .getByRole("button")
      .first()
      .click();
  }

  field(name: string) {
    return this.page.getByRole("textbox", { name, exact: true });
  }

  button(name: string) {
    return this.page.getByRole("button", { name, exact: true });
  }

  async chooseInMenu(menu: string, item: string): Promise<void> {
    await this.button(menu).click();
    await this.button(item).click();
  }

  /** Begins with an empty maze of 11 by 7 squares, and opens its task. */
  async beginEmpty(): Promise<void> {
    await this.page.goto("/teach");
    await this.page.getByRole("link", { name: /^Make a lesson/ }).click();
    await this.page.getByRole("button", { name: /^An empty maze/ }).click();
    await expect(this.maze.grid).toBeVisible();
    await this.openTask(1);
  }

  /** Solves the empty maze in the trial that is open, with one line. */
  async solveEmpty(): Promise<void> {
    const student = new CorridorPage(this.page);
    await student.program.addLine("front <", "60", "left 90");
    await student.speed.selectOption("max");
    await student.run.click();
  }
}

test("opens the lesson of a link, saves what the teacher changes, and copies and deletes lessons", async ({
  page,
}) => {
  const editor = new LessonEditor(page);
  await page.goto(lessonAddress);
  await expect(page).toHaveURL(/\/teach#lesson=\w+$/);
  await expect(editor.name).toHaveText("Two tasks");
  await expect(editor.tasks).toHaveCount(2);

  await editor.button("Lesson").click();
  await editor.field("Name of the lesson").fill("Sensors");
  await expect(editor.name).toHaveText("Sensors");
  await editor.openTask(2);
  await editor.field("Task").fill("Find the door.");
  await expect(editor.status).toBeVisible();
  await page.reload();
  await expect(editor.name).toHaveText("Sensors");

  await page.goto("/teach");
  await editor.chooseInMenu("More for Sensors", "Make a copy");
  const lessons = page.getByRole("link", { name: "Sensors" });
  await expect(lessons).toHaveCount(2);
  const more = page.getByRole("button", { name: "More for Sensors" }).first();
  await more.click();
  await editor.button("Delete").click();
  await expect(lessons).toHaveCount(1);
  await editor.button("Undo").click();
  await expect(lessons).toHaveCount(2);

  await more.click();
  await editor.button("Check hand-ins").click();
  await expect(page.getByRole("heading", { name: "Sensors" })).toBeVisible();
  await expect(page).toHaveURL(/#hand-ins$/);
});

test("begins with the 2013 study, or with a maze that a student shares", async ({ page }) => {
  const editor = new LessonEditor(page);
  await page.goto("/teach#make");
  await page.getByRole("button", { name: /^The 2013 study/ }).click();
  await expect(editor.name).toHaveText("The 2013 study");
  await expect(editor.tasks).toHaveText([
    /Make it move/,
    /How far is the wall/,
    /One line/,
    /The first true line/,
    /Follow the right wall/,
    /The farthest distance/,
  ]);
  await page.getByRole("button", { name: /^Survey/ }).click();
  await expect(editor.field("Question 2")).toHaveValue(/how a robot finds its way/);
  await expect(editor.field("Question 4")).toHaveValue(/how we all work with computers/);

  const student = new CorridorPage(page);
  await student.open();
  await student.share.click();
  await page.getByRole("link", { name: "Teaching? Make a lesson of this" }).click();
  await expect(editor.name).toHaveText("Long way round");
  await expect(editor.tasks).toHaveText([/Task 1/]);

  const stored = await page.request.post("/api/v1/mazes", {
    data: sampleLesson.tasks[0]?.mazes[0],
  });
  const { address } = shortLinkSchema.parse(await stored.json());
  await page.goto("/teach#make");
  await editor.field("Link or short link of a lesson or a maze").fill(address);
  await page.keyboard.press("Enter");
  await expect(editor.tasks).toHaveText([/Task 1/]);
});

test("asks for the name of a new lesson first, and typed text goes into the field that a button adds", async ({
  page,
}) => {
  const editor = new LessonEditor(page);
  await page.goto("/teach#make");
  await page.getByRole("button", { name: /^Your maze Long way round/ }).click();
  await expect(editor.name).toHaveText("Long way round");
  await page.goto("/teach#make");
  await page.getByRole("button", { name: /^An empty maze/ }).click();
  await expect(editor.field("Name of the lesson")).toBeFocused();
  await expect(page.getByText("This lesson has no name yet.")).toBeVisible();
  await page.keyboard.type("Round the corner");
  await expect(page.getByText("This lesson has no name yet.")).toBeHidden();
  await expect(editor.name).toHaveText("Round the corner");
  await editor.button("Next: the task").click();
  await expect(editor.field("Name")).toHaveValue("Task 1");
  // Whether students may drive by hand too is in sight.
  const byHand = page.getByRole("checkbox", { name: "the student, by hand" });
  await expect(byHand).not.toBeChecked();
  await expect(byHand).toBeInViewport();
  await expect(page.getByRole("textbox", { name: "Lines" }).first()).toHaveAccessibleDescription(
    /“Otherwise” does not count as a line/,
  );

  // Blank fields are not shared.
  await editor.button("Hint").press("Space");
  await expect(editor.field("Hint 1")).toBeFocused();
  await page.keyboard.type("Look to the right");
  await editor.button("Hint").click();
  await expect(editor.field("Hint 2")).toBeFocused();
  // There is already a blank one.
  await editor.button("Hint").click();
  await expect(editor.field("Hint 2")).toBeFocused();
  await expect(editor.field("Hint 3")).toHaveCount(0);

  await editor.button("Survey").click();
  await editor.button("Question").press("Enter");
  await expect(editor.field("Question 1")).toBeFocused();
  await page.keyboard.type("How was it?");
  await editor.button("Question").click();
  await expect(editor.field("Question 2")).toBeFocused();
  await expect(editor.status).toBeVisible();
  await page.reload();
  await editor.button("Survey: 1 question").click();
  await expect(editor.field("Question 1")).toHaveValue("How was it?");
  await editor.openTask(1);
  await expect(editor.field("Hint 1")).toHaveValue("Look to the right");
  await expect(editor.field("Hint 2")).toHaveCount(0);
});

test("has one history, begins further tasks with a mission, a maze or a link, and warns before it shares", async ({
  page,
}) => {
  const editor = new LessonEditor(page);
  await editor.beginEmpty();
  await editor.field("Name").fill("Round the corner");
  await editor.maze.click({ column: 4, row: 6 });
  await editor.button("Task").click();
  await page.getByRole("button", { name: /^An empty maze/ }).click();
  await expect(editor.tasks).toHaveCount(2);
  // The name of the new task has the focus, and text fields undo their own text.
  await editor.button("Undo").click();
  await expect(editor.tasks).toHaveCount(1);
  await page.keyboard.press("Control+z");
  await page.keyboard.press("Control+z");
  await expect(editor.field("Name")).toHaveValue("Task 1");
  await expect(editor.button("Undo")).toBeDisabled();
  await page.keyboard.press("Control+Shift+z");
  await expect(editor.field("Name")).toHaveValue("Round the corner");

  // The name of a task that begins with a mission has the focus.
  await editor.button("Task").click();
  const dialog = page.getByRole("dialog", { name: "Add a task" });
  await expect(dialog.getByRole("button", { name: /^Your maze/ })).toBeVisible();
  await expectNoAxeViolations(page, "add a task");
  await dialog.getByRole("button", { name: "Follow the right wall" }).click();
  await expect(editor.tasks).toHaveText([/Round the corner/, /Follow the right wall/]);
  await expect(editor.field("Name")).toBeFocused();
  await expect(editor.field("Task")).not.toHaveValue("");

  await editor.button("Task").click();
  const link = dialog.getByRole("textbox", { name: "Link or short link of a lesson or a maze" });
  await link.fill("nonsense");
  await page.keyboard.press("Enter");
  await expect(dialog.getByRole("alert")).toContainText("This is not a link of Corridor");
  await link.fill(lessonAddress);
  await dialog.getByRole("button", { name: "Add", exact: true }).click();
  await expect(editor.tasks).toHaveText([
    /Round the corner/,
    /Follow the right/,
    /Two mazes/,
    /One maze/,
  ]);
  await editor.button("Undo").click();
  await expect(editor.tasks).toHaveCount(2);

  await editor.openTask(1);
  await editor.maze.drag([0, 1].map((row) => ({ column: 9, row })));
  await editor.maze.click({ column: 10, row: 2 });
  await expect(page.getByText("No path leads to the goal of maze 1.")).toBeVisible();
  await editor.button("Share lesson").click();
  const share = page.getByRole("dialog");
  await expect(share).toContainText("You have not solved this lesson yet.");
  await expect(share).toContainText("This lesson has no name yet.");
  await share.getByRole("button", { name: "Share anyway" }).click();
  await expect(share.getByRole("textbox", { name: "Link" })).toHaveValue(/\/#\S+$/);
});

test("lets the teacher solve each task, which sets its numbers", async ({ page }) => {
  const editor = new LessonEditor(page);
  await editor.beginEmpty();
  await expect(page.getByText("You have not solved this task yet.")).toBeVisible();
  await editor.button("Solve it once").click();
  const student = new CorridorPage(page);
  const band = page.getByRole("region", { name: "Trial" });
  await expect(band).toContainText("Solve this task once");
  await editor.solveEmpty();
  await expect(band.getByRole("status")).toHaveText(/^passes: 1 line, \d+\.\d s$/);
  await band.getByRole("button", { name: "Back to the editor" }).click();

  await expect(page.getByText(/^passes: 1 line/)).toBeVisible();
  await expect(page.getByText("You have not solved this task yet.")).toBeHidden();
  await expect(page.getByRole("checkbox", { name: "A good solution" })).toBeChecked();
  // An edit of the maze needs another solution; undo restores this one.
  await editor.maze.click({ column: 4, row: 3 });
  await expect(page.getByText("You have not solved this task yet.")).toBeVisible();
  await editor.button("Undo").click();
  await expect(page.getByText(/^passes: 1 line/)).toBeVisible();
  await expect(editor.status).toBeVisible();

  // A solution belongs to its maze, so that equal tasks have one.
  await editor.maze.click({ column: 4, row: 3 });
  await editor.button("Task").click();
  await page.getByRole("button", { name: /^An empty maze/ }).click();
  await expect(editor.tasks).toHaveCount(2);
  // The added task is open.
  await editor.maze.click({ column: 5, row: 3 });
  await editor.button("Solve it once").click();
  await editor.solveEmpty();
  await band.getByRole("button", { name: "Solve task 1" }).click();
  await expect(band.getByRole("button", { name: /^Solve task/ })).toBeHidden();
  await expect(band.getByRole("status")).toBeEmpty();
  await editor.solveEmpty();
  await expect(band.getByRole("status")).toContainText("passes: 1 line");
  // Both are solved.
  await expect(band.getByRole("button", { name: /^Solve task/ })).toBeHidden();
  await band.getByRole("button", { name: "Back to the editor" }).click();
  await expect(page.getByText("You have not solved this task yet.")).toBeHidden();
  await expect(editor.status).toBeVisible();

  await page.goto("/teach");
  await expect(page.getByText("solved by you")).toBeVisible();

  // The student's page of this device has nothing of it.
  await student.open();
  await expect(student.mazeMenu).toHaveAccessibleName(/^Long way round/);
});

test("shares a lesson as a short link, a picture, a file and with other apps", async ({
  openWindow,
}) => {
  const { page } = await openWindow(phone);
  // Headless browsers have no share sheet.
  await page.addInitScript(() => {
    Reflect.set(navigator, "share", (data: ShareData) => {
      document.documentElement.dataset["shared"] = data.url;
      return Promise.resolve();
    });
  });
  const intro = Array.from({ length: 190 }, (_, at) => (at ** 3 % 997).toString(36)).join("");
  const long = encodeLink({ lesson: { ...sampleLesson, intro } });
  await page.goto(`/teach#${long.ok ? long.text : ""}`);
  await expect(page).toHaveURL(/#lesson=/);
  await page.goto("/teach");
  const share = page.getByRole("button", { name: "Share", exact: true });
  await share.click();
  const dialog = page.getByRole("dialog", { name: "Share lesson" });
  await dialog.getByRole("button", { name: "Share anyway" }).click();
  const field = dialog.getByRole("textbox", { name: "Link" });
  await expect(field).toHaveValue(/\/#\S+$/);
  const classroom = dialog.getByRole("link", { name: "Google Classroom" });
  // A long link never enters a query string.
  await expect(dialog).toContainText(
    "The link is too long for a QR code and for Google Classroom.",
  );
  await expect(classroom).toHaveCount(0);

  await dialog.getByRole("button", { name: "Short link", exact: true }).click();
  await expect(field).toHaveValue(/\/m\/[A-Z]{4,6}$/);
  const link = await field.inputValue();
  await expect(classroom).toHaveAttribute(
    "href",
    `https://classroom.google.com/share?url=${encodeURIComponent(link)}`,
  );
  await dialog.getByRole("button", { name: "Share with an app" }).click();
  await expect(page.locator("html")).toHaveAttribute("data-shared", link);
  for (const [button, file] of [
    ["Save picture", "two-tasks.svg"],
    ["Save as a file", "two-tasks.lesson.json"],
  ] as const) {
    const download = page.waitForEvent("download");
    await dialog.getByRole("button", { name: button }).click();
    expect((await download).suggestedFilename()).toBe(file);
  }
  await expect(dialog.getByRole("figure", { name: "QR code of the link" })).toBeVisible();
  await expectNoAxeViolations(page, "share");
  // Behind the dialog, the whole row of a saved lesson is a link, not only its name.
  const small = await smallTouchTargets(page);
  expect(small.filter((target) => !target.startsWith("Two tasks:"))).toEqual([]);
  await page.setViewportSize({ width: 320, height: 640 });
  await expect.poll(() => horizontalOverflow(page)).toEqual([]);

  await page.context().setOffline(true);
  await expect(dialog).toContainText("You are offline.");
  await page.keyboard.press("Escape");
  await expect(share).toBeFocused();
});

test("keeps both versions if two tabs change a lesson", async ({ page, context }) => {
  const editor = new LessonEditor(page);
  await page.goto(lessonAddress);
  await expect(editor.name).toHaveText("Two tasks");
  const other = new LessonEditor(await context.newPage());
  await other.page.goto(page.url());
  for (const [each, name] of [
    [other, "Theirs"],
    [editor, "Mine"],
  ] as const) {
    await each.button("Lesson").click();
    const stored = () => each.page.evaluate(() => JSON.stringify(localStorage));
    const before = await stored();
    await each.field("Name of the lesson").fill(name);
    await expect.poll(stored).not.toBe(before);
  }
  await expect(page.getByText("This one is now a copy.")).toBeVisible();
  await page.goto("/teach");
  await expect(page.getByRole("link", { name: "Theirs" })).toBeVisible();
  await page.getByRole("link", { name: "Mine" }).click();
  await expect(editor.name).toHaveText("Mine");
});

test("is accessible, and fits a phone and 320 px in a right-to-left language", async ({
  page,
  openWindow,
}) => {
  test.slow();
  await page.goto(lessonAddress);
  await expect(new MazeGrid(page).grid).toBeVisible();
  await expectNoAxeViolations(page, "editor");
  for (const locale of ["en-US", "ar-EG"]) {
    const small = (await openWindow({ ...phone, locale })).page;
    // Both languages have the same colours.
    const expectAccessible = async (state: string): Promise<void> =>
      locale === "en-US"
        ? expectNoAxeViolations(small, state)
        : expect(await axeViolations(small, allButColours), state).toEqual([]);
    await small.goto("/teach#make");
    await expect(small.getByRole("main").getByRole("textbox")).toBeVisible();
    await expectAccessible(`${locale}, beginnings`);
    await small.goto(lessonAddress);
    const tabs = small.getByRole("tab");
    await expect(tabs).toHaveCount(4);
    for (const at of [0, 1, 2, 3]) {
      await tabs.nth(at).click();
      await expectAccessible(`${locale}, tab ${at}`);
      expect(await smallTouchTargets(small), `${locale}, tab ${at}`).toEqual([]);
      for (const width of [390, 320]) {
        await small.setViewportSize({ width, height: 640 });
        await expect
          .poll(() => horizontalOverflow(small), `${locale}, tab ${at}, ${width} px`)
          .toEqual([]);
      }
    }
  }
});
