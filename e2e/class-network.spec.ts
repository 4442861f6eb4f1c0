/** A class where WebSockets are blocked, and one whose members use different relays. */
import { lessonOfTasks } from "@corridor/challenge/testing";
import { mkdirSync } from "node:fs";
import { findRedis, startRedis } from "../scripts/redis-server.ts";
import { RelayProcess } from "../tests/support/relay-process.ts";
import { makeCertificate, TlsProxy } from "./faults/net/tls-proxy.ts";
import { expect, test as base } from "./fixtures.ts";
import { DashboardPage } from "./pages/dashboard-page.ts";
import { textsInFiles } from "../tests/support/stored-files.ts";
import { ClassTeacher } from "./support/class-teacher.ts";
import { enterClass, scanCode } from "./support/enter-class.ts";
import { lessonTask } from "./support/lesson-task.ts";
import { RelayProxy } from "./support/relay-proxy.ts";
import { smallWindow, wideWindow } from "./support/window-sizes.ts";

/** Two relays that share a Redis, which stores its data in the folder. */
interface Cluster {
  first: RelayProcess;
  second: RelayProcess;
  folder: string;
}

const test = base.extend<{ cluster: Cluster }>({
  // oxlint-disable-next-line no-empty-pattern -- Playwright reads the fixture names from this pattern
  cluster: async ({}, use, testInfo) => {
    testInfo.skip(findRedis() === null, "Redis is not installed");
    const folder = testInfo.outputPath("redis");
    mkdirSync(folder, { recursive: true });
    const redis = await startRedis(folder);
    const options = { environment: { STORE_URL: redis.url } };
    const [first, second] = [await RelayProcess.start(options), await RelayProcess.start(options)];
    await use({ first, second, folder });
    for (const relay of [first, second]) await relay.stop();
    await redis.stop("SIGKILL");
  },
});

const NAMES = ["Quagga 1", "Quagga 2"];
const lesson = lessonOfTasks("Zebra crossing", [lessonTask("Straight on", ["Look ahead."])]);
const LOST = "The connection to the class is lost.";
const PAUSED = "Eyes to the front. Your teacher paused the class.";

test("teacher and student work over plain HTTPS where WebSockets are blocked", async ({
  browser,
  relay,
}, testInfo) => {
  const folder = testInfo.outputPath("certificate");
  mkdirSync(folder, { recursive: true });
  const certificate = makeCertificate(folder);
  test.skip(certificate === null, "openssl is not installed");
  if (certificate === null) return;
  const filter = await RelayProxy.start(relay);
  const filterPort = Number(new URL(filter.url).port);
  const tls = await TlsProxy.start(certificate, () => filterPort);
  const origin = `https://127.0.0.1:${tls.port}`;
  const { created } = await ClassTeacher.start(relay, NAMES, lesson);
  // Not openWindow fixtures: the browser logs an error for each WebSocket that does not open.
  const contexts = [
    await browser.newContext({ ...wideWindow, ignoreHTTPSErrors: true }),
    await browser.newContext({ ...smallWindow, ignoreHTTPSErrors: true }),
  ] as const;
  const [page, studentPage] = [await contexts[0].newPage(), await contexts[1].newPage()];
  const longPolls = [page, studentPage].map((each) =>
    each.waitForRequest((request) => request.url().includes(`/classes/${created.id}/long-poll`)),
  );
  await page.goto(`${origin}/class/${created.id}#${created.teacherKey}`);
  const dashboard = new DashboardPage(page);
  await expect(dashboard.code).toContainText("No student has joined yet.");
  const student = await scanCode(studentPage, created.code, origin);
  // What a student does before the lesson opens belongs to the student's own project.
  await expect(student.page.getByRole("heading", { name: "Straight on" })).toBeVisible();
  await Promise.all(longPolls);
  await expect(dashboard.cards).toHaveAccessibleName(/, Writing, 0 minutes/);
  const band = studentPage.getByText(PAUSED, { exact: true });
  await dashboard.page.getByRole("button", { name: "Pause everyone" }).click();
  await expect(band).toBeVisible();
  await page.getByRole("button", { name: "End the pause" }).click();
  await expect(band).toBeHidden();
  await student.program.otherwise.selectOption("forward");
  await student.run.click();
  await expect(dashboard.cards).toHaveAccessibleName(/, Driving, /);
  await expect(dashboard.cards).toHaveAccessibleName(/, Solved, .+, 1 attempt$/);
  await expect(page.getByText(LOST)).toHaveCount(0);
  await expect(student.messages).not.toContainText(LOST);
  for (const context of contexts) await context.close();
  await tls.close();
  await filter.close();
});

test("teacher and student use two relays, of which one is killed", async ({
  openWindow,
  pageErrors,
  cluster: { first, second, folder },
}) => {
  // Three starts of a relay and two of a page.
  test.setTimeout(300_000);
  pageErrors.ignoreFailedRequests();
  const teacher = await ClassTeacher.start(first.url, NAMES, lesson);
  const { created } = teacher;
  const { page } = await openWindow(wideWindow);
  await page.goto(teacher.address());
  const dashboard = new DashboardPage(page);
  const student = await enterClass((await openWindow(smallWindow)).page, created.code, second.url);
  await expect(student.page.getByRole("heading", { name: "Straight on" })).toBeVisible();
  await expect(dashboard.cards).toHaveAccessibleName(/, Writing, 0 minutes/);
  await student.program.otherwise.selectOption("reverse");
  await student.run.click();
  await expect(dashboard.cards).toHaveAccessibleName(/, Bumped, .+, 1 attempt$/);
  const band = student.page.getByText(PAUSED, { exact: true });
  await dashboard.page.getByRole("button", { name: "Pause everyone" }).click();
  await expect(band).toBeVisible();

  await second.killAndRestart();
  await page.getByRole("button", { name: "End the pause" }).click();
  await expect(band).toBeHidden({ timeout: 90_000 });
  await student.reset.click();
  await student.program.otherwise.selectOption("forward");
  await student.run.click();
  await expect(dashboard.cards).toHaveAccessibleName(/, Solved, .+, 2 attempts$/);

  const stored = () => textsInFiles(folder, [created.id, created.code, lesson.name, ...NAMES]);
  expect(stored()).toHaveLength(5);
  await dashboard.endLesson.click();
  await page.getByRole("button", { name: "End", exact: true }).click();
  await expect(student.messages).toContainText("The lesson is over.");
  await expect.poll(stored).toEqual([]);
});
