/**
 * The page is accessible: no axe violations, usable by keyboard alone and by touch, on any screen
 * size.
 */
import type { Locator, Page } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import type { CorridorPage } from "./pages/corridor-page.ts";
import { LessonsPanel } from "./pages/lessons-panel.ts";
import { expectNoAxeViolations } from "./support/axe.ts";
import { horizontalOverflow, smallTouchTargets } from "./support/layout.ts";
import { phone, tab } from "./support/phone.ts";
import { openMoreSection } from "./support/remote-panel.ts";
import { wideWindow } from "./support/window-sizes.ts";

// Axe needs as long in any window, but the page is painted again for each theme.
test.use(wideWindow);

test("has no axe violations in the program, with advice, at a bump, in the past, at the goal, in dialogs, menus and messages", async ({
  corridor,
  page,
}) => {
  test.slow();
  await test.step("program and run", async () => {
    await expectNoAxeViolations(page, "first visit");
    await corridor.program.button("Add line").click();
    await corridor.program.number(1).fill("x");
    await corridor.program.condition(3).selectOption("left > right +");
    await expectNoAxeViolations(page, "a wrong number and a comparison");
    await corridor.program.number(1).fill("60");
    await corridor.program.button("Delete line 3").click();
    await corridor.dismissMessages();
    await corridor.program.action(2).selectOption("delayed left 90");
    await expect(corridor.announcement).toContainText("Advice for line 2");
    await expectNoAxeViolations(page, "advice");
    await corridor.speed.selectOption("max");
    await corridor.run.click();
    await expect(corridor.runNote).toContainText("Bump");
    await page.getByRole("region", { name: "Bump: look at line 2" }).waitFor();
    await expectNoAxeViolations(page, "bump card");
    await corridor.timeline.slider.focus();
    await page.keyboard.press("ArrowLeft");
    await corridor.timeline.pastLabel.waitFor();
    await page.keyboard.press("i");
    await corridor.message(/^At \d/).waitFor();
    await expectNoAxeViolations(page, "in the past, described");
    await corridor.timeline.backToNow.click();
    await corridor.program.action(2).selectOption("left 90");
    await corridor.reset.click();
    await corridor.run.click();
    await page.getByRole("region", { name: "Solved!" }).waitFor();
    await expectNoAxeViolations(page, "solved card");
    await corridor.reset.click();
    // The card has a Share button of its own.
    await page.getByRole("region", { name: "Solved!" }).waitFor({ state: "hidden" });
  });
  await test.step("dialogs, menus and messages", async () => {
    await corridor.dismissMessages();
    await corridor.share.click();
    await corridor.dialog("Share this maze").waitFor();
    await expectNoAxeViolations(page, "share");
    await page.keyboard.press("Escape");
    await page.getByRole("button", { name: "Keyboard shortcuts" }).click();
    await corridor.dialog("Keyboard shortcuts").waitFor();
    await expectNoAxeViolations(page, "shortcuts");
    await page.keyboard.press("Escape");
    await corridor.maze.button("Clear maze").click();
    await corridor.dialog("Clear this maze?").waitFor();
    await expectNoAxeViolations(page, "clear");
    await page.keyboard.press("Escape");
    await corridor.maze.button("Resize").click();
    await corridor.dialog("Resize the maze").getByRole("textbox", { name: "Rows" }).fill("0");
    await expectNoAxeViolations(page, "resize");
    await page.keyboard.press("Escape");
    for (const menu of ["View", "Show an algorithm", "Theme", "Presets", "Maze menu"]) {
      const opener =
        menu === "Maze menu"
          ? corridor.mazeMenu
          : page.getByRole("button", { name: menu, exact: true });
      await opener.click();
      await corridor.dialog(menu).waitFor();
      await expectNoAxeViolations(page, menu);
      await page.keyboard.press("Escape");
      await corridor.dialog(menu).waitFor({ state: "hidden" });
    }
    await page.evaluate(() => (location.hash = "1cut"));
    await corridor.message("A part of this link is missing.").waitFor();
    await expectNoAxeViolations(page, "message");
  });
});

