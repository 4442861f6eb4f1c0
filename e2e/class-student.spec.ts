/** The page of a student in a class: connection, class menu, and how the class ends. */
import type { BrowserContext, Locator, Page } from "playwright/test";
import { SeededRandom } from "../apps/relay/src/testing/faults/seeded-random.ts";
import { FaultProxy } from "./faults/net/fault-proxy.ts";
import { expect, test } from "./fixtures.ts";
import { CorridorPage } from "./pages/corridor-page.ts";
import { expectNoAxeViolations } from "./support/axe.ts";
import { ClassTeacher } from "./support/class-teacher.ts";
import { classButton, enterClass } from "./support/enter-class.ts";
import { horizontalOverflow, smallTouchTargets } from "./support/layout.ts";
import { smallestPhone, phone } from "./support/phone.ts";
import { smallWindow, wideWindow } from "./support/window-sizes.ts";

test.use(smallWindow);

const NAMES = ["Team 1", "Team 2", "Team 3", "Team 4"];

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

/** The band of a pause. The live region has a longer text. */
function bandOf(page: Page): Locator {
  return page.getByText("Eyes to the front. Your teacher paused the class.", { exact: true });
}

/** A copy of the tab, as "Duplicate tab" makes it: with the same session storage. */
async function duplicate(context: BrowserContext, page: Page): Promise<Page> {
  const stored = await page.evaluate(() => sessionStorage.getItem("corridor.class"));
  const copy = await context.newPage();
  await copy.addInitScript((text) => sessionStorage.setItem("corridor.class", text ?? ""), stored);
  await copy.goto("/");
  return copy;
}

test("a request for help stays in the bar until the student or a hint of the teacher ends it", async ({
  page,
  relay,
}) => {
  await page.setViewportSize(wideWindow.viewport);
  const teacher = await ClassTeacher.start(relay, NAMES);
  await enterClass(page, teacher.code);
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
  const dashboard = await teacher.connect();
  dashboard.send({ type: "hint", student: 1, task: 1, hint: 1 });
  await expect(classButton(page)).toHaveAccessibleName(/, in class$/);
  await expect.poll(helpSince).toBeNull();
  dashboard.close();
});

test("a student gets another name twice, also after a reload", async ({ page, relay }) => {
  const teacher = await ClassTeacher.start(relay, NAMES);
  const corridor = await enterClass(page, teacher.code);
  await openMenu(page);
  for (const left of [1, 0]) {
    await item(page, /^Another name/).click();
    await expect(item(page, `Another name (${left} left)`)).toBeVisible();
  }
  await expect(item(page, /^Another name/)).toBeDisabled();
  const name = (await teacher.read()).students[0]?.name.text ?? "";
  const button = page.getByRole("button", { name: `${name}, in class` });
  await expect(button).toBeVisible();
  await corridor.reload();
  await expect(button).toBeVisible();
  await openMenu(page);
  await expect(item(page, "Another name (0 left)")).toBeDisabled();
  expect((await teacher.read()).students).toHaveLength(1);
});

test("an eye is in the bar while the teacher watches", async ({ page, relay }) => {
  const teacher = await ClassTeacher.start(relay, NAMES);
  await enterClass(page, teacher.code);
  const watched = page.getByRole("button", { name: "in class. Your teacher is watching you." });
  await expect(watched).toBeHidden();
  const end = await teacher.watch(1);
  await expect(watched).toBeVisible();
  end();
  await expect(watched).toBeHidden();
});

test("the newest tab has the class, and the other one can take it back", async ({
  page,
  context,
  relay,
}) => {
  const teacher = await ClassTeacher.start(relay, NAMES);
  const { messages } = await enterClass(page, teacher.code);
  await openMenu(page);
  const copy = await duplicate(context, page);
  await expect(classButton(copy)).toBeVisible();
  await expect(messages).toContainText("You are in the class in another tab");
  await messages.getByRole("button", { name: "Continue here" }).click();
  await expect(messages).not.toContainText("You are in the class in another tab");
  await openMenu(page);
  await expect(new CorridorPage(copy).messages).toContainText(
    "You are in the class in another tab",
  );
});

test("a removed student, and a class that ends, leave the work as it is", async ({
  page,
  openWindow,
  relay,
}) => {
  const teacher = await ClassTeacher.start(relay, NAMES);
  const first = await enterClass(page, teacher.code);
  const second = await enterClass((await openWindow()).page, teacher.code, relay);
  for (const { page: own, run, pause } of [first, second]) {
    // The lesson that opens ends a run that began before.
    await expect(own.getByRole("region", { name: "Lesson", exact: true })).toBeVisible();
    await run.click();
    await expect(pause).toBeVisible();
  }
  await teacher.direct("DELETE", "/students/1");
  await expect(first.messages).toContainText("You are no longer in this class.");
  await teacher.direct("DELETE");
  await expect(second.messages).toContainText("The lesson is over.");
  for (const corridor of [first, second]) {
    await expect(classButton(corridor.page)).toBeHidden();
    await expect(corridor.messages).toContainText("Your work stays on this device.");
    // The run continues, or has reached the goal by now.
    await expect(corridor.clock).not.toHaveText(/0:00\.0$/);
    await corridor.reload();
    await expect(classButton(corridor.page)).toBeHidden();
  }
});

