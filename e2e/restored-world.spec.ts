/**
 * Results reported to scripts are never reverted: a reload restores the world of the last ending.
 */
import { commandRecordSchema, type CommandRecord } from "@corridor/protocol";
import { expect, test } from "./fixtures.ts";
import { api, copyAddress, setSpeed } from "./support/remote-robot.ts";

const TURN = 11;

const RELOADED = "The robot's page was reloaded and ended this command. Send a new command.";

/** Turns the robot once and waits for the command to end. */
async function turn(address: string): Promise<CommandRecord> {
  const posted = await api(address, "/commands", { action: "turn", degrees: TURN, ttl: 20_000 });
  const { seq } = commandRecordSchema.parse(await posted.json());
  const response = await api(address, `/commands/${seq}?wait=25`);
  return commandRecordSchema.parse(await response.json());
}

for (const speed of ["1", "16"]) {
  test(`keeps turns reported as completed across a reload at ${speed}x`, async ({ page }) => {
    await page.goto("/");
    await setSpeed(page, speed);
    const address = await copyAddress(page);
    let heading = (await turn(address)).pose?.heading ?? Number.NaN;
    for (let reloads = 0; reloads < 4; reloads++) {
      for (let turns = 0; turns < 4; turns++) {
        const record = await turn(address);
        heading = (heading + TURN) % 360;
        expect(record).toMatchObject({ state: "completed" });
        expect(record.pose?.heading).toBeCloseTo(heading, 6);
      }
      await page.reload();
      await setSpeed(page, speed);
      const after = await turn(address);
      heading = (heading + TURN) % 360;
      expect(after.pose?.heading, `after reload ${reloads + 1}`).toBeCloseTo(heading, 6);
    }
  });
}

test("ends a command that a reload interrupts at the restored pose", async ({ page }) => {
  await page.goto("/");
  await setSpeed(page, "0.25");
  const address = await copyAddress(page);
  const first = await turn(address);
  const posted = await api(address, "/commands", { action: "turn", degrees: 170, ttl: 20_000 });
  const { seq } = commandRecordSchema.parse(await posted.json());
  await expect
    .poll(async () => (await (await api(address, `/commands/${seq}`)).json()).state)
    .toBe("started");
  await page.reload();
  await expect
    .poll(async () => (await (await api(address, `/commands/${seq}`)).json()).state)
    .toBe("cancelled");
  const ended = commandRecordSchema.parse(await (await api(address, `/commands/${seq}`)).json());
  expect(ended).toMatchObject({ reason: RELOADED, distance: 0 });
  expect(ended.pose?.x).toBe(first.pose?.x);
  const next = await turn(address);
  const heading = ((ended.pose?.heading ?? Number.NaN) + TURN) % 360;
  expect(next.pose?.heading).toBeCloseTo(heading, 6);
});

test("reports once that the device cannot store the run, and restarts the run after a reload", async ({
  page,
}) => {
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
  const notice = page.getByText("This device cannot save the run.");
  await expect(notice).toHaveCount(1);
  await turn(address);
  const posted = await api(address, "/commands", { action: "turn", degrees: 170, ttl: 20_000 });
  const { seq } = commandRecordSchema.parse(await posted.json());
  await expect
    .poll(async () => (await (await api(address, `/commands/${seq}`)).json()).state)
    .toBe("started");
  await page.reload();
  expect((await turn(address)).pose?.heading).toBe(start);
  const cut = commandRecordSchema.parse(await (await api(address, `/commands/${seq}`)).json());
  expect(cut).toMatchObject({ state: "cancelled", reason: RELOADED, distance: 0 });
  expect(cut.pose?.heading).toBeCloseTo((start ?? Number.NaN) - TURN, 6);
});

test("cancels a running command because of the reload where the device has no database", async ({
  page,
}) => {
  await page.route(/simulator\.worker.*\.js/, async (route) => {
    const response = await route.fetch();
    const noDatabase = 'Object.defineProperty(self, "indexedDB", { value: undefined });';
    await route.fulfill({ response, body: noDatabase + (await response.text()) });
  });
  await page.goto("/");
  const address = await copyAddress(page);
  const start = (await turn(address)).pose?.heading;
  await expect(page.getByText("This device cannot save the run.")).toHaveCount(1);
  await setSpeed(page, "0.25");
  const posted = await api(address, "/commands", { action: "turn", degrees: 170, ttl: 20_000 });
  const { seq } = commandRecordSchema.parse(await posted.json());
  await expect
    .poll(async () => (await (await api(address, `/commands/${seq}`)).json()).state)
    .toBe("started");
  await page.reload();
  await expect
    .poll(async () => (await (await api(address, `/commands/${seq}`)).json()).state)
    .toBe("cancelled");
  const cut = commandRecordSchema.parse(await (await api(address, `/commands/${seq}`)).json());
  expect(cut).toMatchObject({ state: "cancelled", reason: RELOADED, distance: 0 });
  expect(cut.pose?.heading).toBeCloseTo((start ?? Number.NaN) - TURN, 6);
  expect((await turn(address)).pose?.heading).toBe(start);
});

test("transfers the robot with its world to a duplicated tab, without contradictions from the first tab", async ({
  page,
  context,
}) => {
  await page.goto("/");
  await setSpeed(page, "16");
  const address = await copyAddress(page);
  let heading = (await turn(address)).pose?.heading ?? Number.NaN;
  const opened = context.waitForEvent("page");
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
});