test("has no axe violations in Me and Remote, in a mission, while measuring, among random mazes and pictures", async ({
  corridor,
  page,
}) => {
  test.slow();
  await corridor.selectDriver("Me");
  await expectNoAxeViolations(page, "Me");
  await corridor.selectDriver("Remote");
  await expect(corridor.connectionStatus).toHaveText("Waiting for a script");
  await expectNoAxeViolations(page, "Remote, waiting");
  await openMoreSection(page);
  await expectNoAxeViolations(page, "Remote, more");
  await page.getByRole("button", { name: "Disconnect" }).click();
  await expect(corridor.connectionStatus).toHaveText("Off");
  await expectNoAxeViolations(page, "Remote, off");
  await corridor.selectDriver("Program");
  const lessons = new LessonsPanel(page);
  await lessons.openPath();
  await expectNoAxeViolations(page, "lessons");
  await page.keyboard.press("Escape");
  await lessons.openMission(8);
  await lessons.button("Show a hint").click();
  await expectNoAxeViolations(page, "mission");
  await lessons.button("Back to my maze").click();
  await corridor.maze.tool("Measure").check();
  await (await corridor.maze.moveCursorTo({ column: 2, row: 6 })).press("Enter");
  await (await corridor.maze.moveCursorTo({ column: 5, row: 4 })).press("Enter");
  await expect(corridor.announcement).toContainText("squares");
  await expectNoAxeViolations(page, "measuring");
  await page.getByRole("button", { name: "Presets", exact: true }).click();
  await corridor.dialog("Presets").getByRole("radio", { name: "Rooms" }).click();
  await expectNoAxeViolations(page, "random maze");
  await page.keyboard.press("Escape");
  await corridor.mazeMenu.click();
  await corridor
    .dialog("Maze menu")
    .getByRole("button", { name: /picture/i })
    .click();
  await expectNoAxeViolations(page, "picture");
});

/** @returns a check for horizontal overflow at each size, which names its state in the report */
function overflowCheck(corridor: CorridorPage, sizes: readonly Size[]) {
  const { page } = corridor;
  let order = sizes;
  return async (state: string): Promise<void> => {
    for (const size of order) {
      if (page.viewportSize()?.width !== size.width) await page.setViewportSize(size);
      await corridor.waitForFrames(2);
      expect(await horizontalOverflow(page), `${state}, ${size.width} px`).toEqual([]);
    }
    // The next state begins at the size of this one: a new size costs a layout of the page.
    order = order.toReversed();
  };
}

interface Size {
  width: number;
  height: number;
}

/** Enters the longest texts into the program, bumps, and opens the dialogs and menus. */
async function expectNoOverflowOfLongTexts(
  corridor: CorridorPage,
  expectNoOverflow: (state: string) => Promise<void>,
): Promise<void> {
  const { page } = corridor;
  await corridor.program.condition(1).selectOption("left > right +");
  await corridor.program.number(1).fill("-99999.75");
  await corridor.program.action(1).selectOption("delayed right 90");
  await corridor.program.name.fill("A name so long that it has to be cut somewhere ".repeat(2));
  await corridor.speed.selectOption("max");
  await corridor.run.click();
  await expect(corridor.bumps).not.toHaveText("0 bumps");
  await expectNoOverflow("long texts");
  await corridor.share.click();
  await corridor.dialog("Share this maze").waitFor();
  await expectNoOverflow("share");
  await page.keyboard.press("Escape");
  await corridor.mazeMenu.click();
  await corridor.dialog("Maze menu").waitFor();
  await expectNoOverflow("maze menu");
  await page.keyboard.press("Escape");
}

test("has no horizontal overflow on a desktop", async ({ openWindow }) => {
  const sizes = [
    { width: 1440, height: 900 },
    { width: 1024, height: 768 },
  ];
  const corridor = await openWindow({ viewport: { width: 1440, height: 900 } });
  await corridor.open();
  const expectNoOverflow = overflowCheck(corridor, sizes);
  await expectNoOverflow("first visit");
  await corridor.selectDriver("Remote");
  await expect(corridor.connectionStatus).toHaveText("Waiting for a script");
  await expectNoOverflow("Remote");
  await openMoreSection(corridor.page);
  await expectNoOverflow("Remote, more");
  await corridor.selectDriver("Program");
  await expectNoOverflowOfLongTexts(corridor, expectNoOverflow);
});

/** @param state names the state in the report */
async function expectLargeTargets(page: Page, state: string): Promise<void> {
  expect(await smallTouchTargets(page), state).toEqual([]);
}

test("has touch targets of at least 44 px on a tablet", async ({ openWindow }) => {
  const corridor = await openWindow({ ...phone, viewport: { width: 1024, height: 768 } });
  await corridor.open();
  const { page } = corridor;
  expect(await page.evaluate(() => matchMedia("(pointer: coarse)").matches)).toBe(true);
  await expectLargeTargets(page, "first visit");
  await corridor.driver("Remote").tap();
  await expect(corridor.connectionStatus).toHaveText("Waiting for a script");
  await expectLargeTargets(page, "Remote");
  await openMoreSection(page);
  await expectLargeTargets(page, "Remote, more");
  await corridor.mazeMenu.tap();
  await expectLargeTargets(page, "maze menu");
  await page.keyboard.press("Escape");
  await corridor.share.tap();
  await expectLargeTargets(page, "share");
});

