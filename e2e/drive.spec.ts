/** A reader drives by hand: with keys, with the buttons on the screen, into a wall. */
import type { CorridorPage } from "./pages/corridor-page.ts";
import { expect, test } from "./fixtures.ts";

const start = "Robot at 50, 650, facing right";

/** An empty maze: the far wall is 10 s away. */
async function takeTheWheel(corridor: CorridorPage): Promise<void> {
  await corridor.choosePreset("Empty");
  await corridor.selectDriver("Me");
}

/** Expects that the robot has moved, and that nothing but the driver can have stopped it. */
async function expectStopped(corridor: CorridorPage): Promise<void> {
  await corridor.waitForRobotToStop();
  await expect(corridor.robotPose).not.toHaveText(start);
  await expect(corridor.bumps).toHaveText("0 bumps");
  await expect(corridor.sensor("front")).not.toHaveText("25");
}

for (const { key, moves } of [
  { key: "w", moves: /^Robot at (?!50,)\d+, 650, facing right$/ },
  { key: "ArrowUp", moves: /^Robot at (?!50,)\d+, 650, facing right$/ },
  { key: "a", moves: /^Robot at 50, 650, facing up( and right)?$/ },
  { key: "ArrowRight", moves: /^Robot at 50, 650, facing down( and right)?$/ },
]) {
  test(`holds ${key} to drive and lets go to stop`, async ({ corridor, page }) => {
    await takeTheWheel(corridor);
    await page.keyboard.down(key);
    await expect(corridor.robotPose).toHaveText(moves);
    await page.keyboard.up(key);
    await expectStopped(corridor);
  });
}

test("drives back with S and on with W, one key after the other", async ({ corridor, page }) => {
  await takeTheWheel(corridor);
  await page.keyboard.down("w");
  await expect.poll(() => corridor.robotX()).toBeGreaterThan(65);
  await page.keyboard.down("s");
  const turningBack = await corridor.robotX();
  await expect.poll(() => corridor.robotX()).toBeLessThan(turningBack);
  // The newer key is let go: the one that is still held drives again.
  await page.keyboard.up("s");
  const goingOn = await corridor.robotX();
  await expect.poll(() => corridor.robotX()).toBeGreaterThan(goingOn);
  await page.keyboard.up("w");
  await expectStopped(corridor);
});

test("holds the buttons on the screen", async ({ corridor, page }) => {
  await takeTheWheel(corridor);
  await corridor.driveKey("forward").hover();
  await page.mouse.down();
  await expect(corridor.driveKey("forward")).toHaveAttribute("aria-pressed", "true");
  await expect(corridor.robotPose).not.toHaveText(start);
  await page.mouse.up();
  await expect(corridor.driveKey("forward")).toHaveAttribute("aria-pressed", "false");
  await expectStopped(corridor);

  // The button that has the focus is held with Space.
  const place = await corridor.robotPose.textContent();
  await corridor.driveKey("left").focus();
  await page.keyboard.down("Space");
  await expect(corridor.robotPose).toHaveText(/facing up/);
  await page.keyboard.up("Space");
  await corridor.waitForRobotToStop();
  expect(await corridor.robotPose.textContent()).not.toBe(place);
});

test("takes over from the program by holding a button", async ({ corridor, page }) => {
  await corridor.choosePreset("Empty");
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
});

test("stops when the window loses the focus while a key is held", async ({ corridor, page }) => {
  await takeTheWheel(corridor);
  await page.keyboard.down("w");
  await expect(corridor.robotPose).not.toHaveText(start);
  // Playwright keeps every window focused; this is what the browser tells a page that loses it.
  await page.evaluate(() => window.dispatchEvent(new Event("blur")));
  await expectStopped(corridor);
  await page.keyboard.up("w");
});

test("stops with Space and with Escape", async ({ corridor, page }) => {
  for (const key of ["Space", "Escape"]) {
    await takeTheWheel(corridor);
    await page.keyboard.down("w");
    await expect(corridor.robotPose).not.toHaveText(start);
    await page.keyboard.press(key);
    await page.keyboard.up("w");
    await expectStopped(corridor);
    await corridor.reset.click();
    await expect(corridor.robotPose).toHaveText(start);
  }
});

test("types into a field and walks in the maze without driving", async ({ corridor, page }) => {
  await takeTheWheel(corridor);
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
});

