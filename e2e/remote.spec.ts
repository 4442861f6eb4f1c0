/** Scripts on the network drive the robot in the page. */
import { encodeLink } from "@corridor/link";
import { countOpenCells, generateTree } from "@corridor/maze";
import { mkdtemp, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Locator, Page } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import { expectNoAxeViolations } from "./support/axe.ts";
import { commandRow, openMoreSection } from "./support/remote-panel.ts";
import { api, copyAddress, setSpeed } from "./support/remote-robot.ts";
import { exampleCommand, runScript } from "./support/script.ts";
import { smallWindow } from "./support/window-sizes.ts";

// Tests of the layout set their size.
test.use(smallWindow);

const tree = generateTree({ columns: 7, rows: 7, seed: 3, name: "Tree" });
const openCells = countOpenCells(tree);

/** Long enough for a command that lasts for more than a minute at 0.25×. */
const hall: typeof tree = {
  format: "corridor/maze",
  version: 1,
  name: "Hall",
  blocks: ["#".repeat(24), `#${".".repeat(22)}#`, "#".repeat(24)],
  start: { column: 1, row: 1, heading: "east" },
  goals: [{ column: 22, row: 1 }],
};

function linkTo(maze: typeof tree): string {
  const link = encodeLink({ maze });
  if (!link.ok) throw new Error(link.code);
  return `/#${link.text}`;
}

/** Sends a command. @returns its number */
async function send(address: string, command: object, name?: string): Promise<number> {
  const response = await api(address, "/commands", command, name);
  expect(response.status).toBe(202);
  return (await response.json()).seq;
}

/** Waits at most for some seconds until a command has ended. @returns its record */
async function recordOf(address: string, seq: number, seconds = 20) {
  return (await api(address, `/commands/${seq}?wait=${seconds}`)).json();
}

/** The position of the robot, as scripts read it. */
async function poseOf(address: string): Promise<{ x: number; y: number }> {
  return (await (await api(address, "/sensors")).json()).pose;
}

function distance(from: { x: number; y: number }, to: { x: number; y: number }): number {
  return Math.hypot(to.x - from.x, to.y - from.y);
}

/** Puts the robot back to its start, that of the first maze unless another one is given. */
async function reset(page: Page, address: string, start = { x: 50, y: 650 }): Promise<void> {
  await page.getByRole("button", { name: "Reset", exact: true }).click();
  await expect.poll(() => poseOf(address)).toMatchObject(start);
}

/** The status of the connection, announced to screen readers. */
function connectionStatus(page: Page): Locator {
  return page.getByRole("region", { name: "Remote" }).getByRole("status");
}

// bad-network.spec.ts runs the follower in Python.
test("the JavaScript right-wall follower visits every cell of a tree maze, and the first script runs as copied", async ({
  page,
}) => {
  await page.goto(linkTo(tree));
  await setSpeed(page, "16");
  const address = await copyAddress(page);
  await expect(connectionStatus(page)).toHaveText("Waiting for a script");

  const running = runScript([
    ...exampleCommand("JavaScript"),
    address,
    "--until-cells",
    `${openCells}`,
  ]);
  await expect(connectionStatus(page)).toHaveText("Connected");
  await expect(page.getByRole("cell", { name: "completed" }).first()).toBeVisible();
  const { code, output } = await running;
  expect(output).toContain(`${openCells} cells visited`);
  expect(code).toBe(0);
  const { bumps } = await (await api(address, "/sensors")).json();
  expect(bumps).toBe(0);

  await test.step("the first script, with the linked library file beside it", async () => {
    const { commands } = await (await api(address, "/commands")).json();
    const before: number = commands.at(-1).seq;
    await page.setViewportSize({ width: 1440, height: 900 });
    const starter = page.getByRole("region", { name: "Connect with" });
    await starter.getByRole("button", { name: "Copy", exact: true }).click();
    const copied = await page.evaluate(() => navigator.clipboard.readText());
    expect(copied.trim().split("\n")).toHaveLength(6);
    expect(copied).toContain("from corridor import Robot");
    const displayed = await starter.getByRole("textbox").inputValue();
    expect(displayed).not.toContain(new URL(address).hash.slice(1));
    const download = page.waitForEvent("download");
    await starter.getByRole("link", { name: "Save corridor.py" }).click();
    const library = await download;
    expect(library.suggestedFilename()).toBe("corridor.py");
    const folder = await mkdtemp(join(tmpdir(), "corridor-first-script-"));
    await library.saveAs(join(folder, "corridor.py"));
    await writeFile(join(folder, "script.py"), copied);
    const [python = ""] = exampleCommand("Python");
    const first = await runScript([python, join(folder, "script.py")]);
    await rm(folder, { recursive: true });
    expect([first.code, Number(first.output.trim()) > 0]).toEqual([0, true]);
    const turn = commandRow(page, /turn|left 90/).first();
    await expect(turn).toContainText("completed");
    const number = await turn.getByRole("cell", { name: /^\d+$/ }).textContent();
    expect(Number(number)).toBeGreaterThan(before);
  });
});

