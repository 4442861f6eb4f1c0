/** The dashboard of a teacher: starting a class, what it shows of students, and what it sends. */
import { encodeLink } from "@corridor/link";
import type { Locator, Page } from "playwright/test";
import { sampleLesson } from "../apps/web/src/model/lessons/testing/sample-lesson.ts";
import { expect, test } from "./fixtures.ts";
import { DashboardPage } from "./pages/dashboard-page.ts";
import { expectNoAxeViolations } from "./support/axe.ts";
import type { ClassTeacher } from "./support/class-teacher.ts";
import { horizontalOverflow, smallTouchTargets } from "./support/layout.ts";
import { phone } from "./support/phone.ts";
import { cardOf, claim, opened, openDashboard, solution, wrong } from "./support/one-line-class.ts";
import { ScriptedStudent } from "./support/scripted-student.ts";
import { wideWindow } from "./support/window-sizes.ts";
import { withMotion } from "./support/with-motion.ts";

test.use({ ...withMotion, ...wideWindow });

function cards(page: Page): Locator {
  return page.getByRole("list").getByRole("button", { name: /attempt/ });
}

async function choose(page: Page, menu: string, item: string | RegExp): Promise<void> {
  await page.getByRole("button", { name: menu }).click();
  await page.getByRole("dialog").getByRole("button", { name: item }).click();
}

test("a teacher starts a class, a student joins with its letters, and receives another lesson", async ({
  page,
  relay,
}) => {
  const own = encodeLink({ lesson: { ...sampleLesson, name: "My own" } });
  if (!own.ok) throw new Error(own.code);
  await page.goto(`/teach#${own.text}`);
  await expect(page.getByRole("heading", { name: "My own" })).toBeVisible();
  // The list of lessons, without a load of the page.
  await page.goto("/teach#");
  await page.getByRole("button", { name: "Start a class" }).click();
  const dialog = page.getByRole("dialog", { name: "Start a class" });
  const warning = dialog.getByText("You have not solved this lesson yet.");
  await expect(warning).toBeVisible();
  await expectNoAxeViolations(page, "start a class with an unsolved lesson");
  // The study of Corridor itself has solutions.
  await dialog.getByRole("combobox", { name: "Lesson" }).selectOption("study");
  await expect(warning).toHaveCount(0);
  await dialog.getByLabel("What you call this class").fill("8B Robotics");
  await dialog.getByRole("textbox", { name: "Number of students" }).fill("1");
  await dialog.getByRole("button", { name: "Start class" }).click();
  const dashboard = new DashboardPage(page);
  await expect(dashboard.code).toContainText("No student has joined yet.");
  // The key is not visible, and a reload still has it.
  expect(new URL(page.url()).hash).toBe("");
  await page.reload();
  await expect(page.getByRole("button", { name: "8B Robotics" })).toBeVisible();
  await expect(page.getByRole("heading", { name: "The 2013 study" })).toBeVisible();
  const student = await ScriptedStudent.join(relay, await dashboard.letters());
  await expect(cards(page)).toHaveCount(1);
  await expect(page.getByText("1 of 1 joined: locked.")).toBeVisible();
  student.show({});
  student.askForHelp();
  await expect(cards(page)).toHaveAccessibleName(/Asked for help, Task 1/);
  // A closed tab loses no lesson.
  await page.goto("/teach");
  await page.getByRole("link", { name: "Open", exact: true }).click();
  await expect(cards(page)).toHaveCount(1);
  expect(new URL(page.url()).hash).toBe("");

  await page.getByRole("button", { name: "Send a lesson" }).click();
  const send = page.getByRole("dialog", { name: "Send a lesson" });
  await send.getByRole("combobox").selectOption("My own");
  await send.getByRole("button", { name: "Send", exact: true }).click();
  await expect(send.getByText("The lesson is sent.")).toBeVisible();
  await expect(send.getByText(/^The last lesson has a report on this device/)).toBeVisible();
  expect(student.has("lesson")).toBe(true);
  await send.getByRole("button", { name: "Close" }).click();
  await expect(page.getByRole("heading", { name: "My own" })).toBeVisible();
  await page.getByRole("combobox", { name: "Open tasks" }).selectOption("Tasks open to 2");
  await expect.poll(() => student.received.at(-1)).toEqual({ type: "pace", to: 2 });
  student.close();
  await page.goto("/teach#report");
  const saved = page.getByRole("link", { name: "Open the report “8B Robotics, The 2013 study”" });
  await expect(saved).toBeVisible();
});

