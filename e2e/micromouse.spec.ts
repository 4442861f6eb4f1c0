/** A micromouse program drives the robot in the page, and shows its map over the maze. */
import { spawn } from "node:child_process";
import { once } from "node:events";
import { fileURLToPath } from "node:url";
import { lessonOfTasks } from "@corridor/challenge/testing";
import { readTextMaze } from "@corridor/maze";
import type { Page } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import { DashboardPage } from "./pages/dashboard-page.ts";
import { StageScreenshot } from "./pages/stage-screenshot.ts";
import { ClassTeacher } from "./support/class-teacher.ts";
import { enterClass } from "./support/enter-class.ts";
import { lessonTask } from "./support/lesson-task.ts";
import { openMoreSection } from "./support/remote-panel.ts";
import { copyAddress, setSpeed } from "./support/remote-robot.ts";
import { smallWindow } from "./support/window-sizes.ts";

const CLI = fileURLToPath(new URL("../apps/cli/src/main.ts", import.meta.url));
const WALL_FOLLOWER = fileURLToPath(
  new URL("../tests/support/mouse/wall-follower.mjs", import.meta.url),
);

/** Marks cells of the first row, and stands until it is stopped. */
const PROGRAM = `
  const input = require("node:readline").createInterface({ input: process.stdin });
  input.once("line", (width) => {
    for (let x = 0; x < width; x++) console.log("setColor " + x + " 0 r\\nsetText " + x + " 0 " + x + "\\nsetWall " + x + " 0 n");
    console.error("marked " + width);
  });
  console.log("mazeWidth");
`;

/** @param program arguments of Node */
function startProgram(address: string, program: readonly string[]) {
  const bridge = spawn(process.execPath, [CLI, "mms", "--", process.execPath, ...program], {
    env: { ...process.env, CORRIDOR_ROBOT: address },
    stdio: ["ignore", "inherit", "pipe"],
  });
  return { bridge, marked: once(bridge.stderr, "data"), exited: once(bridge, "exit") };
}

async function toggleMarks(page: Page): Promise<void> {
  await page.getByRole("button", { name: "View", exact: true }).click();
  await page.getByRole("checkbox", { name: "Marks of scripts" }).click();
  await page.keyboard.press("Escape");
  await expect(page.getByRole("dialog", { name: "View" })).toBeHidden();
}

test("a micromouse program shows its map in the page, until it ends or the map is hidden", async ({
  corridor: _corridor,
  page,
  openWindow,
}) => {
  // It starts two more processes and compares pictures.
  test.slow();
  await setSpeed(page, "16");
  const address = await copyAddress(page);
  await openMoreSection(page);
  await page.getByRole("button", { name: "Make a watch link" }).click();
  await page.getByRole("button", { name: "Copy watch link" }).click();
  const watchLink = await page.evaluate(() => navigator.clipboard.readText());
  const viewer = (await openWindow()).page;
  await viewer.goto(watchLink);

  const { bridge, marked, exited } = startProgram(address, ["-e", PROGRAM]);
  try {
    expect(String(await marked)).toMatch(/^marked \d+/);
    const scripts = page.getByRole("region", { name: "Scripts", exact: true });
    await expect(scripts.getByText("mms script")).toBeVisible();
    const stage = new StageScreenshot(page);
    const withMarks = await stage.capture();
    const switchOfViewer = viewer.getByRole("checkbox", { name: "Marks of scripts" });
    await expect(switchOfViewer).toBeChecked();
    const seen = viewer.getByRole("main");
    const seenMarks = await seen.screenshot();
    await switchOfViewer.click();
    await expect.poll(async () => (await seen.screenshot()).equals(seenMarks)).toBe(false);
    await switchOfViewer.click();
    await expect.poll(async () => (await seen.screenshot()).equals(seenMarks)).toBe(true);
    await toggleMarks(page);
    await stage.expectDifferent(withMarks);
    const without = await stage.capture();
    await toggleMarks(page);
    await stage.expectDifferent(without);
    bridge.kill("SIGINT");
    expect((await exited)[0]).toBe(0);
    await stage.expectSame(without);
    await expect.poll(async () => (await seen.screenshot()).equals(seenMarks)).toBe(false);
  } finally {
    bridge.kill("SIGKILL");
  }
});

/** A wall follower reaches the goal in the middle. */
const CONTEST = `
o---o---o---o---o
|               |
o   o---o---o   o
|   | G   G |   |
o   o   o   o   o
|   | G   G     |
o   o---o---o---o
| S |           |
o---o---o---o---o
`.trim();

test("a class sees a micromouse program solve the task of a student", async ({
  page,
  openWindow,
  relay,
}) => {
  const read = readTextMaze(CONTEST, "Final");
  if (!read.ok) throw new Error(JSON.stringify(read.problems));
  const checks = { bumps: 0, seconds: 600 };
  const allowed = { drivers: ["program" as const, "remote" as const] };
  const contest = lessonTask("Contest", [], { mazes: [read.value], checks, allowed });
  const teacher = await ClassTeacher.start(relay, ["Juniper"], lessonOfTasks("Mice", [contest]));
  await enterClass(page, teacher.code);
  const card = page.getByRole("complementary").getByText("Solve Contest.");
  await expect(card).toBeVisible();
  await setSpeed(page, "max");
  const address = await copyAddress(page);
  await expect(card).toBeVisible();
  const { page: board } = await openWindow(smallWindow);
  await board.goto(teacher.address());
  const dashboard = new DashboardPage(board);
  await dashboard.cardOf("Juniper").waitFor();
  const { bridge, exited } = startProgram(address, [WALL_FOLLOWER]);
  try {
    expect((await exited)[0]).toBe(0);
    await expect(page.getByRole("heading", { name: "Solved!" })).toBeVisible();
    await dashboard.expectState("Juniper", "Solved");
    expect(await teacher.progress()).toMatchObject([
      { kind: "opened" },
      { kind: "run", bumps: 0, failure: null },
      { kind: "solved", lines: null },
    ]);
  } finally {
    bridge.kill("SIGKILL");
  }
});