test("has no axe violations, no overflow and large touch targets on a phone, which edits the maze, drives and moves a line by touch", async ({
  openWindow,
}) => {
  test.slow();
  const corridor = await openWindow(phone);
  await corridor.open();
  const { page, program } = corridor;
  const expectNoOverflow = overflowCheck(corridor, [phone.viewport, { width: 320, height: 700 }]);

  await test.step("tabs and menus", async () => {
    expect(await page.evaluate(() => matchMedia("(pointer: coarse)").matches)).toBe(true);
    for (const name of ["Program", "Drive", "Presets"] as const) {
      await tab(page, name).tap();
      await expectNoAxeViolations(page, `phone, ${name}`);
      await expectLargeTargets(page, name);
      await expectNoOverflow(name);
    }
    await tab(page, "Program").tap();
    await corridor.mazeMenu.tap();
    await corridor.dialog("Maze menu").waitFor();
    await expectLargeTargets(page, "maze menu");
    await page.keyboard.press("Escape");
    await corridor.share.tap();
    await corridor.dialog("Share this maze").waitFor();
    await expectLargeTargets(page, "share");
    await page.keyboard.press("Escape");
    await page.setViewportSize(phone.viewport);
  });

  await test.step("touch", async () => {
    await corridor.maze.tap({ column: 2, row: 6 });
    await corridor.maze.expectSquare({ column: 2, row: 6 }, "block");

    await page.getByRole("button", { name: "Move or delete line 1" }).tap();
    await corridor.dialog("Move or delete line 1").getByRole("button", { name: "Move down" }).tap();
    await expect(program.line(2)).toHaveAccessibleName(/if right is more than 60/);

    await tab(page, "Drive").tap();
    await corridor.driveKey("forward").waitFor();
    await expect(page.getByText("The program is not running.")).toBeVisible();
    const liftFinger = await holdFinger(corridor.driveKey("left"));
    await expect(page.getByText("You are driving.")).toBeVisible();
    await expect(corridor.robotPose).toHaveText(/facing (up|left|down)/);
    await liftFinger();
    await corridor.waitForRobotToStop();
  });

  await test.step("long texts", async () => {
    await tab(page, "Program").tap();
    await expectNoOverflowOfLongTexts(
      corridor,
      overflowCheck(corridor, [phone.viewport, { width: 320, height: 700 }]),
    );
  });

  await test.step("Remote", async () => {
    await page.setViewportSize(phone.viewport);
    await page.getByRole("button", { name: "More", exact: true }).click();
    await corridor.dialog("More").waitFor();
    await expectNoAxeViolations(page, "phone, More");
    await corridor.dialog("More").getByRole("button", { name: "Remote" }).click();
    await expectNoAxeViolations(page, "phone, Remote");
  });
});

/** Touches an element through the DevTools protocol. @returns a function that lifts the finger */
async function holdFinger(target: Locator): Promise<() => Promise<void>> {
  const box = await target.boundingBox();
  if (box === null) throw new Error("the touch target is not on the screen");
  const browser = await target.page().context().newCDPSession(target.page());
  const touchPoints = [{ x: box.x + box.width / 2, y: box.y + box.height / 2 }];
  await browser.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints });
  return async () => {
    await browser.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
  };
}

/** Presses Tab until the element has the focus. */
async function tabTo(page: Page, target: Locator): Promise<void> {
  await expect(target).toBeVisible();
  for (let stop = 0; stop < 100; stop++) {
    if (await target.evaluate((element) => element === document.activeElement)) return;
    await page.keyboard.press("Tab");
  }
  await expect(target).toBeFocused();
}

/** Fills a new line whose condition has the focus. */
async function typeLine(page: Page, condition: string, number: string, action: string) {
  await page.keyboard.type(condition);
  await page.keyboard.press("Tab");
  await page.keyboard.press("Control+a");
  await page.keyboard.type(number);
  await page.keyboard.press("Tab");
  await page.keyboard.type(action);
}