test("shows the address, the script and the last commands without scrolling at 1440 x 900, and scrolls only the panel", async ({
  page,
}) => {
  await page.setViewportSize({ width: 1440, height: 900 });
  await page.goto("/");
  await setSpeed(page, "16");
  const address = await copyAddress(page);
  const driverGroup = page.getByRole("group", { name: "Who drives?" });
  const disconnect = page.getByRole("button", { name: "Disconnect" });
  const groupBottom = await driverGroup.evaluate(
    (element) => element.getBoundingClientRect().bottom,
  );
  const panelTop = await disconnect.evaluate((element) => element.getBoundingClientRect().top);
  // The panel starts right below the driver selection, however few commands there are.
  expect(panelTop - groupBottom).toBeLessThan(32);
  for (let count = 0; count < 8; count++) await send(address, { action: "left 90" });
  await recordOf(address, 8);
  await setSpeed(page, "0.25");
  await send(address, { action: "move", distance: 100 });
  await send(address, { action: "right 90" });
  const commands = page.getByRole("region", { name: "Commands", exact: true });
  await expect(commandRow(page, /move 100/)).toContainText("running");
  await expect(commands).toContainText("1 waiting");
  await expect(commands.getByRole("cell", { name: /^\d+$/ })).toHaveText([
    "9",
    "8",
    "7",
    "6",
    "5",
    "4",
  ]);
  // Checks only the first and the last row: the number of rows decreases when the running command
  // ends.
  const numbers = commands.getByRole("cell", { name: /^\d+$/ });
  await expect(numbers.first()).toBeInViewport({ ratio: 0.9 });
  await expect(numbers.last()).toBeInViewport({ ratio: 0.9 });
  await expect(page.getByRole("button", { name: "Show key" })).toHaveCount(0);
  await openMoreSection(page);
  await expect(page.getByRole("button", { name: "Show key" })).toBeVisible();
  const log = page.getByRole("region", { name: "All commands" });
  await expect(log.getByRole("cell", { name: /^\d+$/ })).toHaveCount(10);
  await expectNoAxeViolations(page, "all of Remote");

  for (const [width, height] of [
    [1440, 900],
    [1024, 768],
  ] as const) {
    await page.setViewportSize({ width, height });
    // The Tab key moves the focus there in the same way.
    await page.getByRole("button", { name: "Copy address with key" }).focus();
    await page.getByRole("checkbox", { name: "Scripts may reset the robot" }).focus();
    const { scrollTop, scrollHeight } = await page.evaluate(() => {
      const { scrollTop: top, scrollHeight: whole } = document.documentElement;
      return { scrollTop: top, scrollHeight: whole };
    });
    expect({ width, scrollTop, scrollHeight }).toEqual({
      width,
      scrollTop: 0,
      scrollHeight: height,
    });
  }
});