test("a student leaves only after an answer, and keeps the work", async ({ page, relay }) => {
  const teacher = await ClassTeacher.start(relay, NAMES);
  const corridor = await enterClass(page, teacher.code);
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

test("a pause stops the robot and its keys until the teacher ends it, also after a reload", async ({
  page,
  relay,
}) => {
  const teacher = await ClassTeacher.start(relay, NAMES);
  const corridor = await enterClass(page, teacher.code);
  await expect(page.getByRole("region", { name: "Lesson", exact: true })).toBeVisible();
  const band = bandOf(page);
  const runButton = page.locator("button[data-does]");
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
  await expect(band).toBeVisible();
  await expect(runButton).not.toHaveAttribute("data-does", "pause");
  await openMenu(page);
  await teacher.direct("DELETE", "/pause");
  await expect(band).toBeHidden();
  await expect(corridor.messages).toContainText("You can continue.");
  await corridor.run.click();
  await expect(corridor.pause).toBeVisible();
});

test("a pause ends by the clock", async ({ page, relay }) => {
  const teacher = await ClassTeacher.start(relay, NAMES);
  const corridor = await enterClass(page, teacher.code);
  await expect(page.getByText("Task 1 of 3")).toBeVisible();
  await teacher.direct("PUT", "/pause", { seconds: 10 });
  const band = bandOf(page);
  await expect(band).toBeVisible();
  await expect(band).toBeHidden({ timeout: 60_000 });
  await corridor.run.click();
  await expect(corridor.pause).toBeVisible();
});

test("the page reconnects after the network was lost", async ({ browser, relay }) => {
  const teacher = await ClassTeacher.start(relay, NAMES);
  const target = Number(new URL(relay).port);
  const network = await FaultProxy.start({ target: () => target, random: new SeededRandom(1) });
  // Not an openWindow fixture: the browser logs an error for each failed connection.
  const context = await browser.newContext();
  const page = await context.newPage();
  const { messages, run, pause } = await enterClass(page, teacher.code, network.origin);
  // What the lesson needs has loaded once the robot drives.
  await expect(page.getByRole("region", { name: "Lesson", exact: true })).toBeVisible();
  await run.click();
  await pause.click();
  await openMenu(page);
  Object.assign(network, { isUp: false });
  network.cut();
  const lost = "The connection to the class is lost. Keep working.";
  await expect(messages).toContainText(lost);
  await expect(menuOf(page).getByText(lost)).toBeVisible();
  await page.keyboard.press("Escape");
  await run.click();
  await expect(pause).toBeVisible();
  network.clearFaults();
  await expect(messages).not.toContainText(lost, { timeout: 60_000 });
  await openMenu(page);
  await item(page, "I need help").click();
  await expect.poll(async () => (await teacher.read()).students[0]?.helpSince).not.toBeNull();
  await context.close();
  await network.close();
});

test("a long name fits every width of the bar", async ({ page, relay }) => {
  const teacher = await ClassTeacher.start(relay, ["A name of 24 characters."]);
  await enterClass(page, teacher.code);
  await openMenu(page);
  await item(page, "I need help").click();
  await page.keyboard.press("Escape");
  for (const width of [1440, 1200, 1024, 900, 768, 600]) {
    await page.setViewportSize({ width, height: 800 });
    await expect(classButton(page)).toBeVisible();
    await expect.poll(() => horizontalOverflow(page), `${width} px`).toEqual([]);
  }
});

test("the class menu fits phones, also in a right-to-left language", async ({
  openWindow,
  relay,
}) => {
  const teacher = await ClassTeacher.start(relay, ["A name of 24 characters.", "Team 2"]);
  for (const device of [
    { ...phone, locale: "en" },
    { ...smallestPhone, locale: "ar" },
  ]) {
    const { page } = await openWindow(device);
    await page.goto(`${relay}/join#${teacher.code}`);
    await page.locator("form button[type=submit]").click();
    await page.locator("main a[href='/']").click();
    const button = page.getByRole("button", { name: /A name of|Team 2/ });
    await expect(button).toBeVisible();
    expect(await horizontalOverflow(page), device.locale).toEqual([]);
    expect(await smallTouchTargets(page), device.locale).toEqual([]);
    await button.click();
    await expect(page.locator("dialog:popover-open details")).toBeVisible();
    expect(await horizontalOverflow(page), device.locale).toEqual([]);
    expect(await smallTouchTargets(page), device.locale).toEqual([]);
  }
});
