/** The page of a student in a class: connection, class menu, and how the class ends. */
import { lessonOfTasks } from "@corridor/challenge/testing";
import type { BrowserContext, Locator, Page } from "playwright/test";
import { SeededRandom } from "../apps/relay/src/testing/faults/seeded-random.ts";
import { FaultProxy } from "./faults/net/fault-proxy.ts";
import { expect, test } from "./fixtures.ts";
import { CorridorPage } from "./pages/corridor-page.ts";
import { expectNoAxeViolations } from "./support/axe.ts";
import { ClassTeacher } from "./support/class-teacher.ts";
import { chooseLanguage } from "./support/choose-language.ts";
import { classButton, enterClass, openAsStudent } from "./support/enter-class.ts";
import { lessonTask, straight } from "./support/lesson-task.ts";
import { horizontalOverflow, smallTouchTargets } from "./support/layout.ts";
import { smallestPhone, phone } from "./support/phone.ts";
import { Texts } from "./support/texts.ts";
import { smallWindow, wideWindow } from "./support/window-sizes.ts";

test.use(smallWindow);

const NAMES = ["Team 1", "Team 2", "Team 3", "Team 4"];
/** Of 24 characters each, the longest that a name may have. */
const LONG_NAMES = ["First", "Other", "Third", "Extra"].map((word) => `${word} name of 24 letters`);

/** "forward" bumps after 4 s. */
const corner = {
  ...straight,
  blocks: ["#######", "#.....#", "#####.#", "#######"],
  goals: [{ column: 5, row: 2 }],
};
const hints = ["Look ahead.", "Use front."];
const lesson = lessonOfTasks("Turns", [
  lessonTask("Turn", hints, { mazes: [corner] }),
  lessonTask("Straight", []),
]);

function menuOf(page: Page): Locator {
  return page.getByRole("dialog", { name: "Class" });
}

/** Opens the class menu of a student who is connected. */
async function openMenu(page: Page): Promise<Locator> {
  await classButton(page).click();
  await expect(item(page, "I need help")).toBeVisible();
  return menuOf(page);
}

function item(page: Page, name: string | RegExp): Locator {
  return menuOf(page).getByRole("button", { name });
}

/** The card of the lesson. What the lesson needs has loaded once it is there. */
function cardOf(page: Page): Locator {
  return page.getByRole("region", { name: "Lesson", exact: true });
}

/** A copy of the tab, as "Duplicate tab" makes it: with the same session storage. */
async function duplicate(context: BrowserContext, page: Page): Promise<Page> {
  const stored = await page.evaluate(() => sessionStorage.getItem("corridor.class"));
  const copy = await context.newPage();
  await copy.addInitScript((text) => sessionStorage.setItem("corridor.class", text ?? ""), stored);
  await copy.goto(page.url());
  return copy;
}

test("help, the eye of a watching teacher, new names and a pause reach the student, until the student is removed", async ({
  page,
  relay,
}) => {
  const teacher = await ClassTeacher.start(relay, LONG_NAMES, lesson);
  const corridor = await enterClass(page, teacher.code);
  await expect(cardOf(page)).toBeVisible();
  const student: Student = { corridor, page, teacher };

  await page.setViewportSize(wideWindow.viewport);
  await test.step("a request for help stays until the student or a hint of the teacher ends it", () =>
    askForHelp(student));

  await test.step("an eye is there while the teacher watches", async () => {
    const watched = page.getByRole("button", { name: "in class. Your teacher is watching you." });
    await expect(watched).toBeHidden();
    const end = await teacher.watch(1);
    await expect(watched).toBeVisible();
    end();
    await expect(watched).toBeHidden();
  });
  await page.setViewportSize(smallWindow.viewport);

  const name = await test.step("a student gets another name twice", () => changeName(student));
  await test.step("a pause stops the robot until the teacher ends it, also after a reload", () =>
    pause(student));

  await test.step("the name stays after the reload", async () => {
    await expect(page.getByRole("button", { name: `${name}, in class` })).toBeVisible();
    await openMenu(page);
    await expect(item(page, "Another name (0 left)")).toBeDisabled();
    expect((await teacher.read()).students).toHaveLength(1);
    await page.keyboard.press("Escape");
  });

  await test.step("a pause ends by the clock", async () => {
    const band = bandOf(page);
    await teacher.direct("PUT", "/pause", { seconds: 10 });
    await expect(band).toBeVisible();
    await band.waitFor({ state: "hidden", timeout: 60_000 });
  });

  await test.step("a removed student keeps the work", async () => {
    await corridor.run.click();
    await expect(corridor.pause).toBeVisible();
    await teacher.direct("DELETE", "/students/1");
    await expect(corridor.messages).toContainText("You are no longer in this class.");
    await expectOut(corridor);
  });
});

interface Student {
  corridor: CorridorPage;
  page: Page;
  teacher: ClassTeacher;
}

