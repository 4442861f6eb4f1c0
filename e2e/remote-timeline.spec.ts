/** The timeline and the clock of a run that a script drives. */
import { expect, test } from "./fixtures.ts";
import type { CorridorPage } from "./pages/corridor-page.ts";
import { api, copyAddress, setSpeed } from "./support/remote-robot.ts";
import { smallWindow } from "./support/window-sizes.ts";

test.use(smallWindow);

/** turns on the spot for four seconds */
const spin = { action: "drive", left: 0.2, right: -0.2, milliseconds: 4000 };

async function numbersCommands(corridor: CorridorPage, address: string): Promise<void> {
  const { page } = corridor;
  const { timeline } = corridor;
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
}

async function countsWaitingSeparately(corridor: CorridorPage, address: string): Promise<void> {
  await expect(corridor.drivingTime).toHaveText("Time 0:00.0 driving");
  await expect(corridor.waitingTime).not.toHaveText(/^0:00/);
  const { seq } = await (await api(address, "/commands", { action: "right 90" })).json();
  await api(address, `/commands/${seq}?wait=20`);
  await expect(corridor.drivingTime).toHaveText(/^Time 0:00\.[1-9]/);
  // The page may still display the turn. It is over once time is counted as waiting.
  await expectToWait(corridor);
  const driven = (await corridor.drivingTime.textContent()) ?? "";
  await expectToWait(corridor);
  await expect(corridor.drivingTime).toHaveText(driven);
}

/** Expects the clock to count more time as waiting. */
async function expectToWait({ waitingTime }: CorridorPage): Promise<void> {
  const waited = (await waitingTime.textContent()) ?? "";
  await expect(waitingTime).not.toHaveText(waited);
}

async function givesTimeOfBump(corridor: CorridorPage, address: string): Promise<void> {
  const { page } = corridor;
  await expect(corridor.waitingTime).not.toHaveText(/^0:0[01]/);
  const { seq } = await (
    await api(address, "/commands", { action: "move", distance: 5000 })
  ).json();
  const card = page.getByRole("region", { name: "Bump" });
  await expect(card).toContainText(/Bump at \d/);
  const seconds = /Bump at (\d+\.\d) s/.exec((await card.textContent()) ?? "")?.[1];
  await expect(corridor.drivingTime).toHaveText(`Time 0:0${seconds} driving`);
  // The timeline counts as the card and the clock do, and the list marks nothing while now is shown.
  await expect(page.locator("tr[aria-current]")).toHaveCount(0);
  await corridor.timeline.command(seq).waitFor();
  await corridor.timeline.slider.press("ArrowLeft");
  await corridor.timeline.slider.press("ArrowRight");
  await corridor.timeline.expectValueText(/^\d\.\d s driving, \d+\.\d s waiting, /);
}

test("shows a run that a script drives on the timeline and the clock", async ({
  corridor,
  page,
}) => {
  await setSpeed(page, "4");
  const address = await copyAddress(page);
  await test.step("numbers the commands of a script with their results, and displays a selected command", () =>
    numbersCommands(corridor, address));
  await corridor.timeline.backToNow.click();
  await corridor.reset.click();
  await test.step("counts a script's driving and waiting time separately", () =>
    countsWaitingSeparately(corridor, address));
  await corridor.reset.click();
  await setSpeed(page, "1");
  await test.step("gives the time of a script's bump in driving seconds of the clock", () =>
    givesTimeOfBump(corridor, address));
});
