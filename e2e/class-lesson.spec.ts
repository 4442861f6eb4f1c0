/**
 * A lesson of a class from its start to its end, with the pages of a teacher and of eight students.
 */
import { mkdirSync } from "node:fs";
import type { LessonDocument } from "@corridor/challenge";
import { lessonOfTasks } from "@corridor/challenge/testing";
import { encodeLink } from "@corridor/link";
import { createdClassSchema, studentProgramSchema, type CreatedClass } from "@corridor/protocol";
import type { Locator, Page } from "playwright/test";
import { hashKey } from "../apps/relay/src/platform/keys.ts";
import { SeededRandom } from "../apps/relay/src/testing/faults/seeded-random.ts";
import { qrPath } from "../apps/web/src/ui/qr-path.ts";
import { RelayProcess } from "../tests/support/relay-process.ts";
import { FaultProxy } from "./faults/net/fault-proxy.ts";
import { expect, test as base } from "./fixtures.ts";
import { CorridorPage } from "./pages/corridor-page.ts";
import { DashboardPage } from "./pages/dashboard-page.ts";
import { textsInFiles } from "../tests/support/stored-files.ts";
import { ClassTeacher } from "./support/class-teacher.ts";
import { classButton, enterClass, joinByForm, scanCode } from "./support/enter-class.ts";
import { lessonTask } from "./support/lesson-task.ts";
import { smallWindow } from "./support/window-sizes.ts";

/** A relay whose files the test reads. */
interface Service {
  relay: RelayProcess;
  folder: string;
  /** the network of one student */
  network: FaultProxy;
}

const test = base.extend<{ service: Service }>({
  // oxlint-disable-next-line no-empty-pattern -- Playwright reads the fixture names from this pattern
  service: async ({}, use, testInfo) => {
    const folder = testInfo.outputPath("data");
    mkdirSync(folder, { recursive: true });
    const relay = await RelayProcess.start({ folder });
    const random = new SeededRandom(1);
    const network = await FaultProxy.start({ target: () => relay.port, random });
    await use({ relay, folder, network });
    await network.close();
    await relay.stop();
  },
});

/** Two more than join. */
const NAMES = Array.from({ length: 10 }, (_, n) => `Quagga ${n + 1}`);
/** In active ms, without an edit or a run. */
const STUCK_MS = 180_000;

function lessonOf(name: string): LessonDocument {
  const tasks = [lessonTask(`${name} 1`, ["Look ahead."]), lessonTask(`${name} 2`, [])];
  return lessonOfTasks(name, tasks, { intro: `The intro of ${name}.` });
}

const lesson = lessonOf("Zebra crossing");
const later = lessonOf("Okapi bend");

/** A student's page. */
class Student extends CorridorPage {
  readonly band: Locator;
  readonly lesson: Locator;

  constructor(page: Page) {
    super(page);
    this.lesson = page.getByRole("region", { name: "Lesson", exact: true });
    this.band = page.getByText("Eyes to the front. Your teacher paused the class.", {
      exact: true,
    });
  }

  /** Waits until the page is in the class. */
  async name(): Promise<string> {
    await expect(this.lesson).toBeVisible();
    const name = await classButton(this.page).getAttribute("aria-label");
    return (name ?? "").replace(", in class", "");
  }

  async key(): Promise<string> {
    const text = await this.page.evaluate(() => sessionStorage.getItem("corridor.class"));
    return (JSON.parse(text ?? "{}") as { key: string }).key;
  }

  /** Runs a program that does one action in every situation. */
  async runWith(action: string, speed = "16×"): Promise<void> {
    await this.program.otherwise.selectOption(action);
    await this.speed.selectOption(speed);
    await this.run.click();
  }
}

