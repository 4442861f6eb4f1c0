/**
 * Going back in a run: to any tick, decision by decision, resuming from there, by link and by file.
 */
import { readFile } from "node:fs/promises";
import { readRun } from "@corridor/recording";
import type { CorridorPage } from "./pages/corridor-page.ts";
import { expect, test } from "./fixtures.ts";
import { smallWindow } from "./support/window-sizes.ts";

test.use(smallWindow);

/**
 * Runs a program that turns too late: "otherwise" hits the wall after about two seconds and drives
 * on.
 */
async function bump(corridor: CorridorPage): Promise<void> {
  await corridor.program.loadAlgorithm("Back and forth");
  await corridor.program.number(1).fill("10");
  await corridor.speed.selectOption("4×");
  await corridor.run.click();
  await expect(corridor.bumps).toHaveText("1 bump");
  // The run pauses at the bump. A second Run continues.
  await corridor.run.click();
  await expect(corridor.clock).toHaveText(/0:(0[5-9]|[1-9]\d)/);
  await corridor.pause.click();
  await expect(corridor.run).toBeVisible();
}

/**
 * Steps through a few turns of the right-wall program. A step pauses by itself: after Run, a slow
 * machine can reach the goal before the test presses Pause.
 */
async function turnSomeTimes(corridor: CorridorPage): Promise<void> {
  await corridor.speed.selectOption("8×");
  while ((await corridor.timeline.mark("turn").count()) < 3) {
    const before = (await corridor.clock.textContent()) ?? "";
    await corridor.step.click();
    await expect(corridor.clock).not.toHaveText(before);
    await expect(corridor.run).toBeVisible();
  }
}

test("scrubs back from a bump, runs from there with a fixed line, and drives on by hand", async ({
  corridor,
  page,
}) => {
  const { timeline, program } = corridor;
  await bump(corridor);

  await test.step("shows the robot, sensors, truth values and line of that tick", async () => {
    await timeline.mark("bump").click();
    await expect(timeline.pastLabel).toBeVisible();
    await expect(
      corridor.page.getByRole("group", { name: "You see an earlier moment of this run." }),
    ).toContainText("Back to now");
    await expect(corridor.clock).toHaveText("Time 0:02.2");
    await expect(corridor.robotPose).toHaveText("Robot at 275, 650, facing right");
    await expect(corridor.sensor("front")).toHaveText("25");
    await expect(corridor.bumps).toHaveText("1 bump");
    await expect(program.line(1)).toHaveAccessibleName(/Front is 25, false\./);
    await expect(program.region.locator("[aria-current=step]")).toContainText("otherwise");
    await timeline.expectValueText(/^2\.2 s, “otherwise” drives, bump$/);
    // Before the bump, the robot had space.
    await timeline.drag(0.07, 0.04);
    await expect(corridor.bumps).toHaveText("0 bumps");
    await expect(corridor.clock).toHaveText(/^Time 0:01\./);
  });

  await timeline.backToNow.click();
  await expect(timeline.pastLabel).toBeHidden();
  await test.step("replays the run to its end", async () => {
    const now = await corridor.clock.textContent();
    await timeline.drag(0.1, 0.02);
    await timeline.watch.click();
    await expect(corridor.clock).toHaveText(now ?? "");
    await expect(timeline.pastLabel).toBeHidden();
  });

  await test.step("runs from an earlier tick with a fixed line", async () => {
    await timeline.drag(0.1, 0.04);
    await expect(corridor.bumps).toHaveText("0 bumps");
    await expect(corridor.clock).toHaveText(/^Time 0:01\./);
    await corridor.program.number(1).fill("50");
    await timeline.runFromHere.click();
    await expect(corridor.pause).toBeVisible();
    await expect(corridor.clock).toHaveText(/0:0[89]|0:[1-5]\d/);
    await expect(corridor.bumps).toHaveText("0 bumps");
    await expect(timeline.mark("bump")).toHaveCount(0);
    await expect(timeline.mark("turn").first()).toBeVisible();
  });

  await corridor.pause.click();
  await expect(corridor.run).toBeVisible();
  await test.step("continues by manual driving from the middle", async () => {
    await timeline.drag(0.1, 0.04);
    await expect(corridor.clock).toHaveText(/^Time 0:01\./);
    await expect(corridor.bumps).toHaveText("0 bumps");
    await corridor.driveKey("left").hover();
    await page.mouse.down();
    await expect(corridor.driver("Me")).toBeChecked();
    await expect(corridor.robotPose).toHaveText(/facing up/);
    await page.mouse.up();
    await expect(timeline.pastLabel).toBeHidden();
    await expect(corridor.bumps).toHaveText("0 bumps");
  });
});