/** A big screen of fewer pixels: the robots of a race move all the time. */
const smallScreen = { viewport: { width: 960, height: 540 } };

/** A class with its dashboard and its big screen. */
interface OpenClass {
  teacher: ClassTeacher;
  page: Page;
  screen: Page;
}

test("a teacher sees who has solved, who works and who needs help, and directs the class and the big screen, which shows no name", async ({
  page,
  relay,
  openWindow,
}) => {
  // Two pages take part in all of it.
  test.slow();
  const teacher = await openDashboard(page, relay);
  const join = async (): Promise<ScriptedStudent> => ScriptedStudent.join(relay, teacher.code);
  const { page: screen } = await openWindow(smallScreen);
  const open: OpenClass = { teacher, page, screen };
  await screen.goto(`${relay}/class/${teacher.created.id}#${teacher.created.screenKey}`);
  await expect(screen.getByText(lettersOf(teacher))).toBeVisible();
  expect(new URL(screen.url()).hash).toBe("");

  const [honest, cheat] = [await join(), await join()];
  await test.step("a solution counts after the teacher's page has run it", async () => {
    for (const student of [honest, cheat]) student.report(opened);
    honest.report(claim(solution));
    cheat.show({ state: "solved" });
    cheat.report(claim(wrong.attempt));
    await expect(cardOf(page, honest)).toHaveAccessibleName(/, Solved, 0 minutes, 1 line,/);
    await expect(cardOf(page, cheat)).toHaveAccessibleName(/, Reported solved, does not pass,/);
    await expect(page.getByRole("region", { name: "Results" })).toContainText("1 of 2 students");
    await expect(screen.getByText("1 of 2 solved")).toBeVisible();
    await expect(screen.getByText("Where robots bump")).toBeVisible();
  });

  await test.step("verified programs race in one maze, on the dashboard and the big screen", async () => {
    await expect(screen.getByRole("button", { name: /^Race/ })).toHaveCount(0);
    cheat.report(claim(solution));
    await raceOnBoth(open);
  });

  const [driver, stuck, shy] = [await join(), await join(), await join()];
  await test.step("a student who drives, and the newest program", async () => {
    for (const student of [driver, stuck, shy]) student.report(opened);
    await expect(cards(page)).toHaveCount(5);
    if (!("rules" in solution)) throw new Error("not a program");
    const link = encodeLink({ program: solution });
    driver.write(link.ok ? link.text : "");
    driver.show({ state: "driving", line: 0, pose: [350, 150, 90], path: "e1" });
    await expect(cardOf(page, driver)).toHaveAccessibleName(/, Driving, \d+ minutes?, 1 line,/);
  });

  await test.step("a run on the big screen, without the student's name", () =>
    showRun(open, driver));
  await test.step("who needs help comes first, but no card moves under the focus", () =>
    sortByNeed(open, { driver, stuck, shy }));
  await test.step("a pause, the lock and new letters reach the students", () =>
    direct(open, driver));
  await test.step("a hint, a return code and a removal reach one student", () =>
    directOne(open, driver));

  await teacher.direct("DELETE");
  await expect(screen.getByText("The lesson is over")).toBeVisible();
  for (const student of [honest, cheat, driver, stuck, shy]) student.close();
});

function lettersOf({ code }: ClassTeacher): string {
  return `${code.slice(0, 3)} ${code.slice(3)}`;
}

