/** Reloading the page in the middle of a run. */
import { expect, test } from "./fixtures.ts";

test("keeps the place, time and bumps of a run across a reload, and continues to the goal", async ({
  corridor,
}) => {
  await corridor.run.click();
  await expect(corridor.clock).toHaveText(/Time 0:0[3-9]\.\d/);
  await corridor.pause.click();
  // The page displays the pause with the tick at which the robot stands.
  await expect(corridor.run).toBeVisible();
  const time = (await corridor.clock.textContent()) ?? "";
  const pose = (await corridor.robotPose.textContent()) ?? "";
  await corridor.reload();
  await expect(corridor.clock).toHaveText(time);
  await expect(corridor.robotPose).toHaveText(pose);
  await expect(corridor.run).toBeVisible();
  await corridor.speed.selectOption("max");
  await corridor.run.click();
  await expect(corridor.runNote).toHaveText(
    "Goal reached after 39.6 s (tick 2380), in row 1, column 11, by “otherwise”.",
  );
});

test("reopens paused, at the same place, after a reload while the robot drives", async ({
  corridor,
}) => {
  await corridor.run.click();
  // The stored state can be some tenths of a second old.
  await expect(corridor.clock).toHaveText(/Time 0:0[3-9]\.\d/);
  await corridor.reload();
  await expect(corridor.run).toBeVisible();
  await expect(corridor.clock).toHaveText(/Time 0:0[2-9]\.\d/);
  await corridor.waitForRobotToStop();
});
