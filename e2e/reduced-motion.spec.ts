/**
 * Motion that is not asked for: the robot's recoil and hop, cards that slide in, anything that
 * moves by itself.
 */
import { expect, test } from "./fixtures.ts";

test("sees a bump and the goal stand still, and can go step by step", async ({
  corridor,
  page,
}) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await corridor.program.action(2).selectOption("delayed left 90");
  await corridor.run.click();
  await expect(corridor.bumpCard(2)).toBeVisible({
    timeout: 30_000,
  });
  // The picture of the robot that has just bumped is the same from frame to frame.
  const { grid } = corridor.maze;
  const first = await grid.screenshot({ animations: "allow" });
  for (let frame = 0; frame < 4; frame++) {
    await corridor.waitForFrames(3);
    expect((await grid.screenshot({ animations: "allow" })).equals(first)).toBe(true);
  }
  const lasting = await page.evaluate(() =>
    document
      .getAnimations()
      .map(({ effect }) => Number(effect?.getComputedTiming().endTime ?? 0))
      .filter((milliseconds) => milliseconds > 1),
  );
  expect(lasting).toEqual([]);

  await corridor.program.action(2).selectOption("left 90");
  await corridor.reset.click();
  await expect(corridor.clock).toHaveText("Time 0:00.0");
  await corridor.step.click();
  await corridor.step.click();
  await expect(corridor.robotPose).not.toHaveText("Robot at 50, 650, facing right");
  await expect(corridor.run).toBeVisible();
});
