/** What a student of a class sees of the task, of a bump, of help and of the drivers. */
import { lessonOfTasks } from "@corridor/challenge/testing";
import type { Page } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import { ClassTeacher } from "./support/class-teacher.ts";
import { classButton, enterClass } from "./support/enter-class.ts";
import { lessonTask, straight } from "./support/lesson-task.ts";
import { phone, tab } from "./support/phone.ts";

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

/** Bumps with the program of the task, whose text stays readable beside the reason. */
async function expectTaskBesideBump(page: Page): Promise<void> {
  const task = page.getByText(SENTENCE);
  await page.getByRole("combobox", { name: "Speed" }).selectOption("max");
  await page.getByRole("button", { name: "Run", exact: true }).click();
  // The announcements are not displayed.
  const displayed = page.locator(":not(.visually-hidden, #spoken *)");
  const reason = page.getByText(/^Bump at 4\.\d s/).and(displayed);
  await expect(page.getByRole("heading", { name: "Bump" })).toBeInViewport();
  await expect(reason.and(page.locator("span, [role=note]"))).toHaveCount(1);
  await expect(task.first()).toBeInViewport({ ratio: 1 });
  await expect(task.last()).toBeVisible();
  // Without the card, the reason is in the panel, below the task.
  await page.getByRole("button", { name: "Close", exact: true }).click();
  await expect(reason).toHaveRole("note");
  await expect(page.getByRole("region", { name: "Lesson" })).toContainText(SENTENCE);
}

test("on a laptop, the task has help, only its drivers, and stays readable beside a bump", async ({
  page,
  relay,
}) => {
  await page.setViewportSize({ width: 1280, height: 720 });
  const teacher = await ClassTeacher.start(relay, NAMES, turns);
  await enterClass(page, teacher.code);
  await expect(page.getByText(SENTENCE).first()).toBeInViewport();
  await expect(page.getByRole("radio", { name: "Me", exact: true })).toHaveCount(0);
  const card = page.getByRole("region", { name: "Lesson" });
  await card.getByRole("button", { name: "I need help" }).click();
  await expect(card.getByText("You asked for help. Your teacher sees it.")).toBeVisible();
  await expect(classButton(page)).toContainText("Asked for help");
  const helpSince = async () => (await teacher.read()).students[0]?.helpSince;
  await expect.poll(helpSince).not.toBeNull();
  await card.getByRole("button", { name: "I do not need help now" }).click();
  await expect.poll(helpSince).toBeNull();
  await expectTaskBesideBump(page);
});

test("on a phone, the task has no drive keys, and stays readable beside a bump", async ({
  openWindow,
  relay,
}) => {
  const teacher = await ClassTeacher.start(relay, NAMES, turns);
  const { page } = await openWindow(phone);
  await enterClass(page, teacher.code);
  await expect(page.getByText(SENTENCE).first()).toBeInViewport();
  await expect(tab(page, "Drive")).toHaveCount(0);
  await expect(tab(page, "Program")).toBeVisible();
  await expectTaskBesideBump(page);
});
