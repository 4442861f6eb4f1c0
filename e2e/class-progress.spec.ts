/** The work of a student on the lesson of a class, as the teacher receives it. */
import { lessonMark, type LessonTask } from "@corridor/challenge";
import { lessonOfTasks } from "@corridor/challenge/testing";
import { decodeLink } from "@corridor/link";
import { studentProgramSchema, type DriverName } from "@corridor/protocol";
import type { Locator, Page } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import type { CorridorPage } from "./pages/corridor-page.ts";
import { expectNoAxeViolations } from "./support/axe.ts";
import { ClassTeacher, type Dashboard } from "./support/class-teacher.ts";
import { classButton, enterClass } from "./support/enter-class.ts";
import { horizontalOverflow } from "./support/layout.ts";
import { lessonTask, straight } from "./support/lesson-task.ts";
import { phone, tab } from "./support/phone.ts";
import { smallWindow } from "./support/window-sizes.ts";
import { centreOf, TouchInput } from "./support/touch-input.ts";
import { waitForAnimations } from "./support/wait-for-animations.ts";

test.use(smallWindow);

const NAMES = ["Team 1", "Team 2"];

const corner: LessonTask["mazes"][number] = {
  ...straight,
  name: "Corner",
  blocks: ["#####", "#...#", "###.#", "#####"],
  goals: [{ column: 3, row: 2 }],
};

function taskOf(name: string, change: Partial<LessonTask> = {}): LessonTask {
  return lessonTask(name, ["Look ahead.", "Drive on."], change);
}

const tasks = [taskOf("Straight on"), taskOf("Corner", { mazes: [corner, straight] })];
const lesson = lessonOfTasks("Two mazes", tasks, {
  survey: [
    { id: "navigation", question: "Did it help you to find the way?" },
    { id: "robots", question: "Did it help you to understand robots?" },
  ],
});

function cardOf(page: Page): Locator {
  return page.getByRole("region", { name: "Lesson", exact: true });
}

function taskButton(page: Page, number: number): Locator {
  const tasks = cardOf(page).getByRole("navigation", { name: "Tasks of this lesson" });
  return tasks.getByRole("button", { name: new RegExp(`^${number} `) });
}

async function expectTask(page: Page, number: number): Promise<void> {
  await expect(taskButton(page, number)).toHaveAttribute("aria-current", "step");
}

/** Runs the program at full speed. */
async function drive({ speed, run }: CorridorPage): Promise<void> {
  await speed.selectOption("max");
  await run.click();
}

/** Solves the open task: straight on, then to the right. */
async function solve(corridor: CorridorPage, page: Page): Promise<void> {
  await corridor.program.otherwise.selectOption("forward");
  await drive(corridor);
  await expect(cardOf(page).getByRole("note")).toContainText("solved");
}

/** A student, and the dashboard of the teacher who watches. */
interface WatchedStudent {
  corridor: CorridorPage;
  page: Page;
  teacher: ClassTeacher;
  dashboard: Dashboard;
}

const byHand = taskOf("By hand", { allowed: { ...taskOf("").allowed, drivers: ["me"] } });
const three = { ...lesson, tasks: [...tasks, byHand] };

test("the lesson opens when a student joins, and the teacher receives each step, each run and the answers to the questions", async ({
  page,
  relay,
}) => {
  const teacher = await ClassTeacher.start(relay, NAMES, three);
  const dashboard = await teacher.connect();
  dashboard.send({ type: "watch", student: 1 });
  const corridor = await enterClass(page, teacher.code);
  await expectTask(page, 1);
  await expect(cardOf(page)).toContainText("Two mazes");
  await expect
    .poll(() => dashboard.tile)
    .toMatchObject({ task: 1, maze: "g1", state: "writing", path: "", passes: null });

  const student: WatchedStudent = { corridor, page, teacher, dashboard };
  await test.step("a hint, and the newest program, without its name", () => startTask(student));
  await test.step("a run that bumps, and one that solves the task", () => bumpAndSolve(student));
  await test.step("the next task, once also after a reload, and a check", () => openNext(student));
  await test.step("a drive by hand, and its solution", () => driveByHand(student));
  await test.step("nothing of other work", () => openOwnWork(student));
  dashboard.close();
  await test.step("a student answers or skips the questions after the last task", () =>
    answerQuestions(corridor, relay));
});

