/** Teachers make, try, solve and save lessons on `/teach`. */
import { encodeLink } from "@corridor/link";
import { shortLinkSchema } from "@corridor/protocol";
import type { BrowserContext } from "playwright/test";
import { sampleLesson } from "../apps/web/src/features/teach/testing/sample-lesson.ts";
import { expect, test } from "./fixtures.ts";
import { CorridorPage } from "./pages/corridor-page.ts";
import { LessonEditor } from "./pages/lesson-editor.ts";
import { expectNoAxeViolations } from "./support/axe.ts";
import { smallWindow } from "./support/window-sizes.ts";

test.use(smallWindow);

const link = encodeLink({ lesson: sampleLesson });
const lessonAddress = `/teach#${link.ok ? link.text : ""}`;
/** The list of lessons, without a load of the page. */
const list = "/teach#";

test("opens the lesson of a link, saves what the teacher changes, copies and deletes lessons, and keeps both versions of two tabs", async ({
  page,
  context,
}) => {
  const editor = new LessonEditor(page);
  await page.goto(lessonAddress);
  await expect(page).toHaveURL(/\/teach#lesson=\w+$/);
  await expect(editor.name).toHaveText("Two tasks");
  await expect(editor.tasks).toHaveCount(2);
  await expect(editor.maze.grid).toBeVisible();
  await expectNoAxeViolations(page, "editor");

  await test.step("saves what the teacher changes", async () => {
    await editor.button("Lesson").click();
    await editor.field("Name of the lesson").fill("Sensors");
    await expect(editor.name).toHaveText("Sensors");
    await editor.openTask(2);
    await editor.field("Task").fill("Find the door.");
    await expect(editor.status).toBeVisible();
    await page.reload();
    await expect(editor.name).toHaveText("Sensors");
  });

  await test.step("copies and deletes lessons, and leads to the hand-ins", async () => {
    await page.goto(list);
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

  await test.step("keeps both versions if two tabs change a lesson", () =>
    changeInTwoTabs(editor, context));
});

async function changeInTwoTabs(editor: LessonEditor, context: BrowserContext): Promise<void> {
  const { page } = editor;
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
  await page.goto(list);
  await expect(page.getByRole("link", { name: "Theirs" })).toBeVisible();
  await page.getByRole("link", { name: "Mine" }).click();
  await expect(editor.name).toHaveText("Mine");
}

test("lets the teacher solve each task, and begins with the 2013 study, or with a maze that a student shares", async ({
  page,
}) => {
  const editor = new LessonEditor(page);
  await editor.beginEmpty();
  await test.step("a solution sets the numbers of its task", () => solveOnce(editor));
  await test.step("equal tasks have one solution each", () => solveBoth(editor));
  await test.step("a shared lesson stays the same when it is solved", () => solveShared(editor));
  await page.goto(list);
  await expect(page.getByText("solved by you")).toBeVisible();

  await test.step("begins with the 2013 study", async () => {
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
  });

  await test.step("begins with the maze of a student", async () => {
    const student = new CorridorPage(page);
    await student.open();
    // The student's page of this device has nothing of the trials.
    await expect(student.mazeMenu).toHaveAccessibleName(/^Long way round/);
    await student.share.click();
    await page.getByRole("link", { name: "Teaching? Make a lesson of this" }).click();
    await expect(editor.name).toHaveText("Long way round");
    await expect(editor.tasks).toHaveText([/Task 1/]);
  });

  await test.step("begins with the short link of a maze", async () => {
    const stored = await page.request.post("/api/v1/mazes", {
      data: sampleLesson.tasks[0]?.mazes[0],
    });
    const { address } = shortLinkSchema.parse(await stored.json());
    await page.goto("/teach#make");
    await editor.field("Link or short link of a lesson or a maze").fill(address);
    await page.keyboard.press("Enter");
    await expect(editor.tasks).toHaveText([/Task 1/]);
  });
});

function trialOf({ page }: LessonEditor) {
  return page.getByRole("region", { name: "Trial" });
}

/** Solves the first task, and changes its maze. */
async function solveOnce(editor: LessonEditor): Promise<void> {
  const { page } = editor;
  const unsolved = page.getByText("You have not solved this task yet.");
  const band = trialOf(editor);
  await expect(unsolved).toBeVisible();
  await editor.button("Solve it once").click();
  await expect(band).toContainText("Solve this task once");
  await editor.solveEmpty();
  await expect(band.getByRole("status")).toHaveText(/^passes: 1 line, \d+\.\d s$/);
  await band.getByRole("button", { name: "Back to the editor" }).click();

  await expect(page.getByText(/^passes: 1 line/)).toBeVisible();
  await expect(unsolved).toBeHidden();
  await expect(page.getByRole("checkbox", { name: "A good solution" })).toBeChecked();
  // An edit of the maze needs another solution; undo restores this one.
  await editor.maze.click({ column: 4, row: 3 });
  await expect(unsolved).toBeVisible();
  await editor.button("Undo").click();
  await expect(page.getByText(/^passes: 1 line/)).toBeVisible();
  await expect(editor.status).toBeVisible();
}

/** Adds a task, and solves both. A solution belongs to its maze, so that equal tasks have one. */
async function solveBoth(editor: LessonEditor): Promise<void> {
  const { page } = editor;
  const band = trialOf(editor);
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
}

/** Shares an unsolved task, and solves it: the codes of students stay those of the lesson. */
async function solveShared(editor: LessonEditor): Promise<void> {
  const { page } = editor;
  const dialog = page.getByRole("dialog");
  const link = dialog.getByRole("textbox", { name: "Link" });
  await editor.maze.click({ column: 6, row: 3 });
  await editor.button("Share lesson").click();
  await dialog.getByRole("button", { name: "Share anyway" }).click();
  const shared = await link.inputValue();
  await page.keyboard.press("Escape");
  await editor.button("Solve it once").click();
  await editor.solveEmpty();
  await expect(trialOf(editor).getByRole("status")).toContainText("passes: 1 line");
  await trialOf(editor).getByRole("button", { name: "Back to the editor" }).click();
  await expect(page.getByText(/^passes: 1 line/)).toBeVisible();
  await editor.button("Share lesson").click();
  await expect(link).toHaveValue(shared);
  await page.keyboard.press("Escape");
}

test("asks for the name of a new lesson first, puts typed text into the field that a button adds, has one history, and warns before it shares", async ({
  page,
}) => {
  const editor = new LessonEditor(page);
  await editor.beginEmpty();
  await test.step("has one history of the form and the maze", () => undoAndRedo(editor));
  await test.step("begins further tasks with a mission, a maze or a link", () => addTasks(editor));
  await test.step("warns before it shares", () => shareUnsolved(editor));
  await page.goto("/teach#make");
  await page.getByRole("button", { name: /^Your maze Long way round/ }).click();
  await expect(editor.name).toHaveText("Long way round");
  await page.goto("/teach#make");
  await test.step("asks for the name of a new lesson first", () => nameLesson(editor));
  await test.step("typed text goes into the field that a button adds", () => addFields(editor));
});

async function undoAndRedo(editor: LessonEditor): Promise<void> {
  const { page } = editor;
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
}

async function addTasks(editor: LessonEditor): Promise<void> {
  const { page } = editor;
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
  const field = dialog.getByRole("textbox", { name: "Link or short link of a lesson or a maze" });
  await field.fill("nonsense");
  await page.keyboard.press("Enter");
  await expect(dialog.getByRole("alert")).toContainText("This is not a link of Corridor");
  await field.fill(lessonAddress);
  await dialog.getByRole("button", { name: "Add", exact: true }).click();
  await expect(editor.tasks).toHaveText([
    /Round the corner/,
    /Follow the right/,
    /Two mazes/,
    /One maze/,
  ]);
  await editor.button("Undo").click();
  await expect(editor.tasks).toHaveCount(2);
}

async function shareUnsolved(editor: LessonEditor): Promise<void> {
  const { page } = editor;
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
  await page.keyboard.press("Escape");
}

/** Begins with an empty maze, and opens its task. */
async function nameLesson(editor: LessonEditor): Promise<void> {
  const { page } = editor;
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
  await page.setViewportSize({ width: 1440, height: 900 });
  await expect(byHand).toBeInViewport();
  await page.setViewportSize(smallWindow.viewport);
  await expect(page.getByRole("textbox", { name: "Lines" }).first()).toHaveAccessibleDescription(
    /“Otherwise” does not count as a line/,
  );
}

/** Adds hints and questions. Blank ones are not shared. */
async function addFields(editor: LessonEditor): Promise<void> {
  const { page } = editor;
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
}
