/** Driving by hand: with keys, with the on-screen buttons, into a wall. */
import { CorridorPage } from "./pages/corridor-page.ts";
import { expect, test } from "./fixtures.ts";
import { clearStorageOnLoad } from "./support/clear-storage.ts";
import { smallWindow } from "./support/window-sizes.ts";
import { withMotion } from "./support/with-motion.ts";

test.use({ ...withMotion, ...smallWindow });

const start = "Robot at 50, 650, facing right";

/** Opens an empty maze, whose far wall is 10 s ahead, and selects Me. */
async function driveInEmptyMaze(corridor: CorridorPage): Promise<void> {
  await corridor.choosePreset("Empty");
  await corridor.selectDriver("Me");
}

/** Expects that the robot has moved, and that only the driver can have stopped it. */
async function expectStopped(corridor: CorridorPage): Promise<void> {
  await corridor.waitForRobotToStop();
  await expect(corridor.robotPose).not.toHaveText(start);
  await expect(corridor.bumps).toHaveText("0 bumps");
  await expect(corridor.sensor("front")).not.toHaveText("25");
}

/** The robot is at its start again, and the user still drives. */
async function returnToStart(corridor: CorridorPage): Promise<void> {
  await corridor.reset.click();
  await expect(corridor.robotPose).toHaveText(start);
  await corridor.selectDriver("Me");
}

async function drivesWhileKeyIsHeld(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  await driveInEmptyMaze(corridor);
  for (const { key, moves } of [
    { key: "w", moves: /^Robot at (?!50,)\d+, 650, facing right$/ },
    { key: "ArrowUp", moves: /^Robot at (?!50,)\d+, 650, facing right$/ },
    { key: "a", moves: /^Robot at 50, 650, facing up( and right)?$/ },
    { key: "ArrowRight", moves: /^Robot at 50, 650, facing down( and right)?$/ },
  ]) {
    await page.keyboard.down(key);
    await expect(corridor.robotPose).toHaveText(moves);
    await page.keyboard.up(key);
    await expectStopped(corridor);
    await returnToStart(corridor);
  }
  for (const key of ["Space", "Escape"]) {
    await page.keyboard.down("w");
    await expect(corridor.robotPose).not.toHaveText(start);
    await page.keyboard.press(key);
    await page.keyboard.up("w");
    await expectStopped(corridor);
    await returnToStart(corridor);
  }
  await page.keyboard.down("w");
  await expect(corridor.robotPose).not.toHaveText(start);
  // Playwright keeps every window focused, so dispatch the event of a window that loses the focus.
  await page.evaluate(() => window.dispatchEvent(new Event("blur")));
  await expectStopped(corridor);
  await page.keyboard.up("w");
}

async function drivesByKeyAfterClick(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  await corridor.choosePreset("Empty");
  await corridor.selectDriver("Program");
  await corridor.driver("Program").click();
  await expect(corridor.driver("Program")).toBeFocused();
  await page.keyboard.down("ArrowUp");
  await expect(corridor.robotPose).not.toHaveText(start);
  await page.keyboard.up("ArrowUp");
  await expectStopped(corridor);
  await returnToStart(corridor);

  const me = corridor.driver("Me");
  await page.keyboard.press("Shift+Tab");
  await page.keyboard.press("Tab");
  await me.focus();
  await page.keyboard.press("ArrowRight");
  await expect(me).not.toBeChecked();
  await expect(corridor.robotPose).toHaveText(start);

  await corridor.selectDriver("Me");
  await corridor.speed.click();
  await page.keyboard.press("ArrowDown");
  await page.keyboard.press("Enter");
  await expect(corridor.speed).not.toHaveValue("1");
  await page.keyboard.down("w");
  await expect(corridor.robotPose).not.toHaveText(start);
  await page.keyboard.up("w");
  await expectStopped(corridor);

  await returnToStart(corridor);
  await corridor.program.name.focus();
  await page.keyboard.press("End");
  await page.keyboard.down("w");
  await corridor.waitForRobotToStop();
  await page.keyboard.up("w");
  await expect(corridor.program.name).toHaveValue("w");
  await corridor.maze.moveCursorTo({ column: 3, row: 3 });
  await page.keyboard.down("w");
  await corridor.waitForRobotToStop();
  await page.keyboard.up("w");
  await corridor.speed.focus();
  await page.keyboard.down("ArrowUp");
  await corridor.waitForRobotToStop();
  await page.keyboard.up("ArrowUp");
  await expect(corridor.robotPose).toHaveText(start);
  await expect(corridor.clock).toHaveText("Time 0:00.0");
}

