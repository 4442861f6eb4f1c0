/** A reader drives by hand: with keys, with the buttons on the screen, into a wall. */
import type { CorridorPage } from "./pages/corridor-page.ts";
import { expect, test } from "./fixtures.ts";

const start = "Robot at 50, 650, facing right";

/** An empty maze at the lowest speed: the far wall is 40 s away, however slow the machine is. */
async function takeTheWheel(corridor: CorridorPage): Promise<void> {
  await corridor.choosePreset("Empty");
  await corridor.speed.selectOption("0.25×");
  await corridor.letDrive("Me");
}

/** Expects that the robot has moved, and that nothing but the driver can have stopped it. */
async function expectStopped(corridor: CorridorPage): Promise<void> {
  await corridor.robotStands();
  await expect(corridor.robotPlace).not.toHaveText(start);
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
    await expect(corridor.robotPlace).toHaveText(moves);
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
  await expect(corridor.robotPlace).not.toHaveText(start);
  await page.mouse.up();
  await expect(corridor.driveKey("forward")).toHaveAttribute("aria-pressed", "false");
  await expectStopped(corridor);

  // The button that has the focus is held with Space.
  const place = await corridor.robotPlace.textContent();
  await corridor.driveKey("left").focus();
  await page.keyboard.down("Space");
  await expect(corridor.robotPlace).toHaveText(/facing up/);
  await page.keyboard.up("Space");
  await corridor.robotStands();
  expect(await corridor.robotPlace.textContent()).not.toBe(place);
});

test("takes over from the program by holding a button", async ({ corridor, page }) => {
  await corridor.choosePreset("Empty");
  await corridor.speed.selectOption("0.25×");
  await corridor.run.click();
  await expect(corridor.pause).toBeVisible();
  await corridor.driveKey("left").hover();
  await page.mouse.down();
  await expect(corridor.driver("Me")).toBeChecked();
  await expect(corridor.robotPlace).toHaveText(/facing up/);
  await page.mouse.up();
  await expectStopped(corridor);
  await expect(corridor.run).toBeVisible();
});

test("stops when the window loses the focus while a key is held", async ({ corridor, page }) => {
  await takeTheWheel(corridor);
  await page.keyboard.down("w");
  await expect(corridor.robotPlace).not.toHaveText(start);
  // Playwright keeps every window focused; this is what the browser tells a page that loses it.
  await page.evaluate(() => window.dispatchEvent(new Event("blur")));
  await expectStopped(corridor);
  await page.keyboard.up("w");
});

test("stops with Space and with Escape", async ({ corridor, page }) => {
  for (const key of ["Space", "Escape"]) {
    await takeTheWheel(corridor);
    await page.keyboard.down("w");
    await expect(corridor.robotPlace).not.toHaveText(start);
    await page.keyboard.press(key);
    await page.keyboard.up("w");
    await expectStopped(corridor);
    await corridor.reset.click();
    await expect(corridor.robotPlace).toHaveText(start);
  }
});

test("types into a field and walks in the maze without driving", async ({ corridor, page }) => {
  await takeTheWheel(corridor);
  await corridor.program.name.focus();
  await page.keyboard.press("End");
  await page.keyboard.down("w");
  await corridor.robotStands();
  await page.keyboard.up("w");
  await expect(corridor.program.name).toHaveValue("Right wallw");
  await corridor.maze.goTo({ column: 3, row: 3 });
  await page.keyboard.down("w");
  await corridor.robotStands();
  await page.keyboard.up("w");
  await corridor.speed.focus();
  await page.keyboard.down("ArrowUp");
  await corridor.robotStands();
  await page.keyboard.up("ArrowUp");
  await expect(corridor.robotPlace).toHaveText(start);
  await expect(corridor.clock).toHaveText("Time 0:00.0");
});

test("presses the drive keys in vain while the program drives", async ({ corridor, page }) => {
  await corridor.choosePreset("Empty");
  await page.keyboard.down("w");
  await corridor.robotStands();
  await page.keyboard.up("w");
  await expect(corridor.robotPlace).toHaveText(start);
  await expect(corridor.driver("Program")).toBeChecked();
});

test("drives into a wall and is told so", async ({ corridor, page }) => {
  await takeTheWheel(corridor);
  await corridor.speed.selectOption("16×");
  await corridor.speed.blur();
  await page.keyboard.down("w");
  // After 615 ticks of 5/3 cm it touches the wall, in the next it pushes.
  await expect(corridor.story).toHaveText(
    /^Bump: you drove into a block at 10\.2 s \(tick 616\), in row 7, column 11\.$/,
  );
  await expect(corridor.bumps).toHaveText("1 bump");
  await expect(corridor.sensor("front")).toHaveText("25");
  await expect(corridor.robotPlace).toHaveText("Robot at 1075, 650, facing right");
  await page.keyboard.up("w");
  await page.keyboard.down("s");
  await expect(corridor.robotPlace).not.toHaveText("Robot at 1075, 650, facing right");
  await page.keyboard.up("s");
});

test("lets a program bump and is told which line it was", async ({ corridor }) => {
  await corridor.program.loadAlgorithm("Back and forth");
  await corridor.program.number(1).fill("10");
  await corridor.run.click();
  await expect(corridor.story).toHaveText(
    /^Bump: “otherwise” drove into a block at 2\.2 s \(tick 13\d\), in row 7, column 3\.$/,
  );
  // A bump of the program pauses it, so that it can be explained.
  await expect(corridor.run).toBeVisible();
  await corridor.program.number(1).fill("300");
  await corridor.program.action(1).selectOption("forward");
  await corridor.reset.click();
  await corridor.run.click();
  await expect(corridor.story).toHaveText(/^Bump: line 1 drove into a block/);
});