async function askForHelp({ page, teacher }: Student): Promise<void> {
  const dashboard = await teacher.connect();
  const menu = await openMenu(page);
  const helpSince = async () => (await teacher.read()).students[0]?.helpSince;
  expect(await helpSince()).toBeNull();
  await item(page, "I need help").click();
  await expect(menu.getByText("You asked for help. Your teacher sees it.")).toBeVisible();
  await expect.poll(helpSince).not.toBeNull();
  await menu.getByText("What my teacher sees").click();
  await expect(menu.getByText("Deleted when the lesson ends.")).toBeVisible();
  await expectNoAxeViolations(page, "class menu");
  await item(page, "I do not need help now").click();
  await expect.poll(helpSince).toBeNull();
  await item(page, "I need help").click();
  await page.keyboard.press("Escape");
  await expect(classButton(page)).toHaveAccessibleName(
    /, in class\. You asked for help\. Your teacher sees it\.$/,
  );
  await expect(classButton(page)).toContainText("Asked for help");
  await expect.poll(helpSince).not.toBeNull();
  for (const width of [1440, 1200, 1024, 900, 768, 600]) {
    await page.setViewportSize({ width, height: 800 });
    await expect(classButton(page)).toBeVisible();
    await expect.poll(() => horizontalOverflow(page), `${width} px`).toEqual([]);
  }
  await page.setViewportSize(wideWindow.viewport);
  dashboard.send({ type: "hint", student: 1, task: 1, hint: 1 });
  await expect(classButton(page)).toHaveAccessibleName(/, in class$/);
  await expect.poll(helpSince).toBeNull();
  dashboard.close();
}

/** @returns the second other name, after which there is no more */
async function changeName({ page, teacher }: Student): Promise<string> {
  await openMenu(page);
  for (const left of [1, 0]) {
    await item(page, /^Another name/).click();
    await expect(item(page, `Another name (${left} left)`)).toBeVisible();
  }
  await expect(item(page, /^Another name/)).toBeDisabled();
  const name = (await teacher.read()).students[0]?.name.text ?? "";
  await expect(page.getByRole("button", { name: `${name}, in class` })).toBeVisible();
  await page.keyboard.press("Escape");
  return name;
}

/** The band of a pause. The live region has a longer text. */
function bandOf(page: Page): Locator {
  return page.getByText("Eyes to the front. Your teacher paused the class.", { exact: true });
}

async function pause({ corridor, page, teacher }: Student): Promise<void> {
  const band = bandOf(page);
  const runButton = page.locator("button[data-does]");

  // The run continues after a pause, as one run. Nobody presses Run.
  await corridor.run.click();
  await expect(corridor.pause).toBeVisible();
  await teacher.direct("PUT", "/pause", { seconds: 600 });
  await expect(band).toBeVisible();
  await teacher.direct("DELETE", "/pause");
  await expect(page.getByRole("heading", { name: "Bump" })).toBeVisible();
  const runs = async () => (await teacher.progress()).filter(({ kind }) => kind === "run");
  await expect.poll(runs).toHaveLength(1);

  await corridor.reset.click();
  // The robot turns on the spot, however long the next steps take.
  await corridor.program.otherwise.selectOption("turn 180");
  await corridor.run.click();
  await expect(runButton).toHaveAttribute("data-does", "pause");
  await teacher.direct("PUT", "/pause", { seconds: 1_800 });
  await expect(band).toBeVisible();
  await expect(page.getByText(/^(30:00|29:\d\d) left\.$/)).toBeVisible();
  await expect(runButton).not.toHaveAttribute("data-does", "pause");
  await page.keyboard.press("Space");
  expect(await runButton.evaluate((button) => button.closest("[inert]") !== null)).toBe(true);
  await expectNoAxeViolations(page, "paused");
  // The slider behind the timeline is invisible also where the rest is dimmed.
  const slider = page.getByRole("slider", { name: "Timeline", includeHidden: true });
  await expect(slider).toHaveCSS("opacity", "0");
  await page.reload();
  await band.waitFor();
  await expect(runButton).not.toHaveAttribute("data-does", "pause");
  await openMenu(page);
  await teacher.direct("DELETE", "/pause");
  await expect(band).toBeHidden();
  await expect(corridor.messages).toContainText("You can continue.");
  await page.keyboard.press("Escape");
  await corridor.run.click();
  await expect(corridor.pause).toBeVisible();
  await corridor.reset.click();
}