/** Stores a lesson on the device, as a teacher who opens its link. */
async function openLesson(page: Page, origin: string, document: LessonDocument): Promise<void> {
  const link = encodeLink({ lesson: document });
  if (!link.ok) throw new Error(link.code);
  await page.goto("about:blank");
  await page.goto(`${origin}/teach#${link.text}`);
  await expect(page).toHaveURL(/\/teach#lesson=\w+$/);
}

/** Starts a class from the lesson that is open in the editor. */
async function startClass(page: Page, origin: string): Promise<ClassTeacher> {
  await page.getByRole("button", { name: "Start class" }).click();
  const dialog = page.getByRole("dialog", { name: "Start a class" });
  await dialog.getByRole("textbox", { name: "Number of students" }).fill(`${NAMES.length}`);
  await dialog.getByRole("checkbox", { name: /^Use my own list of names/ }).check();
  await dialog.getByRole("textbox", { name: "Names, one on each line" }).fill(NAMES.join("\n"));
  const created = Promise.withResolvers<CreatedClass>();
  await page.route("**/api/v1/classes", async (route) => {
    const response = await route.fetch();
    created.resolve(createdClassSchema.parse(await response.json()));
    await route.fulfill({ response });
  });
  await dialog.getByRole("button", { name: "Start class" }).click();
  return ClassTeacher.of(origin, await created.promise);
}

/** Progress and programs of a student, as the relay stores them. */
async function storedOf(teacher: ClassTeacher, name: string) {
  const found = (await teacher.read()).students.find((each) => each.name.text === name);
  if (found === undefined) throw new Error(`${name} is not in the class`);
  return found;
}

/** Students who write and those who drive have one place. */
function asOrdered(state: string): string {
  return state === "Writing" || state === "Driving" ? "Working" : state;
}

test("a lesson with eight students, until no byte of it is left", async ({
  openWindow,
  pageErrors,
  service: { relay, folder, network },
}) => {
  pageErrors.ignoreFailedRequests();
  // Nine pages load. A busy machine needs five minutes.
  test.setTimeout(600_000);
  const origin = relay.url;
  const { page } = await openWindow();
  await page.clock.install();
  const dashboard = new DashboardPage(page);
  await openLesson(page, origin, later);
  await openLesson(page, origin, lesson);
  const teacher = await startClass(page, origin);
  const newStudent = async () => new Student((await openWindow(smallWindow)).page);
  const enter = async (at = origin): Promise<Student> => {
    const student = await newStudent();
    await enterClass(student.page, teacher.code, at);
    return student;
  };

  const idle = await newStudent();
  const idleName = await test.step("the first student types the letters", async () => {
    await expect(dashboard.code).toContainText("No student has joined yet.");
    await idle.page.goto(`${origin}/join`);
    await idle.page.getByRole("textbox").fill((await dashboard.letters()).toLowerCase());
    await joinByForm(idle.page);
    return idle.name();
  });
  // The page reports its empty program, too.
  await expect(dashboard.cardOf(idleName)).toHaveAccessibleName(/, Writing, .+, 0 lines,/);
  const idleSince = await page.evaluate(() => Date.now());

  const writer = await newStudent();
  await test.step("the second one scans the code", async () => {
    await dashboard.code.getByRole("button", { name: /^Show/ }).click();
    const shown = page.getByRole("dialog", { name: "Letters for the board" });
    const address = `${origin}/join#${teacher.code}`;
    await expect(shown.locator("svg path[d^=M4]")).toHaveAttribute(
      "d",
      qrPath(address)?.path ?? "",
    );
    await page.keyboard.press("Escape");
    await scanCode(writer.page, teacher.code, origin);
  });
  // One page after the other: six that load at once need longer than a step may take.
  const helper = await enter();
  const bumper = await enter();
  const driver = await enter();
  const solver = await enter();
  const wanderer = await enter(network.origin);
  const other = await enter();
  const all = [idle, writer, helper, bumper, driver, solver, wanderer, other];
  const names = await Promise.all(all.map((each) => each.name()));
  const nameOf = (student: Student): string => names[all.indexOf(student)] ?? "";
  await expect(dashboard.cards).toHaveCount(8);
  expect(new Set(names).size).toBe(8);

  await test.step("a student solves the first task, and opens the second", async () => {
    await wanderer.runWith("forward");
    await expect(wanderer.lesson.getByRole("note")).toContainText("solved");
    await wanderer.lesson.getByRole("button", { name: /^2 / }).click();
    await expect(dashboard.cardOf(nameOf(wanderer))).toHaveAccessibleName(/Writing, Task 2/);
  });

  await test.step("each state has its place, and who needs help comes first", async () => {
    Object.assign(network, { isUp: false });
    network.cut();
    await Promise.all([
      writer.program.addLine("right >", "60", "right 90"),
      helper.lesson.getByRole("button", { name: "I need help" }).click(),
      bumper.runWith("reverse"),
      driver.runWith("turn 180", "1×"),
      solver.runWith("forward"),
      // Only one student must be stuck, however long the step takes.
      other.program.otherwise.selectOption("reverse"),
    ]);
    await dashboard.expectState(nameOf(helper), "Asked for help");
    await dashboard.expectState(nameOf(bumper), "Bumped");
    await dashboard.expectState(nameOf(driver), "Driving");
    await dashboard.expectState(nameOf(solver), "Solved");
    // A state lasts 20 s at least.
    await page.clock.fastForward(20_000);
    await dashboard.expectState(nameOf(wanderer), "Disconnected");
    // A slow machine may be past that time. The clock cannot be set back.
    const soon = (await page.evaluate(() => Date.now())) + 5_000;
    await page.clock.pauseAt(Math.max(idleSince + STUCK_MS, soon));
    await dashboard.expectState(nameOf(idle), "Stuck");
    await expect
      .poll(async () => (await dashboard.states()).map(asOrdered))
      .toEqual([
        "Asked for help",
        "Stuck",
        "Bumped",
        "Working",
        "Working",
        "Working",
        "Disconnected",
        "Solved",
      ]);
    await expect(page.getByText("2 students have not joined yet")).toBeVisible();
    await page.clock.setSystemTime(Date.now());
    await page.clock.resume();
  });

  await test.step("what a student does without a network counts once", async () => {
    await wanderer.runWith("forward");
    await expect(wanderer.messages).toContainText("The connection to the class is lost.");
    network.clearFaults();
    await dashboard.expectState(nameOf(wanderer), "Solved");
    const kinds = async () =>
      (await storedOf(teacher, nameOf(wanderer))).progress.map(({ event }) => event.kind);
    await expect.poll(kinds).toEqual(["opened", "run", "solved", "opened", "run", "solved"]);
  });

  await test.step("a pause stops everyone, also after a reload", async () => {
    await dashboard.page.getByRole("button", { name: "Pause everyone" }).click();
    await Promise.all(all.map((each) => expect(each.band).toBeVisible()));
    await expect(driver.page.locator("button[data-does]")).not.toHaveAttribute(
      "data-does",
      "pause",
    );
    await driver.page.reload();
    await expect(driver.band).toBeVisible();
    await page.getByRole("button", { name: "End the pause" }).click();
    // This message disappears by itself.
    await expect(driver.messages).toContainText("You can continue.");
    await Promise.all(all.map((each) => expect(each.band).toBeHidden()));
  });

  await test.step("a killed relay loses nothing that it acknowledged", async () => {
    const before = await teacher.read();
    await relay.killAndRestart();
    const after = await teacher.read();
    // Pages may have reported more by now.
    for (const [at, { progress, programs, ...student }] of before.students.entries()) {
      const now = after.students[at];
      expect(now).toMatchObject(student);
      expect(now?.progress.slice(0, progress.length)).toEqual(progress);
      expect(now?.programs).toBeGreaterThanOrEqual(programs);
    }
    const { programs } = await storedOf(teacher, nameOf(helper));
    await helper.program.addLine("front <", "40", "turn 180");
    await other.runWith("forward");
    await dashboard.expectState(nameOf(other), "Solved");
    await expect
      .poll(async () => (await storedOf(teacher, nameOf(helper))).programs)
      .toBeGreaterThan(programs);
  });

  await test.step("a lesson opens beside work that no one has saved", async () => {
    await page.getByRole("button", { name: "Send a lesson" }).click();
    const dialog = page.getByRole("dialog", { name: "Send a lesson" });
    await dialog.getByRole("combobox").selectOption(later.name);
    await dialog.getByRole("button", { name: "Send", exact: true }).click();
    // Without the student, the lesson opens after 10 s.
    await expect(writer.messages).toContainText(`Your teacher sent: ${later.name}.`);
    await expect(writer.program.number(1)).toHaveValue("60");
    await writer.messages.getByRole("button", { name: "Open", exact: true }).click();
    await expect(dialog.getByText("The lesson is sent.")).toBeVisible();
    await dialog.getByRole("button", { name: "Close" }).click();
    await expect(writer.program.lines).toHaveCount(0);
    await writer.page.goBack();
    await expect(writer.program.number(1)).toHaveValue("60");
    await writer.page.goForward();
    await expect(page.getByRole("heading", { name: later.name })).toBeVisible();
  });

  await test.step("the teacher watches a student, shows a hint, and helps with another device", async () => {
    const name = nameOf(writer);
    await writer.program.addLine("right >", "70", "right 90");
    await dashboard.watch(name);
    const program = page.getByRole("list", { name: "Program" });
    await expect(program.getByRole("listitem").first()).toContainText("if right > 70");
    await expect(classButton(writer.page)).toHaveAccessibleName(/Your teacher is watching you/);
    await dashboard.sheet.getByRole("button", { name: "Show hint 1" }).click();
    await expect(writer.messages).toContainText("Your teacher shows you hint 1.");
    await dashboard.sheet.getByRole("button", { name: "Return code" }).click();
    const letters = dashboard.sheet.getByText(/^[B-Z]{3} [B-Z]{3}$/);
    const returned = await newStudent();
    await returned.page.goto(`${origin}/join`);
    await returned.page.getByRole("textbox").fill((await letters.textContent()) ?? "");
    await joinByForm(returned.page);
    await expect(writer.messages).toContainText(
      "You are in the class in another tab or on another",
    );
    expect(await returned.name()).toContain(name);
    await expect(dashboard.cards).toHaveCount(8);
    all[all.indexOf(writer)] = returned;
  });

  await test.step("a removed student is gone, and a locked class admits no one", async () => {
    await dashboard.watch(nameOf(bumper));
    await dashboard.sheet.getByRole("button", { name: "Remove" }).click();
    await dashboard.sheet.getByRole("button", { name: "Remove" }).last().click();
    await expect(bumper.messages).toContainText("You are no longer in this class.");
    await expect(dashboard.cards).toHaveCount(7);
    await dashboard.choose("Who can join", "Lock the class");
    await expect(page.getByText("locked", { exact: true })).toBeVisible();
    const ninth = await newStudent();
    await ninth.page.goto(`${origin}/join#${teacher.code}`);
    await ninth.page.getByRole("button", { name: "Join" }).click();
    await expect(ninth.page.getByRole("alert")).toHaveText(
      "This class is locked. Ask your teacher to unlock it.",
    );
  });

  await test.step("the lesson ends, and no byte of it is left", async () => {
    const { code, created } = teacher;
    const present = all.filter((each) => each !== bumper);
    const keys = [created.teacherKey, created.screenKey];
    for (const student of present) keys.push(await student.key());
    const { student } = await storedOf(teacher, nameOf(helper));
    const program = await teacher.get(`/students/${student}/program`);
    const { link } = studentProgramSchema.parse(program);
    const stored = [
      code,
      created.id,
      ...NAMES,
      later.name,
      later.intro,
      link,
      ...keys.map(hashKey),
    ];
    expect(textsInFiles(folder, stored)).toEqual(stored);
    const left = () => textsInFiles(folder, [...stored, ...keys, lesson.name, lesson.intro]);
    expect(textsInFiles(folder, keys)).toEqual([]);
    await dashboard.endLesson.click();
    await page.getByRole("button", { name: "End", exact: true }).click();
    await expect(page.getByRole("heading", { name: "The lesson is over" })).toBeVisible();
    for (const { messages } of present) await expect(messages).toContainText("The lesson is over.");
    expect(left()).toEqual([]);
  });
});
