/** Scripts put the robot in the page back to its start. */
import type { CommandRecord, Snapshot } from "@corridor/protocol";
import { expect, test } from "./fixtures.ts";
import type { CorridorPage } from "./pages/corridor-page.ts";
import { commandRow, openMoreSection } from "./support/remote-panel.ts";
import { api, copyAddress, setSpeed } from "./support/remote-robot.ts";
import { smallWindow } from "./support/window-sizes.ts";

test.use(smallWindow);

const RESET = { action: "reset" };
const MOVE = { action: "move", distance: 60 };

async function end(address: string, seq: number): Promise<CommandRecord> {
  return (await api(address, `/commands/${seq}?wait=20`)).json();
}

async function newest(address: string): Promise<Snapshot> {
  return (await api(address, "/sensors")).json();
}

async function drivesAgainAfterReset(corridor: CorridorPage, address: string): Promise<void> {
  const { page } = corridor;
  const start = (await newest(address)).pose;
  await api(address, "/commands", MOVE);
  const first = await end(address, 1);
  await api(address, "/commands", { action: "turn", degrees: 3600 });
  await api(address, "/commands", MOVE);
  await expect(commandRow(page, /turn 3600/)).toContainText("running");

  expect((await api(address, "/commands", RESET)).status).toBe(202);
  expect(await end(address, 4)).toMatchObject({ state: "completed", distance: 0, pose: start });
  expect((await end(address, 2)).state).toBe("superseded");
  expect((await end(address, 3)).state).toBe("superseded");
  expect(await newest(address)).toMatchObject({ driver: "remote", pose: start, bumps: 0 });
  await expect(commandRow(page, /reset/)).toContainText("completed");
  // The page displays a new run, in which the script has not driven yet.
  await expect(corridor.drivingTime).toHaveText("Time 0:00.0 driving");
  await expect(corridor.timeline.command("1")).toHaveCount(0);

  await api(address, "/commands", MOVE);
  expect(await end(address, 5)).toMatchObject({ state: "completed", pose: first.pose });
  await expect(corridor.timeline.command("5")).toHaveAttribute("data-result", "done");
}

async function forbidsResets({ page }: CorridorPage, address: string): Promise<void> {
  await openMoreSection(page);
  const permission = page.getByRole("checkbox", { name: "Scripts may reset the robot" });
  await expect(permission).toBeChecked();
  await permission.click();
  await expect(permission).not.toBeChecked();
  const refused = await api(address, "/commands", RESET);
  expect([refused.status, (await refused.json()).type]).toEqual([403, "/problems/reset-disabled"]);
  expect((await api(address, "/commands", MOVE)).status).toBe(202);

  await page.reload();
  await openMoreSection(page);
  await expect(permission).not.toBeChecked();
  await permission.click();
  await expect(permission).toBeChecked();
  expect((await api(address, "/commands", RESET)).status).toBe(202);
}

async function leavesProgramAlone(corridor: CorridorPage, address: string): Promise<void> {
  await corridor.selectDriver("Program");
  const { program } = corridor;
  const { lines } = program;
  const before = await lines.count();
  await program.button("Add line").click();
  await expect(lines).toHaveCount(before + 1);
  await corridor.run.click();
  await expect.poll(async () => (await newest(address)).tick).toBeGreaterThan(30);
  const { tick } = await newest(address);
  const { seq } = await (await api(address, "/commands", RESET)).json();
  expect((await end(address, seq)).state).toBe("cancelled");
  expect((await newest(address)).tick).toBeGreaterThanOrEqual(tick);

  await corridor.selectDriver("Remote");
  await expect.poll(async () => (await api(address, "/commands", RESET)).status).toBe(202);
  expect((await end(address, seq + 1)).state).toBe("completed");
  await corridor.selectDriver("Program");
  await expect(lines).toHaveCount(before + 1);
  await program.button("Undo").click();
  await expect(lines).toHaveCount(before);
}

test("scripts reset the robot, where the owner allows it", async ({ corridor, page }) => {
  await setSpeed(page, "4");
  const address = await copyAddress(page);
  await test.step("a script drives, resets the robot during a motion, and drives again", () =>
    drivesAgainAfterReset(corridor, address));
  await test.step("a reset while a program drives is cancelled, and no reset touches the program or its undo", () =>
    leavesProgramAlone(corridor, address));
  await corridor.selectDriver("Remote");
  await test.step("the owner forbids resets and allows them again", () =>
    forbidsResets(corridor, address));
});