test("goes back decision by decision, and returns to now", async ({
  corridor,
  page,
  openWindow,
}) => {
  const { maze, timeline } = corridor;

  await test.step("the scale is hidden completely beside the button that returns to now", async () => {
    await page.setViewportSize({ width: 1024, height: 768 });
    const scale = page.getByText("1 block = 100 cm");
    await expect(scale).toBeVisible();
    await turnSomeTimes(corridor);
    await timeline.slider.press("Home");
    await expect(timeline.pastLabel).toBeVisible();
    await expect(scale).toBeHidden();
    await page.getByRole("button", { name: "Back to now" }).click();
    await expect(scale).toBeVisible();
    await page.setViewportSize(smallWindow.viewport);
  });

  await test.step("by keyboard", async () => {
    const now = await corridor.clock.textContent();
    await timeline.slider.focus();
    await expect
      .poll(async () => {
        await page.keyboard.press("ArrowLeft");
        await corridor.waitForFrames(3);
        return timeline.slider.getAttribute("aria-valuetext");
      })
      .toMatch(/^\d+\.\d s, line 1 drives, delayed right 90$|, line 2 drives, left 90$/);
    await expect(timeline.pastLabel).toBeVisible();
    const decision = await timeline.slider.getAttribute("aria-valuetext");
    await page.keyboard.press("ArrowLeft");
    await timeline.expectValueText(/“otherwise” drives$/);
    await page.keyboard.press("ArrowRight");
    await expect(timeline.slider).toHaveAttribute("aria-valuetext", decision ?? "");
    await page.keyboard.press("Home");
    await expect(corridor.clock).toHaveText("Time 0:00.0");
    await expect(corridor.robotPose).toHaveText("Robot at 50, 650, facing right");
    await page.keyboard.press("End");
    await expect(corridor.clock).toHaveText(now ?? "");
    await expect(timeline.pastLabel).toBeHidden();
  });

  await test.step("with the buttons, and forward again", async () => {
    const back = async (): Promise<string> => {
      const before = (await corridor.clock.textContent()) ?? "";
      await timeline.previousDecision.click();
      await expect(corridor.clock).not.toHaveText(before);
      return (await corridor.clock.textContent()) ?? "";
    };
    // If the run stopped right after its newest decision, both have the same displayed time.
    await timeline.previousDecision.click();
    await expect(timeline.pastLabel).toBeVisible();
    const decision = await back();
    await back();
    await corridor.step.click();
    await expect(corridor.clock).toHaveText(decision);
    await expect(timeline.pastLabel).toBeVisible();
  });

  await timeline.backToNow.click();
  await expect(timeline.pastLabel).toBeHidden();
  await test.step("by dragging, and back to now", async () => {
    const pose = await corridor.robotPose.textContent();
    const now = await corridor.clock.textContent();
    await timeline.drag(0.2, 0.1);
    await expect(timeline.pastLabel).toBeVisible();
    await expect(timeline.runFromHere).toBeVisible();
    await expect(corridor.robotPose).not.toHaveText(pose ?? "");
    await timeline.backToNow.click();
    await expect(timeline.pastLabel).toBeHidden();
    await expect(corridor.clock).toHaveText(now ?? "");
    await expect(corridor.robotPose).toHaveText(pose ?? "");
    await expect(corridor.run).toBeVisible();
  });

  await test.step("saves the run as a file, and shares it by link: another user replays it", async () => {
    const now = (await corridor.clock.textContent()) ?? "";
    const pose = (await corridor.robotPose.textContent()) ?? "";
    await corridor.share.click();
    await corridor
      .dialog("Share this maze")
      .getByRole("checkbox", { name: /^This run/ })
      .check();
    const dialog = corridor.dialog("Share this run");
    const link = await dialog.getByRole("textbox", { name: "Link" }).inputValue();
    expect(link.length).toBeLessThan(200);
    const saving = page.waitForEvent("download");
    await dialog.getByRole("button", { name: "Save run" }).click();
    const file = await saving;
    expect(file.suggestedFilename()).toBe("long-way-round.run.json");
    const read = readRun(await readFile(await file.path(), "utf8"));
    expect(read).toMatchObject({ ok: true, value: { name: "Long way round" } });
    await page.keyboard.press("Escape");

    const recipient = await openWindow(smallWindow);
    await recipient.open(link);
    await expect(recipient.message(/^A recorded run/)).toBeVisible();
    await expect(recipient.timeline.pastLabel).toBeVisible();
    await expect(recipient.clock).toHaveText("Time 0:00.0");
    await recipient.speed.selectOption("8×");
    await recipient.timeline.watch.click();
    await expect(recipient.timeline.pastLabel).toBeHidden();
    await expect(recipient.clock).toHaveText(now);
    await expect(recipient.robotPose).toHaveText(pose);
    await expect(recipient.program.name).toHaveValue("Example: right wall");
  });

  await test.step("lays out an earlier tick by the maze of that tick", async () => {
    // In smaller windows, the button is in a menu.
    await page.setViewportSize({ width: 1440, height: 900 });
    const columns = Number(await maze.grid.getAttribute("aria-colcount"));
    await maze.button("Resize").click();
    const dialog = corridor.dialog("Resize the maze");
    await dialog.getByRole("textbox", { name: "Columns" }).fill(String(columns + 30));
    await dialog.getByRole("button", { name: "Resize maze" }).click();
    await expect(maze.grid).toHaveAttribute("aria-colcount", String(columns + 30));
    // Not Run and Pause: a slow machine can reach the goal between both.
    const now = (await corridor.clock.textContent()) ?? "";
    await corridor.step.click();
    await expect(corridor.clock).not.toHaveText(now);
    await expect(corridor.run).toBeVisible();
    await timeline.drag(0.3, 0.1);
    await expect(timeline.pastLabel).toBeVisible();
    await expect(maze.grid).toHaveAttribute("aria-colcount", String(columns));
    await timeline.backToNow.click();
    await expect(maze.grid).toHaveAttribute("aria-colcount", String(columns + 30));
    await page.setViewportSize(smallWindow.viewport);
  });

  await test.step("an edit before a run leaves no mark over the sentence that says how to start", async () => {
    await corridor.reset.click();
    await corridor.program.number(1).fill("70");
    await expect(corridor.page.getByText("Run starts the program.")).toBeVisible();
    await expect(corridor.timeline.slider).toBeAttached();
    for (const kind of ["edit", "turn"] as const) {
      await expect(corridor.timeline.mark(kind)).toHaveCount(0);
    }
  });
});