for (const key of ["w", "ArrowUp"]) {
  test(`takes over with ${key} on the first screen, and is told so once`, async ({
    corridor,
    page,
  }) => {
    const told = corridor.messages.getByText("You drive now. Press Run to let the program drive");
    const before = await corridor.robotPose.textContent();
    await page.keyboard.press(key, { delay: 120 });
    await expect(corridor.driver("Me")).toBeChecked();
    await expect(corridor.robotPose).not.toHaveText(before ?? "");
    await expect(told).toHaveCount(1);
    await corridor.messages.getByRole("button", { name: "Dismiss" }).click();
    await page.keyboard.press(key, { delay: 120 });
    await corridor.waitForRobotToStop();
    await expect(told).toHaveCount(0);
  });
}

test("takes over from a running program, and the key that is still down does not take it back", async ({
  corridor,
  page,
}) => {
  await corridor.choosePreset("Empty");
  await corridor.run.click();
  await page.keyboard.down("a");
  await expect(corridor.driver("Me")).toBeChecked();
  await expect(corridor.robotPose).toHaveText(/facing up/);
  await corridor.run.click();
  await expect(corridor.driver("Program")).toBeChecked();
  // The keyboard repeats a key that is held.
  await page.keyboard.down("a");
  await expect(corridor.pause).toBeVisible();
  await expect(corridor.driver("Program")).toBeChecked();
  await page.keyboard.up("a");
  await page.keyboard.press("Space");
  await expect(corridor.run).toBeVisible();
  await expect(corridor.driver("Program")).toBeChecked();
});

test("drives into a wall and is told so", async ({ corridor, page }) => {
  await takeTheWheel(corridor);
  await page.keyboard.down("w");
  // After 615 ticks of 5/3 cm it touches the wall, in the next it pushes.
  await expect(corridor.runNote).toHaveText(
    /^Bump: you drove into a block at 10\.2 s \(tick 616\), in row 7, column 11\.$/,
  );
  await expect(corridor.bumps).toHaveText("1 bump");
  await expect(corridor.sensor("front")).toHaveText("25");
  await expect(corridor.robotPose).toHaveText("Robot at 1075, 650, facing right");
  await page.keyboard.up("w");
  await page.keyboard.down("s");
  await expect(corridor.robotPose).not.toHaveText("Robot at 1075, 650, facing right");
  await page.keyboard.up("s");
});

test("lets a program bump and is told which line caused it", async ({ corridor }) => {
  await corridor.program.loadAlgorithm("Back and forth");
  await corridor.program.number(1).fill("10");
  await corridor.run.click();
  await expect(corridor.runNote).toHaveText(
    /^Bump: the program drove into a block at 2\.2 s \(tick 13\d\), in row 7, column 3\.$/,
  );
  // “otherwise” drove, because line 1 was not true in time.
  await expect(corridor.bumpCard(1)).toBeVisible();
  await expect(corridor.program.line(1)).toHaveAccessibleName(/^Line 1, bumped/);
  // A bump of the program pauses it, so that it can be explained.
  await expect(corridor.run).toBeVisible();
  await corridor.program.number(1).fill("300");
  await corridor.program.action(1).selectOption("forward");
  await corridor.reset.click();
  await corridor.run.click();
  await expect(corridor.runNote).toHaveText(/^Bump: the program drove into a block/);
  // No line is blamed where one is missing, but the line that decided is named.
  await expect(corridor.page.getByRole("region", { name: "Bump", exact: true })).toContainText(
    "line 1 chose “forward”. A line for this place is missing.",
  );
  await expect(corridor.program.line(1)).not.toHaveAccessibleName(/bumped/);
});

test("only the reading of what was touched is red", async ({ corridor, page }) => {
  await takeTheWheel(corridor);
  const ground = (name: "front" | "right" | "back" | "left") =>
    corridor.sensor(name).evaluate((reading) => getComputedStyle(reading).backgroundColor);
  const calm = await ground("left");
  await page.keyboard.down("s");
  await expect(corridor.bumps).toHaveText("1 bump");
  await expect.poll(() => ground("back")).not.toBe(calm);
  expect(await ground("front")).toBe(calm);
  await page.keyboard.up("s");

  await page.keyboard.down("d");
  await expect(corridor.robotPose).toHaveText(/facing down and right$/);
  await page.keyboard.up("d");
  await page.keyboard.down("w");
  await expect(corridor.bumps).toHaveText("2 bumps");
  // The wall was met beside the beam ahead, which ends farther along it.
  await expect.poll(() => ground("back")).toBe(calm);
  for (const name of ["front", "right", "left"] as const) expect(await ground(name)).toBe(calm);
});
