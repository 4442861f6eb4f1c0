/** A micromouse program drives the robot in the page, and shows its map over the maze. */
import { spawn } from "node:child_process";
import { once } from "node:events";
import { fileURLToPath } from "node:url";
import type { Page } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import { StageScreenshot } from "./pages/stage-screenshot.ts";
import { openMoreSection } from "./support/remote-panel.ts";
import { copyAddress, setSpeed } from "./support/remote-robot.ts";

const CLI = fileURLToPath(new URL("../apps/cli/src/main.ts", import.meta.url));

/** Marks cells of the first row, and stands until it is stopped. */
const PROGRAM = `
  const input = require("node:readline").createInterface({ input: process.stdin });
  input.once("line", (width) => {
    for (let x = 0; x < width; x++) console.log("setColor " + x + " 0 r\\nsetText " + x + " 0 " + x + "\\nsetWall " + x + " 0 n");
    console.error("marked " + width);
  });
  console.log("mazeWidth");
`;

function startProgram(address: string) {
  const bridge = spawn(process.execPath, [CLI, "mms", "--", process.execPath, "-e", PROGRAM], {
    env: { ...process.env, CORRIDOR_ROBOT: address },
    stdio: ["ignore", "inherit", "pipe"],
  });
  return { bridge, marked: once(bridge.stderr, "data"), exited: once(bridge, "exit") };
}

async function toggleMarks(page: Page): Promise<void> {
  await page.getByRole("button", { name: "View", exact: true }).click();
  await page.getByRole("checkbox", { name: "Marks of scripts" }).click();
  await page.keyboard.press("Escape");
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

  const { bridge, marked, exited } = startProgram(address);
  try {
    expect(String(await marked)).toMatch(/^marked \d+/);
    const scripts = page.getByRole("region", { name: "Scripts", exact: true });
    await expect(scripts.getByText("mms script")).toBeVisible();
    const stage = new StageScreenshot(page);
    const withMarks = await stage.capture();
    const seen = viewer.getByRole("main");
    const seenMarks = await seen.screenshot();
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
