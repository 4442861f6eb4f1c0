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

function linkTo(maze: typeof tree): string {
  const link = encodeLink({ maze });
  if (!link.ok) throw new Error(link.code);
  return `/#${link.text}`;
}

/** The status of the connection, announced to screen readers. */
function connectionStatus(page: Page): Locator {
  return page.getByRole("region", { name: "Remote" }).getByRole("status");
}

// bad-network.spec.ts runs the follower in Python.
test("the JavaScript right-wall follower visits every cell of a tree maze", async ({ page }) => {
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
});

test("the first script runs as copied, with the linked library file beside it", async ({
  page,
}) => {
  await page.setViewportSize({ width: 1440, height: 900 });
  await page.goto(linkTo(tree));
  await setSpeed(page, "16");
  const address = await copyAddress(page);
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
  const { code, output } = await runScript([python, join(folder, "script.py")]);
  await rm(folder, { recursive: true });
  expect([code, Number(output.trim()) > 0]).toEqual([0, true]);
  await expect(commandRow(page, /turn|left 90/).first()).toContainText("completed");
});

test("shows the address, the script and the last commands without scrolling at 1440 x 900", async ({
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
  for (let count = 0; count < 8; count++) await api(address, "/commands", { action: "left 90" });
  await api(address, "/commands/8?wait=20");
  await setSpeed(page, "0.25");
  await api(address, "/commands", { action: "move", distance: 100 });
  await api(address, "/commands", { action: "right 90" });
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
});

test("lists every command with its state, newest first", async ({ page }) => {
  await page.goto("/");
  await setSpeed(page, "16");
  const address = await copyAddress(page);
  for (const command of [
    { action: "move", distance: 100 },
    { action: "left 90" },
    { action: "move", distance: 900 },
  ]) {
    expect((await api(address, "/commands", command)).status).toBe(202);
  }
  const rows = page.getByRole("region", { name: "Commands", exact: true }).getByRole("row");
  await expect(rows.filter({ hasText: "move 100" })).toContainText("completed");
  await expect(rows.filter({ hasText: "left 90" })).toContainText("completed");
  await expect(rows.filter({ hasText: "move 900" })).toContainText("collided");
  const record = await (await api(address, "/commands/3?wait=10")).json();
  expect(record).toMatchObject({ seq: 3, state: "collided", action: "move" });
  const log = await (await api(address, "/commands?after=0")).json();
  expect(JSON.stringify(log)).toContain('"seq":3');
  await expect(rows.getByRole("cell", { name: /^\d+$/ })).toHaveText(["3", "2", "1"]);
});

test("keeps the robot's address across a reload, and ends a running command as cancelled", async ({
  page,
}) => {
  await page.goto("/");
  const address = await copyAddress(page);
  await setSpeed(page, "0.25");
  const poseOf = async () => (await (await api(address, "/sensors")).json()).pose;
  const start = await poseOf();
  const distanceFrom = async ({ x, y }: typeof start) => {
    const pose = await poseOf();
    return Math.hypot(pose.x - x, pose.y - y);
  };
  await api(address, "/commands", { action: "move", distance: 200 });
  await expect(commandRow(page, /move 200/)).toContainText("running");
  // The page stores a running command's progress every 300 ms: the last 8 cm may be lost.
  await expect.poll(() => distanceFrom(start)).toBeGreaterThan(15);
  await page.reload();
  const record = await (await api(address, "/commands/1?wait=20")).json();
  expect(record).toMatchObject({ state: "cancelled" });
  // The stored progress is restored, and Remote is still the driver.
  await expect(page.getByRole("radio", { name: "Remote" })).toBeChecked();
  expect(await distanceFrom(start)).toBeGreaterThan(5);
  await setSpeed(page, "16");
  await api(address, "/commands", { action: "move", distance: 50 });
  const next = await (await api(address, "/commands/2?wait=20")).json();
  expect(next).toMatchObject({ state: "completed" });
});

test("drives on while the script waits, and stops when the script falls silent", async ({
  page,
}) => {
  await page.goto("/");
  const address = await copyAddress(page);
  await setSpeed(page, "0.25");
  await api(address, "/commands", { action: "forward" });
  const waiting = await (await api(address, "/commands/1?wait=5")).json();
  expect(waiting).toMatchObject({ state: "started" });
  await expect(commandRow(page, /forward/)).toContainText("cancelled");
  const record = await (await api(address, "/commands/1")).json();
  expect(record.reason).toContain("stopped sending");
});

test("lists a command that the robot cannot start in time as expired", async ({ page }) => {
  await page.goto("/");
  const address = await copyAddress(page);
  await setSpeed(page, "0.25");
  await api(address, "/commands", { action: "move", distance: 200 });
  await api(address, "/commands", { action: "left 90", ttl: 400 });
  const record = await (await api(address, "/commands/2?wait=10")).json();
  expect(record).toMatchObject({ state: "expired" });
  expect(record.reason).toMatch(/^Not started within 0.4 s: check that the robot's page is open/);
  const row = commandRow(page, /left 90/);
  await expect(row).toContainText("older than 0.4 s");
  await expect(row).toContainText("expired");
});

test("a new key revokes the old one, and the page continues with the new address", async ({
  page,
}) => {
  await page.goto("/");
  const address = await copyAddress(page);
  const panel = page.getByRole("region", { name: "Remote" }).locator("..");
  await expect(panel).toContainText(/Ends in 23 h \d+ min\./);
  const waiting = api(address, "/sensors?after=999999999&wait=25");
  await openMoreSection(page);
  await page.getByRole("button", { name: "New key" }).click();
  await page.getByRole("dialog").getByRole("button", { name: "Keep the old key" }).click();
  expect((await api(address, "/sensors")).status).toBe(200);
  await page.getByRole("button", { name: "New key" }).click();
  await page.getByRole("dialog").getByRole("button", { name: "New key" }).click();
  await expect(page.getByText(/^The new key is ready/)).toBeVisible();
  expect((await waiting).status).toBe(401);
  expect((await api(address, "/commands", { action: "left 90" })).status).toBe(401);
  await page.getByRole("button", { name: "Copy address with key" }).click();
  const next = await page.evaluate(() => navigator.clipboard.readText());
  expect(next.split("#")[0]).toBe(address.split("#")[0]);
  expect((await api(next, "/commands", { action: "left 90" })).status).toBe(202);
  await expect(commandRow(page, /left 90/)).toContainText("completed");
  // The new address is stored for a reload.
  expect(await page.evaluate(() => sessionStorage.getItem("corridor.remote"))).toContain(next);
});

test("a watch link can read the robot but not drive it", async ({ page }) => {
  await page.goto("/");
  await copyAddress(page);
  await openMoreSection(page);
  await page.getByRole("button", { name: "Make a watch link" }).click();
  await expect(page.getByRole("button", { name: "Copy watch link" })).toBeFocused();
  await page.keyboard.press("Enter");
  const copied = () => page.evaluate(() => navigator.clipboard.readText());
  await expect.poll(copied).toContain("#wch_");
  const address = await copied();
  expect((await api(address, "/sensors?wait=5")).status).toBe(200);
  expect((await api(address, "/commands", { action: "left 90" })).status).toBe(403);
  await expect(connectionStatus(page)).toHaveText("Waiting for a script");
});

test("opens the documentation while the robot stays connected", async ({ page }) => {
  await page.goto("/");
  const address = await copyAddress(page);
  const opened = page.context().waitForEvent("page");
  await page.getByRole("link", { name: "How to write a script" }).click();
  const docs = await opened;
  await expect(docs.getByRole("heading", { level: 1 })).toHaveText("Control a robot from a script");
  expect((await (await api(address, "/sensors?wait=25")).json()).state).toBe("running");
});

test("lists scripts by name, and blocks one while the others continue", async ({ page }) => {
  await page.goto("/");
  const address = await copyAddress(page);
  await setSpeed(page, "0.25");
  const as = (name: string, path: string, body?: unknown) => api(address, path, body, name);
  await as("Anna", "/commands", { action: "move", distance: 200 });
  await as("Ben", "/commands?after=0");
  await openMoreSection(page);
  const scripts = page.getByRole("region", { name: "Scripts" }).getByRole("listitem");
  await expect(scripts).toHaveText([/Anna.*last: move.*running/, /Ben.*only reads/]);
  await as("Ben", "/commands", { action: "move", distance: 30_000 });
  const ben = scripts.filter({ hasText: "Ben" });
  await expect(ben).toContainText(/Problem at .*: Invalid command\. distance: found 30000/);
  const anna = scripts.filter({ hasText: "Anna" });
  await anna.getByRole("button", { name: "Block", exact: true }).click();
  await expect(anna).toContainText("blocked");
  await expect(commandRow(page, /move 200/)).toContainText("cancelled");
  await expect(commandRow(page, /move 200/)).toContainText("The script was blocked.");
  const refused = await as("Anna", "/commands", { action: "left 90" });
  expect([refused.status, (await refused.json()).detail]).toEqual([
    403,
    expect.stringContaining("has blocked this script"),
  ]);
  expect((await as("Ben", "/commands", { action: "left 90" })).status).toBe(202);
  await expectNoAxeViolations(page, "scripts by name");
  // The script is still blocked after a reload of the page.
  await page.reload();
  await openMoreSection(page);
  await anna.getByRole("button", { name: "Unblock" }).click();
  await expect(anna.getByRole("button", { name: "Block", exact: true })).toBeVisible();
  expect((await as("Anna", "/commands", { action: "left 90" })).status).toBe(202);
});

test("switches from a script to manual driving and back without running old commands", async ({
  page,
}) => {
  await page.goto("/");
  const address = await copyAddress(page);
  await setSpeed(page, "0.25");
  const poseOf = async () => (await (await api(address, "/sensors")).json()).pose;
  for (let count = 0; count < 30; count++) {
    expect((await api(address, "/commands", { action: "move", distance: 20 })).status).toBe(202);
  }
  await expect(page.getByRole("cell", { name: "running" })).toBeVisible();
  await page.getByRole("radio", { name: "Me", exact: true }).click();
  await page.getByRole("radio", { name: "Remote" }).click();
  const last = await (await api(address, "/commands/30?wait=20")).json();
  expect(last).toMatchObject({
    state: "cancelled",
    reason: "The robot's page took over: choose Remote there to let scripts drive.",
  });
  const poseAtHandover = await poseOf();
  const log = await (await api(address, "/commands")).json();
  const open = log.commands.filter(({ state }: { state: string }) => state !== "cancelled");
  // Commands may have completed before the handover, but none after it.
  expect(open.every(({ state }: { state: string }) => state === "completed")).toBe(true);
  await setSpeed(page, "16");
  await api(address, "/commands", { action: "move", distance: 20 });
  expect(await (await api(address, "/commands/31?wait=20")).json()).toMatchObject({
    state: "completed",
  });
  const { x, y } = await poseOf();
  expect(Math.hypot(x - poseAtHandover.x, y - poseAtHandover.y)).toBeCloseTo(20, 0);
  // While the program drives, a script's command is cancelled immediately.
  await page.getByRole("radio", { name: "Program" }).click();
  await api(address, "/commands", { action: "left 90" });
  const refused = await (await api(address, "/commands/32?wait=20")).json();
  expect(refused).toMatchObject({
    state: "cancelled",
    reason: "Remote is not driving: choose Remote on the robot's page.",
  });
});

test("keeps scripts paused until they are resumed, also across a reload", async ({ page }) => {
  await page.goto("/");
  const address = await copyAddress(page);
  await setSpeed(page, "0.25");
  await api(address, "/commands", { action: "move", distance: 200 });
  const row = commandRow(page, /move 200/);
  await expect(row).toContainText("running");
  await openMoreSection(page);
  const scripts = page.getByRole("region", { name: "Scripts" });
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
  const sent = await (await api(address, "/commands", { action: "left 90" })).json();
  const record = await (await api(address, `/commands/${sent.seq}?wait=20`)).json();
  expect(record).toMatchObject({ state: "completed" });
});

test("cancels a script's command with a reason when the user takes over", async ({ page }) => {
  await page.goto("/");
  const address = await copyAddress(page);
  await setSpeed(page, "0.25");
  await api(address, "/commands", { action: "move", distance: 200 });
  await expect(commandRow(page, /move 200/)).toContainText("running");
  await page.getByRole("radio", { name: "Me", exact: true }).click();
  const record = await (await api(address, "/commands/1?wait=20")).json();
  expect(record).toMatchObject({ state: "cancelled" });
  expect(record.reason).toContain("took over");
});

test("scrolls the panel and never the page", async ({ page }) => {
  await page.setViewportSize({ width: 1440, height: 900 });
  await page.goto("/");
  await copyAddress(page);
  await openMoreSection(page);
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
