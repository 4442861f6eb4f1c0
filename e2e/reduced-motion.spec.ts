/**
 * Reduced motion disables the robot's recoil and hop, sliding cards and all other automatic
 * animation.
 */
import { expect, test } from "./fixtures.ts";
import { withMotion } from "./support/with-motion.ts";

test.use(withMotion);

test("does not animate a bump or the goal, and allows single steps", async ({ corridor, page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await corridor.program.action(2).selectOption("delayed left 90");
  await corridor.run.click();
  await expect(corridor.bumpCard(2)).toBeVisible({
    timeout: 30_000,
  });
  // The picture of the robot at a bump is the same in every frame.
  const { grid } = corridor.maze;
  const first = await grid.screenshot({ animations: "allow" });
  for (let frame = 0; frame < 4; frame++) {
    await corridor.waitForFrames(3);
    expect((await grid.screenshot({ animations: "allow" })).equals(first)).toBe(true);
  }
  const longAnimations = await page.evaluate(() =>
    document
      .getAnimations()
      .map(({ effect }) => Number(effect?.getComputedTiming().endTime ?? 0))
      .filter((milliseconds) => milliseconds > 1),
  );
  expect(longAnimations).toEqual([]);

  await corridor.program.action(2).selectOption("left 90");
  await corridor.reset.click();
  await expect(corridor.clock).toHaveText("Time 0:00.0");
  await corridor.step.click();
  await corridor.step.click();
  await expect(corridor.robotPose).not.toHaveText("Robot at 50, 650, facing right");
  await expect(corridor.run).toBeVisible();
});
