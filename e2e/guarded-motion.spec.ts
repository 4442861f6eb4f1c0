/** Scripts drive the robot in the page by motions that end on a condition. */
import type { CommandRecord } from "@corridor/protocol";
import { expect, test } from "./fixtures.ts";
import { commandRow } from "./support/remote-panel.ts";
import { api, copyAddress, setSpeed } from "./support/remote-robot.ts";

const NEAR = { sensor: "front", is: "<=", than: 60 };

test("a script drives forward until the wall is near, exactly and without a bump", async ({
  page,
}) => {
  await page.goto("/");
  await setSpeed(page, "16");
  const address = await copyAddress(page);
  const end = async (seq: number): Promise<CommandRecord> =>
    (await api(address, `/commands/${seq}?wait=20`)).json();

  const sent = await api(address, "/commands", { action: "forward", until: [NEAR] });
  expect(sent.status).toBe(202);
  const first = await end(1);
  expect(first).toMatchObject({ state: "completed", command: { until: [NEAR] } });
  expect(first.distance).toBeGreaterThan(0);
  const { sensors, bumps, motion } = await (await api(address, "/sensors")).json();
  expect(sensors.front).toBeLessThanOrEqual(60);
  // One tick of forward is less than 2 cm, at every speed of the page.
  expect(sensors.front).toBeGreaterThan(58);
  expect([bumps, motion]).toEqual([0, "stop"]);
  await expect(commandRow(page, /forward until front <= 60/)).toContainText("completed");

  await api(address, "/commands", { action: "forward", until: [NEAR] });
  expect(await end(2)).toMatchObject({ state: "completed", distance: 0, pose: first.pose });

  const wrong = await api(address, "/commands", { action: "left 90", until: [NEAR] });
  expect(wrong.status).toBe(400);
  expect((await wrong.json()).errors).toMatchObject([
    { path: "until", expected: "until only with forward, reverse, or drive without milliseconds" },
  ]);
});
