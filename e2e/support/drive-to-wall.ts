/** Drives by hand with keys until `front` reads a distance. */
import { expect } from "playwright/test";
import type { CorridorPage } from "../pages/corridor-page.ts";

/** More than the page rounds by: it shows 170.0 for 170.01, which is above 170 for a task. */
const ROUNDING_CM = 1;
/** Half of the time that the robot needs for one cm, because a busy machine releases keys late. */
const MS_PER_CM = 5;

/** @param from @param to range of the reading, in cm */
export async function driveToWall(corridor: CorridorPage, from: number, to: number): Promise<void> {
  await expect(async () => {
    await corridor.waitForRobotToStop();
    const front = Number(await corridor.sensor("front").textContent());
    const missing = front - (from + to) / 2;
    const isInside = front >= from + ROUNDING_CM && front <= to - ROUNDING_CM;
    if (!isInside) {
      const delay = Math.max(20, Math.abs(missing) * MS_PER_CM);
      await corridor.page.keyboard.press(missing > 0 ? "w" : "s", { delay });
    }
    expect(isInside).toBe(true);
  }).toPass({ timeout: 45_000, intervals: [20] });
}