async function startTask({ corridor, page, teacher }: WatchedStudent): Promise<void> {
  await cardOf(page).getByRole("button", { name: "Show a hint" }).click();
  await corridor.program.addLine("right >", "60", "delayed right 90");
  const programs = async () => (await teacher.read()).students[0]?.programs ?? 0;
  await expect
    .poll(async () => {
      if ((await programs()) === 0) return null;
      const { link } = studentProgramSchema.parse(await teacher.get("/students/1/program"));
      const decoded = decodeLink(link);
      return decoded.ok ? decoded.value.program : null;
    })
    .toMatchObject({
      name: "",
      rules: [{ when: { sensor: "right", is: ">", than: 60 }, do: "delayed right 90" }],
    });
  await corridor.program.deleteAllLines();
}

async function bumpAndSolve({ corridor, page, teacher, dashboard }: WatchedStudent): Promise<void> {
  await corridor.program.otherwise.selectOption("turn 180");
  await corridor.program.otherwise.selectOption("reverse");
  await drive(corridor);
  await expect.poll(() => dashboard.tile).toMatchObject({ state: "bumped", bumps: 1 });
  await expect
    .poll(async () => teacher.progress())
    .toEqual([
      { kind: "opened", lesson: lessonMark(three), task: 1 },
      { kind: "hint", task: 1, hint: 1 },
      {
        kind: "run",
        task: 1,
        changed: true,
        bumps: 1,
        bumpPlaces: [{ maze: "g1", column: expect.any(Number), row: expect.any(Number) }],
        mistakes: expect.any(Number),
        failure: { code: "bump", line: "default" },
      },
    ]);
  await corridor.reset.click();
  await corridor.speed.selectOption("1×");
  await corridor.program.otherwise.selectOption("forward");
  await corridor.run.click();
  await expect.poll(() => dashboard.tiles.map(({ state }) => state)).toContain("driving");
  await expect.poll(() => dashboard.tile).toMatchObject({ state: "solved", path: "e4", bumps: 0 });
  expect(dashboard.tiles.some(({ line }) => line === "default")).toBe(true);
  await expect(cardOf(page).getByRole("note")).toContainText("solved");
}

async function openNext({ corridor, page, teacher, dashboard }: WatchedStudent): Promise<void> {
  await corridor.reload();
  await expectTask(page, 1);
  await taskButton(page, 2).click();
  await expect
    .poll(async () => (await teacher.progress()).slice(3))
    .toEqual([
      { kind: "run", task: 1, changed: true, bumps: 0, mistakes: 0, failure: null },
      { kind: "solved", task: 1, lines: 0, code: expect.any(String) },
      { kind: "opened", lesson: lessonMark(three), task: 2 },
    ]);
  const solved = (await teacher.progress()).find(({ kind }) => kind === "solved");
  const code = decodeLink((solved?.kind === "solved" ? solved.code : null) ?? "");
  expect(code).toMatchObject({
    ok: true,
    value: { completion: { lesson: lessonMark(three), task: 0 } },
  });
  await expect.poll(() => dashboard.tile).toMatchObject({ task: 2, maze: "g1", state: "writing" });
  await corridor.program.otherwise.selectOption("forward");
  await cardOf(page).getByRole("button", { name: "Check in both mazes" }).click();
  await expect.poll(() => dashboard.tile?.passes).toBe(1);
  await expect
    .poll(async () => (await teacher.progress()).at(-1))
    .toMatchObject({ kind: "check", task: 2, changed: true, passes: 1, mazes: 2 });
}

async function driveByHand({ page, teacher, dashboard }: WatchedStudent): Promise<void> {
  await taskButton(page, 3).click();
  await expectTask(page, 3);
  await page.keyboard.down("w");
  await expect.poll(() => dashboard.tile).toMatchObject({ state: "solved", line: null });
  await page.keyboard.up("w");
  await expect
    .poll(async () => (await teacher.progress()).slice(-3))
    .toEqual([
      { kind: "opened", lesson: lessonMark(three), task: 3 },
      { kind: "run", task: 3, changed: true, bumps: 0, mistakes: 0, failure: null },
      { kind: "solved", task: 3, lines: null, code: expect.any(String) },
    ]);
  const { link } = studentProgramSchema.parse(await teacher.get("/students/1/program"));
  const read = decodeLink(link);
  expect(read).toMatchObject({ ok: true, value: { completion: { task: 2 } } });
}