test("goes back with a finger on a phone, where nothing moves while the controls of the past load", async ({
  openWindow,
}) => {
  const viewport = { width: 390, height: 844 };
  const phone = await openWindow({ viewport, hasTouch: true, isMobile: true });
  let load = (): void => {};
  const isLoading = new Promise<void>((resolve) => (load = resolve));
  await phone.page.route(/\/assets\/(PastControls|RaceIconButton)-[^/]*\.js$/, async (route) => {
    await isLoading;
    await route.continue();
  });
  await phone.open();
  const { timeline } = phone;
  await expect(timeline.slider).not.toBeInViewport();
  await turnSomeTimes(phone);
  expect((await timeline.slider.boundingBox())?.height).toBeGreaterThanOrEqual(44);
  const view = phone.page.getByRole("button", { name: "View", exact: true });
  const top = async () => [(await timeline.slider.boundingBox())?.y, (await view.boundingBox())?.y];
  const now = await top();
  const { x, y } = await timeline.pointAt(0.1);
  await phone.page.touchscreen.tap(x, y);
  await expect(timeline.pastLabel).toBeVisible();
  await expect(timeline.runFromHere).toBeVisible();
  expect(await top()).toEqual(now);
  load();
  await expect(timeline.backToNow).toBeVisible();
  await expect(phone.page.getByRole("button", { name: "Race this run" })).toBeVisible();
  expect(await top()).toEqual(now);
  await timeline.backToNow.tap();
  await expect(timeline.pastLabel).toBeHidden();
});