async function drivesBackward(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  await driveInEmptyMaze(corridor);
  await page.keyboard.down("w");
  // Far enough from the wall behind that a slow machine sees the robot reverse before it bumps.
  await expect.poll(() => corridor.robotX()).toBeGreaterThan(300);
  await page.keyboard.down("s");
  const xAtReverse = await corridor.robotX();
  await expect.poll(() => corridor.robotX()).toBeLessThan(xAtReverse);
  // After the newer key is released, the key that is still held drives again.
  await page.keyboard.up("s");
  const xAtForward = await corridor.robotX();
  await expect.poll(() => corridor.robotX()).toBeGreaterThan(xAtForward);
  await page.keyboard.up("w");
  await expectStopped(corridor);
}

async function takesOverFromProgram(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  await driveInEmptyMaze(corridor);
  await corridor.driveKey("forward").hover();
  await page.mouse.down();
  await expect(corridor.driveKey("forward")).toHaveAttribute("aria-pressed", "true");
  await expect(corridor.robotPose).not.toHaveText(start);
  await page.mouse.up();
  await expect(corridor.driveKey("forward")).toHaveAttribute("aria-pressed", "false");
  await expectStopped(corridor);

  // Space holds the focused button.
  const place = await corridor.robotPose.textContent();
  await corridor.driveKey("left").focus();
  await page.keyboard.down("Space");
  await expect(corridor.robotPose).toHaveText(/facing up/);
  await page.keyboard.up("Space");
  await corridor.waitForRobotToStop();
  expect(await corridor.robotPose.textContent()).not.toBe(place);

  // The program is driving.
  await corridor.reset.click();
  await expect(corridor.robotPose).toHaveText(start);
  await corridor.speed.selectOption("0.25×");
  await corridor.run.click();
  await expect(corridor.pause).toBeVisible();
  await corridor.driveKey("left").hover();
  await page.mouse.down();
  await expect(corridor.driver("Me")).toBeChecked();
  await expect(corridor.robotPose).toHaveText(/facing up/);
  await page.mouse.up();
  await expectStopped(corridor);
  await expect(corridor.run).toBeVisible();

  await corridor.reset.click();
  await expect(corridor.robotPose).toHaveText(start);
  await corridor.speed.selectOption("1×");
  // A robot that turns on the spot does not bump before the test has seen it.
  await corridor.program.otherwise.selectOption("left 90");
  await corridor.run.click();
  await page.keyboard.down("a");
  await expect(corridor.driver("Me")).toBeChecked();
  await expect(corridor.robotPose).toHaveText(/facing up/);
  await corridor.run.click();
  await expect(corridor.driver("Program")).toBeChecked();
  // The keyboard repeats a held key.
  await page.keyboard.down("a");
  await expect(corridor.pause).toBeVisible();
  await expect(corridor.driver("Program")).toBeChecked();
  await page.keyboard.up("a");
  await page.keyboard.press("Space");
  await expect(corridor.run).toBeVisible();
  await expect(corridor.driver("Program")).toBeChecked();
}

async function takesOverOnFirstScreen(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  for (const key of ["w", "ArrowUp"]) {
    await corridor.open();
    const takeoverMessage = corridor.messages.getByText(
      "You are driving now. Press Run to let the program drive",
    );
    const before = await corridor.robotPose.textContent();
    await page.keyboard.press(key, { delay: 120 });
    await expect(corridor.driver("Me")).toBeChecked();
    await expect(corridor.robotPose).not.toHaveText(before ?? "");
    await expect(takeoverMessage).toHaveCount(1);
    await corridor.messages.getByRole("button", { name: "Dismiss" }).click();
    await page.keyboard.press(key, { delay: 120 });
    await corridor.waitForRobotToStop();
    await expect(takeoverMessage).toHaveCount(0);
  }
}