async function openOwnWork({ corridor, page, dashboard }: WatchedStudent): Promise<void> {
  await cardOf(page).getByRole("button", { name: "Back to my maze" }).click();
  await expect.poll(() => dashboard.tile).toMatchObject({ maze: null, tick: 0, path: "" });
  await corridor.run.click();
  await expect(corridor.clock).not.toHaveText(/0:00\.0$/);
  expect(dashboard.tile).toMatchObject({ maze: null, tick: 0, path: "" });
}

async function answerQuestions(corridor: CorridorPage, relay: string): Promise<void> {
  const { page } = corridor;
  const [first] = lesson.tasks;
  const single = { ...lesson, tasks: first === undefined ? [] : [first] };
  const teacher = await ClassTeacher.start(relay, NAMES, single);
  await enterClass(page, teacher.code);
  const card = page.getByRole("region", { name: "Mission", exact: true });
  await expect(card).toContainText("Two mazes");
  await corridor.program.otherwise.selectOption("forward");
  await drive(corridor);
  await expect(corridor.messages).toContainText("You solved all tasks.");
  // The relay has the solution, so that the student copies no code.
  await expect(page.getByText("Task solved.", { exact: false }).first()).toBeVisible();
  await expect(page.getByText("Completion code")).toHaveCount(0);
  await corridor.messages.getByRole("button", { name: "Answer" }).click();
  const dialog = corridor.dialog("Questions about the lesson");
  const question = dialog.getByRole("group", { name: "Did it help you to find the way?" });
  await expect(question.getByRole("radio", { name: "Skip" })).toBeChecked();
  await expectNoAxeViolations(page, "questions");
  await page.setViewportSize({ width: 320, height: 640 });
  await waitForAnimations(page);
  expect(await horizontalOverflow(page)).toEqual([]);
  await page.setViewportSize(smallWindow.viewport);
  await question.getByRole("radio", { name: "4" }).check();
  await dialog.getByRole("button", { name: "Send answers" }).click();
  await expect(dialog).toBeHidden();
  await expect(corridor.messages).toContainText("Your answers are saved.");
  await expect
    .poll(async () => (await teacher.progress()).at(-1))
    .toEqual({
      kind: "survey",
      answers: [
        { id: "navigation", answer: 4 },
        { id: "robots", answer: null },
      ],
    });
  await classButton(page).click();
  const menu = page.getByRole("dialog", { name: "Class" });
  await expect(menu.getByRole("button", { name: "I need help" })).toBeVisible();
  await expect(menu.getByRole("button", { name: "Questions about the lesson" })).toBeHidden();
}