test("the page works without the network, the newest tab has the class, and its end or leaving it leaves the work", async ({
  openWindow,
  pageErrors,
  relay,
}) => {
  pageErrors.ignoreFailedRequests();
  const teacher = await ClassTeacher.start(relay, NAMES, lesson);
  const target = Number(new URL(relay).port);
  const network = await FaultProxy.start({ target: () => target, random: new SeededRandom(1) });
  const { page } = await openWindow(smallWindow);
  const corridor = await enterClass(page, teacher.code, network.origin);
  const { messages } = corridor;
  await expect(cardOf(page)).toBeVisible();

  await test.step("what happens without the network arrives once and in order", () =>
    workOffline({ corridor, page, teacher }, network));

  await test.step("the newest tab has the class, and the other one can take it back", async () => {
    const elsewhere = "You are in the class in another tab";
    await openMenu(page);
    const copy = await duplicate(page.context(), page);
    await expect(classButton(copy)).toBeVisible();
    await expect(messages).toContainText(elsewhere);
    await messages.getByRole("button", { name: "Continue here" }).click();
    await expect(messages).not.toContainText(elsewhere);
    await openMenu(page);
    await expect(new CorridorPage(copy).messages).toContainText(elsewhere);
    await copy.close();
    await page.keyboard.press("Escape");
  });

  await test.step("the end of the class leaves the work", async () => {
    await corridor.run.click();
    await expect(corridor.pause).toBeVisible();
    await teacher.direct("DELETE");
    await expect(messages).toContainText("The lesson is over.");
    await expectOut(corridor);
  });

  await test.step("a student leaves only after an answer", async () => {
    const other = await ClassTeacher.start(relay, NAMES, lesson);
    await enterClass(page, other.code, network.origin);
    await openMenu(page);
    await item(page, "Leave the class").click();
    await expect(item(page, "Stay")).toBeFocused();
    await item(page, "Stay").click();
    await item(page, "Leave the class").click();
    await item(page, "Leave the class").click();
    await expect(classButton(page)).toBeHidden();
    await corridor.reload();
    await expect(classButton(page)).toBeHidden();
  });
  // The page would log that its connection fails.
  await page.close();
  await network.close();
});

async function workOffline(
  { corridor, page, teacher }: Student,
  network: FaultProxy,
): Promise<void> {
  const { messages, run } = corridor;
  const card = cardOf(page);
  // What the lesson needs has loaded once a run has failed.
  await corridor.speed.selectOption("max");
  await run.click();
  await expect(page.getByRole("heading", { name: "Bump" })).toBeVisible();
  const before = [{ kind: "opened", task: 1 }, { kind: "run" }];
  await expect.poll(async () => teacher.progress()).toMatchObject(before);
  await openMenu(page);
  Object.assign(network, { isUp: false });
  network.cut();
  const lost = "The connection to the class is lost. Keep working.";
  await expect(messages).toContainText(lost);
  await expect(menuOf(page).getByText(lost)).toBeVisible();
  await page.keyboard.press("Escape");
  await card.getByRole("button", { name: "Show a hint" }).click();
  await card.getByRole("button", { name: "Show hint 2 of 2" }).click();
  const bump = page.getByRole("heading", { name: "Bump" });
  await corridor.reset.click();
  await expect(bump).toBeHidden();
  await run.click();
  await expect(bump).toBeVisible();
  await card
    .getByRole("navigation", { name: "Tasks of this lesson" })
    .getByRole("button", { name: /^2 / })
    .click();
  network.clearFaults();
  await expect(messages).not.toContainText(lost, { timeout: 60_000 });
  await expect
    .poll(async () => teacher.progress(), { timeout: 60_000 })
    .toMatchObject([
      ...before,
      { kind: "hint", task: 1, hint: 1 },
      { kind: "hint", task: 1, hint: 2 },
      { kind: "run", task: 1 },
      { kind: "opened", task: 2 },
    ]);
  await openMenu(page);
  await item(page, "I need help").click();
  await expect.poll(async () => (await teacher.read()).students[0]?.helpSince).not.toBeNull();
  await item(page, "I do not need help now").click();
  await page.keyboard.press("Escape");
  await corridor.speed.selectOption("1×");
}

/** Expects that the page has left the class, and that the run continues, also after a reload. */
async function expectOut(corridor: CorridorPage): Promise<void> {
  await expect(classButton(corridor.page)).toBeHidden();
  await expect(corridor.messages).toContainText("Your work stays on this device.");
  // The run continues, or has ended by now.
  await expect(corridor.clock).not.toHaveText(/0:00\.0$/);
  await corridor.reload();
  await expect(classButton(corridor.page)).toBeHidden();
}

test("the class menu fits phones, also in a right-to-left language", async ({
  openWindow,
  relay,
}) => {
  const teacher = await ClassTeacher.start(relay, LONG_NAMES);
  const { page } = await openWindow(phone);
  await openAsStudent(page, teacher.code, relay);
  await expectMenuFits(page, "English");
  await page.keyboard.press("Escape");
  await page.setViewportSize(smallestPhone.viewport);
  await chooseLanguage(page, Texts.load("en"), "ar");
  await expectMenuFits(page, "Arabic");
});

async function expectMenuFits(page: Page, language: string): Promise<void> {
  const button = page.getByRole("button", { name: /name of 24/ });
  await expect(button).toBeVisible();
  expect(await horizontalOverflow(page), language).toEqual([]);
  expect(await smallTouchTargets(page), language).toEqual([]);
  await button.click();
  await expect(page.locator("dialog:popover-open details")).toBeVisible();
  expect(await horizontalOverflow(page), language).toEqual([]);
  expect(await smallTouchTargets(page), language).toEqual([]);
}