/** Two equal programs of two students race. */
async function raceOnBoth({ page, screen }: OpenClass): Promise<void> {
  for (const place of [page, screen]) {
    await place.getByRole("button", { name: "Race: 2 robots, one maze" }).click();
    await expect(place.getByText("2 of 2 at the goal")).toBeVisible();
    await expect(place.getByText(/^Robot 1: \d+\.\d s, 1 line, 2 students$/)).toBeVisible();
    await expect(place.getByRole("button", { name: "Again" })).toBeVisible();
    await expectNoAxeViolations(place, "race");
  }
  await expect(screen.getByText(/Team \d/)).toHaveCount(0);
  await screen.getByRole("button", { name: "Again" }).click();
  await expect(screen.getByText("2 of 2 at the goal")).toBeVisible();
  await screen.getByRole("button", { name: "Close race" }).click();
  await expect(screen.getByText("Where robots bump")).toBeVisible();
  await page.keyboard.press("Escape");
  await expect(page.getByRole("dialog")).toHaveCount(0);
}

/** Shows the run of a student on the big screen. */
async function showRun(
  { teacher, page, screen }: OpenClass,
  driver: ScriptedStudent,
): Promise<void> {
  await screen.setViewportSize({ width: 1920, height: 1080 });
  await cardOf(page, driver).click();
  await page.getByRole("button", { name: "Show on big screen" }).click();
  await expect(screen.getByText("A run", { exact: true })).toBeVisible();
  await expect(screen.getByText(/Team \d/)).toHaveCount(0);
  await screen.reload();
  await expect(screen.getByText("A run", { exact: true })).toBeVisible();
  await expectNoAxeViolations(screen, "big screen");
  const small = await screen.evaluate(() => {
    const texts = [...document.querySelectorAll("main p, main h1, main figcaption")];
    return texts.filter((each) => Number.parseFloat(getComputedStyle(each).fontSize) < 28).length;
  });
  expect(small).toBe(0);
  // A screen of another version than the dashboard says what to do.
  const old = await screen.context().newPage();
  await old.routeWebSocket(/\/socket$/, (client) => {
    const server = client.connectToServer();
    server.onMessage((message) => client.send(String(message).replace('"racers"', '"robots"')));
  });
  await old.goto(`/class/${teacher.created.id}#${teacher.created.screenKey}`);
  await expect(old.getByRole("alert")).toHaveText(/^This page cannot show the results\. Reload/);
  await expect(old.getByText(lettersOf(teacher))).toBeVisible();
  await old.close();
  await page.keyboard.press("Escape");
  await expect(cardOf(page, driver)).toBeFocused();
  // No card moves under the focus.
  await page.getByRole("heading", { name: "One line" }).click();
}

/** A student who has bumped often, and one who asks for help. */
async function sortByNeed(
  { page }: OpenClass,
  { driver, stuck, shy }: Record<"driver" | "stuck" | "shy", ScriptedStudent>,
): Promise<void> {
  for (let attempt = 0; attempt < 4; attempt++) stuck.bump(0);
  await expect(cardOf(page, stuck)).toHaveAccessibleName(/, Stuck, \d+ minutes?, 4 attempts$/);
  await expect(cards(page).first()).toHaveAccessibleName(/Stuck/);
  await cardOf(page, driver).focus();
  shy.askForHelp();
  await expect(page.getByText("2 need help now.")).toBeVisible();
  await expect(cards(page).first()).toHaveAccessibleName(/Stuck/);
  await page.getByRole("button", { name: "Sort" }).click();
  await expect(cards(page).first()).toHaveAccessibleName(/Asked for help/);
  // N moves to the next student who needs help.
  await page.getByRole("heading", { name: "One line" }).click();
  await page.keyboard.press("n");
  await expect(cardOf(page, shy)).toBeFocused();
  await page.keyboard.press("n");
  await expect(cardOf(page, stuck)).toBeFocused();
  await page.getByRole("radio", { name: "Needs help 2" }).check({ force: true });
  await expect(cards(page)).toHaveCount(2);
  await expectNoAxeViolations(page, "dashboard");
  // Also to one whom the filter hides.
  await page.getByRole("radio", { name: /^Solved/ }).check({ force: true });
  await expect(cards(page)).toHaveCount(2);
  await page.getByRole("heading", { name: "One line" }).click();
  await page.keyboard.press("n");
  await expect(cardOf(page, shy)).toBeFocused();
  await expect(cards(page)).toHaveCount(5);
}

