/** What a student of a class sees of the task, of help, and of a pause. */
import { lessonOfTasks } from "@corridor/challenge/testing";
import { expect, test } from "./fixtures.ts";
import { ClassTeacher } from "./support/class-teacher.ts";
import { classButton, enterClass } from "./support/enter-class.ts";
import { lessonTask, straight } from "./support/lesson-task.ts";
import { phone, tab } from "./support/phone.ts";
import { smallWindow, wideWindow } from "./support/window-sizes.ts";

test.use(smallWindow);

const NAMES = ["Juniper"];
const SENTENCE = "Drive to the flag. Turn right at the wall.";

/** "forward" bumps after 4 s. */
const corner = {
  ...straight,
  blocks: ["#######", "#.....#", "#####.#", "#######"],
  goals: [{ column: 5, row: 2 }],
};

const turns = lessonOfTasks("First turns", [
  lessonTask("Turn", [], {
    mazes: [corner],
    words: { task: SENTENCE, short: "", hints: ["Look ahead.", "Use front."] },
  }),
  lessonTask("Straight", []),
]);

for (const [name, options] of [
  ["a laptop", { viewport: { width: 1280, height: 720 } }],
  ["a phone", phone],
] as const) {
  test(`the task stays readable beside the reason of a bump, on ${name}`, async ({
    openWindow,
    relay,
  }) => {
    const teacher = await ClassTeacher.start(relay, NAMES, turns);
    const student = await openWindow(options);
    await enterClass(student.page, teacher.code);
    const task = student.page.getByText(SENTENCE);
    await expect(task.first()).toBeInViewport();
    await student.page.getByRole("combobox", { name: "Speed" }).selectOption("max");
    await student.page.getByRole("button", { name: "Run", exact: true }).click();
    const reason = student.page
      .getByText(/^Bump at 4\.\d s/)
      .and(student.page.locator(":not(.visually-hidden)"));
    await expect(student.page.getByRole("heading", { name: "Bump" })).toBeInViewport();
    await expect(reason.and(student.page.locator("span, [role=note]"))).toHaveCount(1);
    await expect(task.first()).toBeInViewport({ ratio: 1 });
    await expect(task.last()).toBeVisible();
    // Without the card, the reason is in the panel, below the task.
    await student.page.getByRole("button", { name: "Close", exact: true }).click();
    await expect(reason).toHaveRole("note");
    await expect(student.page.getByRole("region", { name: "Lesson" })).toContainText(SENTENCE);
  });
}

test("a student finds help in the task, and sees that the request has arrived", async ({
  page,
  relay,
}) => {
  await page.setViewportSize(wideWindow.viewport);
  const teacher = await ClassTeacher.start(relay, NAMES, turns);
  await enterClass(page, teacher.code);
  const card = page.getByRole("region", { name: "Lesson" });
  await card.getByRole("button", { name: "I need help" }).click();
  await expect(card.getByText("You asked for help. Your teacher sees it.")).toBeVisible();
  await expect(classButton(page)).toContainText("Asked for help");
  const helpSince = async () => (await teacher.read()).students[0]?.helpSince;
  await expect.poll(helpSince).not.toBeNull();
  await card.getByRole("button", { name: "I do not need help now" }).click();
  await expect.poll(helpSince).toBeNull();
});

test("the run continues after a pause of the class, as one run", async ({ page, relay }) => {
  const teacher = await ClassTeacher.start(relay, NAMES, turns);
  await enterClass(page, teacher.code);
  await expect(page.getByText(SENTENCE).first()).toBeVisible();
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await expect(page.getByRole("button", { name: "Pause", exact: true })).toBeVisible();
  await teacher.direct("PUT", "/pause", { seconds: 600 });
  await expect(page.getByText("Eyes to the front.", { exact: false }).first()).toBeVisible();
  await teacher.direct("DELETE", "/pause");
  // Nobody presses Run.
  await expect(page.getByRole("heading", { name: "Bump" })).toBeVisible();
  const runs = async () => (await teacher.progress()).filter(({ kind }) => kind === "run");
  await expect.poll(runs).toHaveLength(1);
});

test("a solved task of a class asks for no completion code", async ({ page, relay }) => {
  const straightOn = lessonOfTasks("First turns", [lessonTask("Straight", [])]);
  const teacher = await ClassTeacher.start(relay, NAMES, straightOn);
  await enterClass(page, teacher.code);
  await expect(page.getByText("Solve Straight.")).toBeVisible();
  await page.getByRole("combobox", { name: "Speed" }).selectOption("max");
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await expect(page.getByText("Task solved.", { exact: false }).first()).toBeVisible();
  await expect(page.getByText("Completion code")).toHaveCount(0);
});

test("only drivers that the task allows are offered", async ({ openWindow, page, relay }) => {
  const teacher = await ClassTeacher.start(relay, ["Juniper", "Comet"], turns);
  await enterClass(page, teacher.code);
  await expect(page.getByText(SENTENCE).first()).toBeVisible();
  await expect(page.getByRole("radio", { name: "Me", exact: true })).toHaveCount(0);
  const small = await openWindow(phone);
  await enterClass(small.page, teacher.code);
  await expect(small.page.getByText(SENTENCE).first()).toBeVisible();
  await expect(tab(small.page, "Drive")).toHaveCount(0);
  await expect(tab(small.page, "Program")).toBeVisible();
});