test("moves the focus in visual order, solves a maze by keyboard alone and turns single keys off", async ({
  corridor,
  page,
}) => {
  const { keyboard } = page;

  await test.step("Tab moves the focus in the visual order of the page", async () => {
    // The zoom buttons are displayed after the maze.
    await page.getByRole("group", { name: "Zoom", exact: true }).waitFor();
    expect(await tabOrder(page)).toEqual([
      "bar",
      "Tool",
      "Maze",
      "maze",
      // below the maze, and Describe beside it
      "Zoom",
      "Maze",
      "Who drives?",
      // the invitation to the first mission
      "Lessons",
      "Program",
      "otherwise",
      "Program",
      "Hold to drive",
      "Run",
    ]);
  });

  await test.step("chooses a maze, builds a program, runs it and announces the goal", async () => {
    const liveRegion = await corridor.announcement.elementHandle();
    await tabTo(page, page.getByRole("button", { name: "Presets", exact: true }));
    await keyboard.press("Enter");
    await tabTo(page, corridor.dialog("Presets").getByRole("button", { name: /^Comb/ }));
    await keyboard.press("Enter");
    await expect(corridor.mazeMenu).toHaveAccessibleName("Comb, Maze menu");
    await expect(corridor.dialog("Presets")).toBeHidden();

    // A ready-made maze opens with an empty program.
    await expect(corridor.program.line(1)).toBeHidden();
    await tabTo(page, corridor.program.button("Add line"));
    await keyboard.press("Enter");
    await typeLine(page, "right >", "60", "delayed right");
    await tabTo(page, corridor.program.button("Add line"));
    await keyboard.press("Enter");
    await typeLine(page, "front <", "50", "left 90");
    await tabTo(page, corridor.speed);
    await keyboard.type("max");
    await keyboard.press("Control+Enter");
    await expect(corridor.runNote).toContainText("Goal reached after 13.3 s (tick 802)");
    await expect(corridor.announcement).toContainText("Goal reached after 13.3 s (tick 802)");
    // Screen readers announce only changes of a region that existed before its text.
    expect(await liveRegion?.textContent()).toContain("Goal reached");
  });

  await test.step("turns single keys off with ?, and keeps them off after a reload", async () => {
    // A menu uses the key itself.
    await corridor.maze.cursor.focus();
    await keyboard.press("?");
    const dialog = corridor.dialog("Keyboard shortcuts");
    await expect(dialog).toBeVisible();
    await dialog.getByRole("checkbox", { name: /^Single keys/ }).uncheck();
    await keyboard.press("Escape");
    await expect(dialog).toBeHidden();
    const pose = (await corridor.robotPose.textContent()) ?? "";
    await corridor.reload();
    // The robot is displayed at its start until the run is restored.
    await expect(corridor.robotPose).toHaveText(pose);
    await keyboard.press("?");
    await corridor.selectDriver("Me");
    await keyboard.press("w");
    await corridor.waitForRobotToStop();
    await expect(dialog).toBeHidden();
    await expect(corridor.robotPose).toHaveText(pose);
  });
});

/** The named parts that get the focus with Tab, from the top of the page to its end. */
async function tabOrder(page: Page): Promise<string[]> {
  const order: string[] = [];
  for (let stop = 0; stop < 80; stop++) {
    await page.keyboard.press("Tab");
    const place = await page.evaluate(() => {
      const focused = document.activeElement;
      if (focused === null || focused === document.body) return null;
      if (focused.closest("[role=grid]") !== null) return "maze";
      const named = focused.closest("header, section[aria-label], fieldset[aria-label], fieldset");
      if (named?.matches("section > header header, section header")) return "Program";
      if (named?.tagName === "HEADER") return named.closest("section") === null ? "bar" : "Program";
      return (
        named?.getAttribute("aria-label") ?? named?.querySelector("legend")?.textContent ?? "?"
      );
    });
    if (place === null) break;
    if (order.at(-1) !== place) order.push(place);
  }
  return order;
}

test("animates only the robot when reduced motion is requested", async ({ corridor, page }) => {
  await page.getByRole("button", { name: "Presets", exact: true }).click();
  const longest = await page.evaluate(() => {
    const times = [...document.querySelectorAll("*")].flatMap((element) => {
      const { transitionDuration, animationDuration } = getComputedStyle(element);
      return `${transitionDuration}, ${animationDuration}`.split(", ").map(Number.parseFloat);
    });
    return Math.max(...times.filter((seconds) => !Number.isNaN(seconds)));
  });
  expect(longest).toBeLessThanOrEqual(0.001);
  await page.keyboard.press("Escape");
  await corridor.speed.selectOption("max");
  await corridor.run.click();
  await expect(corridor.runNote).toContainText("Goal reached");
});
