/**
 * Results reported to scripts are never reverted: a reload restores the world of the last ending.
 */
import { commandRecordSchema, type CommandRecord } from "@corridor/protocol";
import type { Page } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import { api, copyAddress, setSpeed } from "./support/remote-robot.ts";
import { smallWindow } from "./support/window-sizes.ts";

test.use(smallWindow);

const TURN = 11;

const NOT_SAVED = "This device cannot save the run.";
const RELOADED = "The robot's page was reloaded and ended this command. Send a new command.";

/** The record of a command. @param search such as ?wait=25, the seconds until it must have ended */
async function recordOf(address: string, seq: number, search = ""): Promise<CommandRecord> {
  const response = await api(address, `/commands/${seq}${search}`);
  return commandRecordSchema.parse(await response.json());
}

/** Begins to turn the robot. @returns the number of the command */
async function beginTurn(address: string, degrees: number): Promise<number> {
  const posted = await api(address, "/commands", { action: "turn", degrees, ttl: 20_000 });
  return commandRecordSchema.parse(await posted.json()).seq;
}

/** Turns the robot once and waits for the command to end. */
async function turn(address: string): Promise<CommandRecord> {
  return recordOf(address, await beginTurn(address, TURN), "?wait=25");
}

/** Reloads the page during a turn. @returns the record of the turn */
async function reloadDuringTurn(page: Page, address: string): Promise<CommandRecord> {
  const seq = await beginTurn(address, 170);
  const state = async () => (await recordOf(address, seq)).state;
  await expect.poll(state).toBe("started");
  await page.reload();
  await expect.poll(state).toBe("cancelled");
  const record = await recordOf(address, seq);
  expect(record).toMatchObject({ reason: RELOADED, distance: 0 });
  return record;
}

test("keeps turns reported as completed across reloads, ends an interrupted one at the restored pose, and transfers the robot to a duplicated tab", async ({
  page,
}) => {
  await page.goto("/");
  const address = await copyAddress(page);
  for (const speed of ["1", "16"]) {
    await test.step(`keeps turns reported as completed across a reload at ${speed}x`, async () => {
      await setSpeed(page, speed);
      await turnAndReload(page, address, speed);
    });
  }

  await test.step("ends a command that a reload interrupts at the restored pose", async () => {
    await setSpeed(page, "0.25");
    const first = await turn(address);
    const ended = await reloadDuringTurn(page, address);
    expect(ended.pose?.x).toBe(first.pose?.x);
    const next = await turn(address);
    const heading = ((ended.pose?.heading ?? Number.NaN) + TURN) % 360;
    expect(next.pose?.heading).toBeCloseTo(heading, 6);
  });

  await test.step("transfers the robot with its world to a duplicated tab, without contradictions from the first tab", async () => {
    await setSpeed(page, "16");
    await duplicateTab(page, address);
  });
});

async function turnAndReload(page: Page, address: string, speed: string): Promise<void> {
  let heading = (await turn(address)).pose?.heading ?? Number.NaN;
  for (let reloads = 0; reloads < 4; reloads++) {
    for (let turns = 0; turns < 4; turns++) {
      const record = await turn(address);
      heading = (heading + TURN) % 360;
      expect(record).toMatchObject({ state: "completed" });
      expect(record.pose?.heading).toBeCloseTo(heading, 6);
    }
    expect(await page.getByText(NOT_SAVED).count(), "the device saves the run").toBe(0);
    await page.reload();
    await setSpeed(page, speed);
    const after = await turn(address);
    heading = (heading + TURN) % 360;
    expect(after.pose?.heading, `after reload ${reloads + 1}`).toBeCloseTo(heading, 6);
  }
}

async function duplicateTab(page: Page, address: string): Promise<void> {
  let heading = (await turn(address)).pose?.heading ?? Number.NaN;
  const opened = page.context().waitForEvent("page");
  // window.open copies the session storage, as duplicating a tab does.
  await page.evaluate(() => void window.open("/"));
  const duplicate = await opened;
  await expect(duplicate.getByRole("radio", { name: "Remote" })).toBeChecked();
  for (let turns = 0; turns < 5; turns++) {
    const record = await turn(address);
    if (record.state === "completed") heading = (heading + TURN) % 360;
    else heading = record.pose?.heading ?? Number.NaN;
    expect(record.pose?.heading).toBeCloseTo(heading, 6);
  }
}

test("reports once that the device cannot store the run, has no database or no room, and restarts the run after a reload", async ({
  page,
}) => {
  const workers = /simulator\.worker.*\.js/;
  const notice = page.getByText(NOT_SAVED);

  await test.step("cancels a running command because of the reload where the device has no database", async () => {
    await page.route(workers, async (route) => {
      const response = await route.fetch();
      const noDatabase = 'Object.defineProperty(self, "indexedDB", { value: undefined });';
      await route.fulfill({ response, body: noDatabase + (await response.text()) });
    });
    await page.goto("/");
    const address = await copyAddress(page);
    const start = (await turn(address)).pose?.heading;
    await expect(notice).toHaveCount(1);
    await setSpeed(page, "0.25");
    const cut = await reloadDuringTurn(page, address);
    expect(cut.pose?.heading).toBeCloseTo((start ?? Number.NaN) - TURN, 6);
    expect((await turn(address)).pose?.heading).toBe(start);
    await page.unroute(workers);
    // A document of the same origin, without scripts.
    await page.goto("/robots.txt");
    await page.evaluate(() => {
      localStorage.clear();
      sessionStorage.clear();
    });
  });

  await test.step("reports once that the device has no room, and restarts the run", async () => {
    await page.addInitScript(() => {
      const setItem = Reflect.get(Storage.prototype, "setItem");
      Storage.prototype.setItem = function (key, text) {
        if (key === "corridor.run") throw new DOMException("full", "QuotaExceededError");
        setItem.call(this, key, text);
      };
    });
    await page.goto("/");
    const address = await copyAddress(page);
    const start = (await turn(address)).pose?.heading;
    await expect(notice).toHaveCount(1);
    await turn(address);
    await setSpeed(page, "0.25");
    const cut = await reloadDuringTurn(page, address);
    expect(cut.pose?.heading).toBeCloseTo((start ?? Number.NaN) - TURN, 6);
    expect((await turn(address)).pose?.heading).toBe(start);
  });
});