test("lists commands with their states: completed, collided, expired, cancelled", async ({
  page,
}) => {
  await page.goto("/");
  await setSpeed(page, "16");
  const address = await copyAddress(page);

  await test.step("every command, newest first", async () => {
    for (const command of [
      { action: "move", distance: 100 },
      { action: "left 90" },
      { action: "move", distance: 900 },
    ]) {
      await send(address, command);
    }
    const rows = page.getByRole("region", { name: "Commands", exact: true }).getByRole("row");
    await expect(rows.filter({ hasText: "move 100" })).toContainText("completed");
    await expect(rows.filter({ hasText: "left 90" })).toContainText("completed");
    await expect(rows.filter({ hasText: "move 900" })).toContainText("collided");
    const record = await recordOf(address, 3);
    expect(record).toMatchObject({ seq: 3, state: "collided", action: "move" });
    const log = await (await api(address, "/commands?after=0")).json();
    expect(JSON.stringify(log)).toContain('"seq":3');
    await expect(rows.getByRole("cell", { name: /^\d+$/ })).toHaveText(["3", "2", "1"]);
  });

  await reset(page, address);
  await setSpeed(page, "0.25");
  await test.step("a command that the robot cannot start in time is expired", async () => {
    await send(address, { action: "move", distance: 200 });
    const seq = await send(address, { action: "right 90", ttl: 400 });
    const record = await recordOf(address, seq);
    expect(record).toMatchObject({ state: "expired" });
    expect(record.reason).toMatch(/^Not started within 0.4 s: check that the robot's page is open/);
    const row = commandRow(page, /right 90/);
    await expect(row).toContainText("older than 0.4 s");
    await expect(row).toContainText("expired");
  });

  await reset(page, address);
  await test.step("a running command is cancelled with a reason when the user takes over", async () => {
    const seq = await send(address, { action: "move", distance: 210 });
    await expect(commandRow(page, /move 210/)).toContainText("running");
    await page.getByRole("radio", { name: "Me", exact: true }).click();
    const record = await recordOf(address, seq);
    expect(record).toMatchObject({ state: "cancelled" });
    expect(record.reason).toContain("took over");
    await page.getByRole("radio", { name: "Remote" }).click();
    await expect(page.getByRole("radio", { name: "Remote" })).toBeChecked();
  });

  await reset(page, address);
  await test.step("the robot drives on while the script waits, and stops when the script falls silent", async () => {
    const seq = await send(address, { action: "forward" });
    expect(await recordOf(address, seq, 5)).toMatchObject({ state: "started" });
    await expect(commandRow(page, /forward/)).toContainText("cancelled");
    expect((await recordOf(address, seq)).reason).toContain("stopped sending");
  });

  await reset(page, address);
  await test.step("old commands do not run after manual driving", async () => {
    let last = 0;
    for (let count = 0; count < 30; count++) {
      last = await send(address, { action: "move", distance: 20 });
    }
    const first = last - 29;
    await expect(page.getByRole("cell", { name: "running" })).toBeVisible();
    await page.getByRole("radio", { name: "Me", exact: true }).click();
    await page.getByRole("radio", { name: "Remote" }).click();
    expect(await recordOf(address, last)).toMatchObject({
      state: "cancelled",
      reason: "The robot's page took over: choose Remote there to let scripts drive.",
    });
    const poseAtHandover = await poseOf(address);
    const log = await (await api(address, `/commands?after=${first - 1}`)).json();
    expect(log.commands).toHaveLength(30);
    const open = log.commands.filter(({ state }: { state: string }) => state !== "cancelled");
    // Commands may have completed before the handover, but none after it.
    expect(open.every(({ state }: { state: string }) => state === "completed")).toBe(true);
    await setSpeed(page, "16");
    const next = await send(address, { action: "move", distance: 20 });
    expect(await recordOf(address, next)).toMatchObject({ state: "completed" });
    expect(distance(poseAtHandover, await poseOf(address))).toBeCloseTo(20, 0);
    // While the program drives, a script's command is cancelled immediately.
    await page.getByRole("radio", { name: "Program" }).click();
    await expect(page.getByRole("radio", { name: "Program" })).toBeChecked();
    const refused = await send(address, { action: "left 90" });
    expect(await recordOf(address, refused)).toMatchObject({
      state: "cancelled",
      reason: "Remote is not driving: choose Remote on the robot's page.",
    });
  });
});

test("keeps the address, blocked scripts and a pause of all scripts across a reload", async ({
  page,
}) => {
  await page.goto(linkTo(hall));
  const address = await copyAddress(page);
  await setSpeed(page, "0.25");
  const as = (name: string, path: string, body?: unknown) => api(address, path, body, name);
  const scripts = page.getByRole("region", { name: "Scripts" });
  const anna = scripts.getByRole("listitem").filter({ hasText: "Anna" });

  await test.step("lists scripts by name, and blocks one while the others continue", async () => {
    await as("Anna", "/commands", { action: "move", distance: 1800 });
    await as("Ben", "/commands?after=0");
    await openMoreSection(page);
    await expect(scripts.getByRole("listitem")).toHaveText([
      /Anna.*last: move.*running/,
      /Ben.*only reads/,
    ]);
    await as("Ben", "/commands", { action: "move", distance: 30_000 });
    const ben = scripts.getByRole("listitem").filter({ hasText: "Ben" });
    await expect(ben).toContainText(/Problem at .*: Invalid command\. distance: found 30000/);
    await anna.getByRole("button", { name: "Block", exact: true }).click();
    await expect(anna).toContainText("blocked");
    await expect(commandRow(page, /move 1800/)).toContainText("cancelled");
    await expect(commandRow(page, /move 1800/)).toContainText("The script was blocked.");
    const refused = await as("Anna", "/commands", { action: "left 90" });
    expect([refused.status, (await refused.json()).detail]).toEqual([
      403,
      expect.stringContaining("has blocked this script"),
    ]);
    const turn = await send(address, { action: "left 90" }, "Ben");
    await expectNoAxeViolations(page, "scripts by name");
    await recordOf(address, turn);
  });

  await test.step("the reload ends a running command as cancelled, and the script stays blocked", async () => {
    await reset(page, address, { x: 150, y: 150 });
    const start = await poseOf(address);
    const seq = await send(address, { action: "move", distance: 150 }, "Ben");
    await expect(commandRow(page, /move 150/)).toContainText("running");
    // The page stores a running command's progress every 300 ms: the last 8 cm may be lost.
    await expect.poll(async () => distance(start, await poseOf(address))).toBeGreaterThan(15);
    await page.reload();
    expect(await recordOf(address, seq)).toMatchObject({ state: "cancelled" });
    // The stored progress is restored, and Remote is still the driver.
    await expect(page.getByRole("radio", { name: "Remote" })).toBeChecked();
    expect(distance(start, await poseOf(address))).toBeGreaterThan(5);
    await openMoreSection(page);
    await anna.getByRole("button", { name: "Unblock" }).click();
    await expect(anna.getByRole("button", { name: "Block", exact: true })).toBeVisible();
    await setSpeed(page, "16");
    const next = await send(address, { action: "move", distance: 50 }, "Anna");
    expect(await recordOf(address, next)).toMatchObject({ state: "completed" });
  });

  await test.step("scripts stay paused until they are resumed", async () => {
    await setSpeed(page, "0.25");
    await send(address, { action: "move", distance: 1800 });
    const row = commandRow(page, /move 1800/).first();
    await expect(row).toContainText("running");
    await scripts.getByRole("button", { name: "Pause scripts" }).click();
    await expect(scripts.getByRole("status").first()).toContainText("Paused");
    await expectNoAxeViolations(page, "scripts are paused");
    await expect(row).toContainText("Remote driving was paused.");
    const refused = await api(address, "/commands", { action: "left 90" });
    expect([refused.status, (await refused.json()).detail]).toEqual([
      409,
      expect.stringContaining("Let scripts drive"),
    ]);
    expect((await api(address, "/commands", { action: "stop" })).status).toBe(202);
    await page.reload();
    // The notice is outside the closed section, since no command is executed.
    await expect(page.getByText(/^Paused: scripts can read/)).toBeVisible();
    await setSpeed(page, "16");
    await page.getByRole("button", { name: "Let scripts drive" }).click();
    await expect(page.getByText(/^Paused: scripts can read/)).toHaveCount(0);
    await openMoreSection(page);
    await expect(scripts.getByRole("button", { name: "Pause scripts" })).toBeVisible();
    const sent = await send(address, { action: "left 90" });
    expect(await recordOf(address, sent)).toMatchObject({ state: "completed" });
  });
});

test("a watch link only reads, the documentation opens beside the robot, and a new key revokes the old one", async ({
  page,
}) => {
  await page.goto("/");
  const address = await copyAddress(page);
  const copied = () => page.evaluate(() => navigator.clipboard.readText());
  const panel = page.getByRole("region", { name: "Remote" }).locator("..");
  await expect(panel).toContainText(/Ends in 23 h \d+ min\./);
  await openMoreSection(page);

  await test.step("a watch link can read the robot but not drive it", async () => {
    await page.getByRole("button", { name: "Make a watch link" }).click();
    await expect(page.getByRole("button", { name: "Copy watch link" })).toBeFocused();
    await page.keyboard.press("Enter");
    await expect.poll(copied).toContain("#wch_");
    const link = await copied();
    expect((await api(link, "/sensors?wait=5")).status).toBe(200);
    expect((await api(link, "/commands", { action: "left 90" })).status).toBe(403);
    await expect(connectionStatus(page)).toHaveText("Waiting for a script");
  });

  await test.step("the documentation opens while the robot stays connected", async () => {
    const opened = page.context().waitForEvent("page");
    await page.getByRole("link", { name: "How to write a script" }).click();
    const docs = await opened;
    await expect(docs.getByRole("heading", { level: 1 })).toHaveText(
      "Control a robot from a script",
    );
    expect((await (await api(address, "/sensors?wait=25")).json()).state).toBe("running");
    await docs.close();
  });

  await test.step("a new key revokes the old one, and the page continues with the new address", async () => {
    const waiting = api(address, "/sensors?after=999999999&wait=25");
    await page.getByRole("button", { name: "New key" }).click();
    await page.getByRole("dialog").getByRole("button", { name: "Keep the old key" }).click();
    expect((await api(address, "/sensors")).status).toBe(200);
    await page.getByRole("button", { name: "New key" }).click();
    await page.getByRole("dialog").getByRole("button", { name: "New key" }).click();
    await expect(page.getByText(/^The new key is ready/)).toBeVisible();
    expect((await waiting).status).toBe(401);
    expect((await api(address, "/commands", { action: "left 90" })).status).toBe(401);
    await page.getByRole("button", { name: "Copy address with key" }).click();
    await expect.poll(copied).not.toContain("#wch_");
    const next = await copied();
    expect(next.split("#")[0]).toBe(address.split("#")[0]);
    expect((await api(next, "/commands", { action: "left 90" })).status).toBe(202);
    await expect(commandRow(page, /left 90/)).toContainText("completed");
    // The new address is stored for a reload.
    expect(await page.evaluate(() => sessionStorage.getItem("corridor.remote"))).toContain(next);
  });
});