/** Pauses and locks the class, and gives it new letters. */
async function direct({ teacher, page }: OpenClass, driver: ScriptedStudent): Promise<void> {
  await page.getByRole("button", { name: "Pause everyone" }).click();
  const minutesLeft = (): number | null => {
    const newest = driver.received.at(-1);
    return newest?.type === "pause" ? Math.ceil((newest.endsInMs ?? 0) / 60_000) : null;
  };
  await expect.poll(minutesLeft).toBe(5);
  await choose(page, "How long to pause", "10 minutes");
  await expect.poll(minutesLeft).toBe(10);
  await page.getByRole("button", { name: "End the pause" }).click();
  await expect.poll(() => driver.received.at(-1)).toEqual({ type: "pause", endsInMs: null });
  await choose(page, "Who can join", "Lock the class");
  await expect(page.getByText("locked", { exact: true })).toBeVisible();
  expect((await teacher.read()).settings.locked).toBe(true);
  await choose(page, "Who can join", /^New letters/);
  await expect.poll(async () => (await teacher.read()).settings.code).not.toBe(teacher.code);
}

/** Watches a student, helps, and removes the student. */
async function directOne({ page }: OpenClass, driver: ScriptedStudent): Promise<void> {
  await cardOf(page, driver).click();
  const sheet = page.getByRole("complementary");
  await expect.poll(() => driver.has("watched")).toBe(true);
  const program = page.getByRole("list", { name: "Program" });
  await expect(program.getByRole("listitem").first()).toContainText("if front < 50");
  await sheet.getByRole("textbox", { name: /^Your note on Team/ }).fill("sits at the window");
  // The teacher reads the hint before the student does.
  await expect(sheet.getByText("Hint 1 Look at front.")).toBeVisible();
  await sheet.getByRole("button", { name: "Show hint 1" }).click();
  await expect.poll(() => driver.received.at(-1)).toEqual({ type: "hint", task: 1, hint: 1 });
  await sheet.getByRole("button", { name: "Return code" }).click();
  await expect(sheet.getByText(/^[B-Z]{3} [B-Z]{3}$/)).toBeVisible();
  await expectNoAxeViolations(page, "watched student");
  await page.keyboard.press("Escape");
  await expect(cardOf(page, driver)).toBeFocused();
  await cardOf(page, driver).click();
  await expect(sheet.getByRole("textbox")).toHaveValue("sits at the window");
  await sheet.getByRole("button", { name: "Remove" }).click();
  await sheet.getByRole("button", { name: "Remove" }).last().click();
  await expect(cardOf(page, driver)).toHaveCount(0);
  await expect(cards(page)).toHaveCount(4);
}

test("the dashboard fits a phone", async ({ openWindow, relay }) => {
  const { page } = await openWindow(phone);
  const teacher = await openDashboard(page, relay);
  const student = await ScriptedStudent.join(relay, teacher.code);
  await expect(cards(page)).toHaveCount(1);
  expect(await horizontalOverflow(page)).toEqual([]);
  expect(await smallTouchTargets(page)).toEqual([]);
  await expect(page.getByRole("button", { name: "Pause everyone" })).toBeVisible();
  // On a phone the way to the end of the cards is long.
  await expect(page.getByRole("main").getByRole("button", { name: "End lesson" })).toHaveCount(0);
  await choose(page, "More", "End lesson");
  await expect(page.getByRole("dialog", { name: "End the lesson?" })).toBeVisible();
  student.close();
});