test("the teacher opens tasks in turn, sends lessons and hints, and ends the class", async ({
  page,
  relay,
}) => {
  const teacher = await ClassTeacher.start(relay, NAMES, lesson);
  await teacher.direct("PUT", "/pace", { to: 1 });
  const corridor = await enterClass(page, teacher.code);
  await expectTask(page, 1);

  await test.step("the tasks open one after the other", async () => {
    await expect(taskButton(page, 2)).toHaveAttribute("aria-disabled", "true");
    // Playwright waits for an element without aria-disabled.
    await taskButton(page, 2).dispatchEvent("click");
    await expect(cardOf(page)).toContainText("Your teacher will open task 2 later.");
    await solve(corridor, page);
    await expect(page.getByRole("button", { name: "Next task" })).toBeHidden();
    await expectTask(page, 1);
    await teacher.direct("DELETE", "/pace");
    await expect(corridor.messages).toContainText("You can open task 2 now.");
    await taskButton(page, 2).click();
    await expectTask(page, 2);
  });

  await test.step("a lesson that the teacher sends opens beside unsaved work", async () => {
    await corridor.program.addLine("front <", "50", "turn 180");
    await teacher.direct("PUT", "/lesson", { ...lesson, name: "Long way round" });
    await expect(corridor.messages).toContainText(
      "Your teacher sent: Long way round. It opens in 10 s. Your own work stays as it is.",
    );
    await expect(corridor.program.number(1)).toHaveValue("50");
    await corridor.messages.getByRole("button", { name: "Open", exact: true }).click();
    await expect(cardOf(page)).toContainText("Long way round");
    await expect(corridor.program.lines).toHaveCount(0);
    await corridor.program.addLine("right >", "70", "right 90");
    // By itself, and not while the class is paused.
    await teacher.direct("PUT", "/lesson", { ...lesson, name: "Third lesson" });
    await expect(corridor.messages).toContainText("Your teacher sent: Third lesson.");
    await expectNoAxeViolations(page, "lesson sent");
    await expect(cardOf(page)).toContainText("Third lesson", { timeout: 60_000 });
  });

  await test.step("hints of the teacher stay after a reload, as the student's own do", async () => {
    const dashboard = await teacher.connect();
    await cardOf(page).getByRole("button", { name: "Show a hint" }).click();
    dashboard.send({ type: "hint", student: 1, task: 1, hint: 2 });
    await expect(corridor.messages).toContainText("Your teacher shows you hint 2.");
    await expect(cardOf(page)).toContainText("Drive on.");
    await expect
      .poll(async () => (await teacher.progress()).at(-1))
      .toEqual({ kind: "hint", task: 1, hint: 2 });
    await corridor.reload();
    await expect(cardOf(page)).toContainText("Third lesson");
    await expect(cardOf(page)).toContainText("Look ahead.");
    await expect(cardOf(page)).toContainText("Drive on.");
    await expect(corridor.messages).not.toContainText("Your teacher sent");
    dashboard.send({ type: "hint", student: 1, task: 2, hint: 1 });
    await expect(corridor.messages).toContainText("Your teacher shows you hint 1 of task 2.");
    await corridor.messages.getByRole("button", { name: "Open task 2" }).click();
    await expectTask(page, 2);
    await expect(cardOf(page)).toContainText("Look ahead.");
    dashboard.close();
  });

  await test.step("the browser's Back leads to the work of each lesson", async () => {
    await page.goBack();
    await expectTask(page, 1);
    await page.goBack();
    await expect(cardOf(page)).toContainText("Long way round");
    await expect(corridor.program.number(1)).toHaveValue("70");
    await page.goBack();
    await expect(corridor.program.number(1)).toHaveValue("50");
  });

  await test.step("a class that ended while the page was closed says so", async () => {
    await page.goto("about:blank");
    await teacher.direct("DELETE");
    await corridor.open("/");
    await expect(corridor.messages).toContainText("The lesson is over.");
    await expect(classButton(page)).toBeHidden();
    const stored = await page.evaluate(() => Object.keys(sessionStorage));
    expect(stored.filter((key) => key.startsWith("corridor.class"))).toEqual([]);
  });
});

test("the hint of the teacher is in every tab of the phone, and the robot can be reset", async ({
  openWindow,
  relay,
}) => {
  const tasks = lesson.tasks.map((task) => ({
    ...task,
    allowed: { ...task.allowed, drivers: ["me", "program"] satisfies DriverName[] },
  }));
  const teacher = await ClassTeacher.start(relay, NAMES, { ...lesson, tasks });
  const dashboard = await teacher.connect();
  const corridor = await openWindow(phone);
  const { page } = corridor;
  await enterClass(page, teacher.code, relay);
  await expectTask(page, 1);
  await tab(page, "Drive").tap();
  dashboard.send({ type: "hint", student: 1, task: 1, hint: 2 });
  const hint = page.getByText("Hint 2 Drive on.");
  for (const name of ["Drive", "Presets", "Program"] as const) {
    await tab(page, name).tap();
    await expect(hint).toBeInViewport();
  }
  await tab(page, "Drive").tap();
  const touch = await TouchInput.of(page);
  // Waits until the key stays where it is, because the tab has just opened.
  await corridor.driveKey("forward").tap({ trial: true });
  await touch.down(await centreOf(corridor.driveKey("forward")));
  await expect.poll(async () => corridor.robotX()).toBeGreaterThan(160);
  await touch.lift();
  await corridor.waitForRobotToStop();
  await page.getByRole("button", { name: "Reset" }).tap();
  await expect.poll(async () => corridor.robotX()).toBeLessThan(160);
  // A hint that was read makes room, and stays in the card of the task.
  await page.getByRole("button", { name: "Close the hint" }).tap();
  await expect(hint).toBeHidden();
  await tab(page, "Program").tap();
  await expect(hint).toBeVisible();
  dashboard.close();
});
