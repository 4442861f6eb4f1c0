/** The timeline and the clock of a run that a script drives. */
import { expect, test } from "./fixtures.ts";
import { api, copyAddress, setSpeed } from "./support/remote-robot.ts";

/** turns on the spot for four seconds */
const spin = { action: "drive", left: 0.2, right: -0.2, milliseconds: 4000 };

test("numbers the commands of a script with their results, and displays a selected command", async ({
  corridor,
  page,
}) => {
  const { timeline } = corridor;
  await setSpeed(page, "4");
  const address = await copyAddress(page);
  for (const command of [spin, spin, { action: "move", distance: 5000 }]) {
    await api(address, "/commands", command);
  }
  await expect(timeline.command("3")).toHaveAttribute("data-result", "collided");
  await expect(timeline.command("1")).toHaveAttribute("data-result", "done");

  await timeline.pressCommand("2");
  await expect(timeline.pastLabel).toBeVisible();
  await timeline.expectValueText(/command 2: drive 0\.2 -0\.2 4000 ms, completed$/);
  const row = page.getByRole("row").and(page.locator("[aria-current]"));
  await expect(row).toHaveText(/^2drive 0\.2 -0\.2 4000 ms/);
  await timeline.slider.press("ArrowRight");
  await timeline.expectValueText(/command 3: move 5000, collided$/);
  await timeline.slider.press("ArrowLeft");
  await timeline.slider.press("ArrowLeft");
  await timeline.expectValueText(/command 1: drive 0\.2 -0\.2 4000 ms, completed$/);
});

test("counts a script's driving and waiting time separately", async ({ corridor, page }) => {
  await setSpeed(page, "4");
  const address = await copyAddress(page);
  await expect(corridor.drivingTime).toHaveText("Time 0:00.0 driving");
  await expect(corridor.waitingTime).not.toHaveText(/^0:00/);
  await api(address, "/commands", { action: "right 90" });
  await api(address, "/commands/1?wait=20");
  await expect(corridor.drivingTime).toHaveText(/^Time 0:00\.[1-9]/);
  const driven = (await corridor.drivingTime.textContent()) ?? "";
  const waited = (await corridor.waitingTime.textContent()) ?? "";
  await expect(corridor.waitingTime).not.toHaveText(waited);
  await expect(corridor.drivingTime).toHaveText(driven);
});

test("gives the time of a script's bump in driving seconds of the clock", async ({
  corridor,
  page,
}) => {
  const address = await copyAddress(page);
  await expect(corridor.waitingTime).not.toHaveText(/^0:0[01]/);
  await api(address, "/commands", { action: "move", distance: 5000 });
  const card = page.getByRole("region", { name: "Bump" });
  await expect(card).toContainText(/Bump at \d/);
  const seconds = /Bump at (\d+\.\d) s/.exec((await card.textContent()) ?? "")?.[1];
  await expect(corridor.drivingTime).toHaveText(`Time 0:0${seconds} driving`);
  // The timeline counts as the card and the clock do, and the list marks nothing while now is shown.
  await expect(page.locator("tr[aria-current]")).toHaveCount(0);
  await page.locator('[data-command="1"]').waitFor();
  await corridor.timeline.slider.press("ArrowLeft");
  await corridor.timeline.slider.press("ArrowRight");
  await corridor.timeline.expectValueText(/^\d\.\d s driving, \d+\.\d s waiting, /);
});