async function reportsBumpOfDriver(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  await corridor.speed.selectOption("16×");
  await driveInEmptyMaze(corridor);
  await page.keyboard.down("w");
  // It touches the wall after 615 ticks of 5/3 cm, and pushes in the next tick.
  await expect(corridor.runNote).toHaveText(
    /^Bump: you drove into a block at 10\.2 s \(tick 616\)\. The robot was in row 7, column 11\.$/,
  );
  await expect(corridor.bumps).toHaveText("1 bump");
  await expect(corridor.sensor("front")).toHaveText("25");
  await expect(corridor.robotPose).toHaveText("Robot at 1075, 650, facing right");
  await page.keyboard.up("w");
  await page.keyboard.down("s");
  await expect(corridor.robotPose).not.toHaveText("Robot at 1075, 650, facing right");
  await page.keyboard.up("s");

  await corridor.speed.selectOption("1×");
  await returnToStart(corridor);
  const background = (name: "front" | "right" | "back" | "left") =>
    corridor.sensor(name).evaluate((reading) => getComputedStyle(reading).backgroundColor);
  const normal = await background("left");
  await page.keyboard.down("s");
  await expect(corridor.bumps).toHaveText("1 bump");
  await expect.poll(() => background("back")).not.toBe(normal);
  expect(await background("front")).toBe(normal);
  await page.keyboard.up("s");

  // A busy machine releases the key late, and the robot turns farther.
  await expect(async () => {
    await page.keyboard.press("d", { delay: 20 });
    await corridor.waitForRobotToStop();
    expect(await corridor.robotPose.textContent()).toMatch(/facing down and right$/);
  }).toPass({ timeout: 45_000, intervals: [20] });
  await page.keyboard.down("w");
  await expect(corridor.bumps).toHaveText("2 bumps");
  // The contact point is beside the front beam, which ends farther along the wall.
  await expect.poll(() => background("back")).toBe(normal);
  for (const name of ["front", "right", "left"] as const)
    expect(await background(name)).toBe(normal);
}

async function reportsLineOfBump(corridor: CorridorPage): Promise<void> {
  const { program } = corridor;
  await corridor.choosePreset("Long way round");
  await program.deleteAllLines();
  await program.addLine("front <", "10", "turn 180");
  await program.otherwise.selectOption("forward");
  await corridor.speed.selectOption("max");
  await corridor.run.click();
  await expect(corridor.runNote).toHaveText(
    /^Bump: the program drove into a block at 2\.2 s \(tick 13\d\)\. The robot was in row 7, column 3\.$/,
  );
  // “otherwise” drove because line 1 became true too late.
  await expect(corridor.bumpCard(1)).toBeVisible();
  await expect(program.line(1)).toHaveAccessibleName(/^Line 1, look here/);
  // A bump of the program pauses the run, so that its card can explain the bump.
  await expect(corridor.run).toBeVisible();
  await program.number(1).fill("300");
  await program.action(1).selectOption("forward");
  await corridor.reset.click();
  await corridor.run.click();
  await expect(corridor.runNote).toHaveText(/^Bump: the program drove into a block/);
  // No line is marked when a line is missing, but the text names the line that decided.
  await expect(corridor.page.getByRole("region", { name: "Bump", exact: true })).toContainText(
    "line 1 chose “forward”. A line for this place is missing.",
  );
  await expect(program.line(1)).not.toHaveAccessibleName(/look here/);
}

test("drives by hand, and explains bumps", async ({ page }) => {
  const corridor = new CorridorPage(page);
  const step = (title: string, check: (page: CorridorPage) => Promise<void>) =>
    test.step(title, async () => {
      await check(corridor);
      await corridor.reset.click();
      await corridor.dismissMessages();
      await corridor.speed.selectOption("1");
    });
  await clearStorageOnLoad(page);
  await step(
    "takes over with w or an arrow key on the first screen, with one message",
    takesOverOnFirstScreen,
  );
  await step(
    "drives while a key is held, and stops on release, Space, Escape or when the window loses the focus",
    drivesWhileKeyIsHeld,
  );
  await step(
    "drives by key after a click on a driver or a speed, but not with a driver that was reached with Tab, in a field or on the maze",
    drivesByKeyAfterClick,
  );
  await step("drives backward with S and forward with W, one key after the other", drivesBackward);
  await step(
    "drives while an on-screen button is held, and takes over from a running program by button and by key, which takes over once",
    takesOverFromProgram,
  );
  await step(
    "reports a bump when the driver drives into a wall, and marks only the reading of the touched side in red",
    reportsBumpOfDriver,
  );
  await step("reports which line caused a bump of the program", reportsLineOfBump);
});
