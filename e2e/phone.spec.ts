/** Corridor in the hand: driving with a thumb, writing a program, choosing a maze, going back in time. */
import type { Locator, Page } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import type { CorridorPage } from "./pages/corridor-page.ts";
import { atRest } from "./support/at-rest.ts";
import { Fingers, middleOf } from "./support/fingers.ts";
import { stickingOut, tooSmallToTouch, unreadable, zoomedInto } from "./support/layout.ts";

const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };
/** The smallest that is still about. */
const smallest = { ...phone, viewport: { width: 320, height: 568 } };
/** Pixels per cm while the stage goes with the robot. */
const SCALE = 0.6;

function tab(page: Page, name: "Drive" | "Program" | "Presets"): Locator {
  return page.getByRole("tab", { name });
}

async function boxOf(target: Locator) {
  const box = await target.boundingBox();
  if (box === null) throw new Error("it is not on the screen");
  return box;
}

/** The whole maze in small; a picture, so it has no role. */
function smallMap(page: Page): Locator {
  return page.locator("[data-map]");
}

/** Chooses a maze in the tab of the presets. */
async function choose(corridor: CorridorPage, title: string): Promise<void> {
  await tab(corridor.page, "Presets").tap();
  await corridor.page.getByRole("button", { name: new RegExp(`^${title}`) }).tap();
  await expect(corridor.mazeMenu).toHaveAccessibleName(`${title}, Maze menu`);
}

test("drives on a phone and sees the robot followed with a small map", async ({ openWindow }) => {
  const corridor = await openWindow(phone);
  await corridor.open();
  const { page } = corridor;
  await choose(corridor, "Empty");
  await tab(page, "Drive").tap();
  await expect(corridor.transport).toBeHidden();
  await expect(smallMap(page)).toBeVisible();
  // The sheet grows for the keys, and the map goes with it.
  await atRest(page);
  const columns = Number(await corridor.maze.grid.getAttribute("aria-colcount"));
  expect((await boxOf(corridor.maze.grid)).width).toBeCloseTo(columns * 100 * SCALE, 0);
  const before = { maze: await boxOf(corridor.maze.grid), dot: await robotOnMap(page) };

  const fingers = await Fingers.of(page);
  await fingers.down(await middleOf(corridor.driveKey("forward")));
  await expect(page.getByText("You are driving.")).toBeVisible();
  await expect.poll(async () => (await boxOf(corridor.maze.grid)).x).toBeLessThan(before.maze.x);
  await fingers.lift();
  await corridor.robotStands();

  // The stage has gone so far that the robot is in its middle.
  const maze = await boxOf(corridor.maze.grid);
  expect(maze.x + (await corridor.robotX()) * SCALE).toBeCloseTo(phone.viewport.width / 2, -1);
  const dot = await robotOnMap(page);
  expect(dot.x).toBeGreaterThan(before.dot.x);
  expect(dot.y).toBeCloseTo(before.dot.y, 0);
});

/** The robot's place on the small map, from its corner. */
async function robotOnMap(page: Page) {
  const map = await boxOf(smallMap(page));
  const { x, y } = await middleOf(smallMap(page).locator("svg").last());
  return { x: x - map.x, y: y - map.y };
}

test("does the missions of the hand with a thumb, and every button is there whole", async ({
  openWindow,
}) => {
  const corridor = await openWindow(phone);
  await corridor.open();
  const { page } = corridor;
  const next = page.getByRole("button", { name: "Next mission" });
  const runProgram = page.getByRole("button", { name: "Run program" });
  await page.getByRole("button", { name: "Start with mission 1" }).tap();
  await expect(corridor.driveKey("forward")).toBeVisible();
  await atRest(page);
  await expect(runProgram).toBeInViewport({ ratio: 1 });
  expect(await unreadable(page), "mission 1").toEqual([]);
  const fingers = await Fingers.of(page);
  await fingers.down(await middleOf(corridor.driveKey("forward")));
  await expect(page.getByRole("note")).toHaveText(/^Challenge met after/);
  await fingers.lift();
  await expect(page.getByRole("region", { name: "Solved!" })).toBeVisible();
  // The card's own, not one more that it lies over.
  await expect(next).toHaveCount(1);
  await next.tap();
  await expect(corridor.mazeMenu).toHaveAccessibleName("How far is the wall?, Maze menu");
  await expect(runProgram).toHaveCount(0);
});

for (const [lang, begin, run] of [
  ["de", "Mit Mission 1 beginnen", "Programm starten"],
  ["fr", "Commencer la mission 1", "Lancer le programme"],
] as const) {
  test(`reads the whole task above the keys in ${lang}`, async ({ openWindow }) => {
    const corridor = await openWindow(phone);
    const { page } = corridor;
    await page.goto(`/?lang=${lang}`);
    await page.getByRole("button", { name: begin }).tap();
    await expect(page.getByRole("button", { name: run })).toBeInViewport({ ratio: 1 });
    const task = page.getByRole("region", { name: "Mission" }).getByRole("paragraph").first();
    const whole = await task.evaluate((text) => {
      const own = text.getBoundingClientRect();
      const around = text.parentElement?.getBoundingClientRect();
      return around !== undefined && own.top >= around.top && own.bottom <= around.bottom;
    });
    expect(whole).toBe(true);
  });
}

test("finds nothing below the screen in any tab", async ({ openWindow }) => {
  const corridor = await openWindow(phone);
  await corridor.open();
  const { page } = corridor;
  for (const name of ["Presets", "Drive", "Program"] as const) {
    await tab(page, name).tap();
    await atRest(page);
    // What is out of sight in the sheet scrolls there, never the page under the finger.
    const below = await page.evaluate(() => document.documentElement.scrollHeight - innerHeight);
    expect(below, name).toBe(0);
  }
});

test("reads a message without losing the maze from sight", async ({ openWindow }) => {
  const corridor = await openWindow(phone);
  await corridor.open();
  const { page } = corridor;
  await page.keyboard.press("i");
  const message = corridor.messages.getByRole("button", { name: "Dismiss" });
  await expect(message).toBeVisible();
  await atRest(page);
  const box = await boxOf(corridor.messages);
  expect(box.y + box.height).toBeLessThanOrEqual((await boxOf(corridor.maze.grid)).y);
});

test("sees the whole maze again, and follows the robot again", async ({ openWindow }) => {
  const corridor = await openWindow(phone);
  await corridor.open();
  const { page } = corridor;
  await tab(page, "Drive").tap();
  await page.getByRole("button", { name: "Whole maze" }).tap();
  await expect(smallMap(page)).toBeHidden();
  const maze = await boxOf(corridor.maze.grid);
  const keys = await boxOf(page.getByRole("tablist"));
  expect(maze.x).toBeGreaterThanOrEqual(0);
  expect(maze.x + maze.width).toBeLessThanOrEqual(phone.viewport.width);
  expect(maze.y + maze.height).toBeLessThanOrEqual(keys.y);
  await page.getByRole("button", { name: "Follow the robot" }).tap();
  await expect(smallMap(page)).toBeVisible();
  expect((await boxOf(corridor.maze.grid)).width).toBeCloseTo(1100 * SCALE, 0);
});

test("hands over to the program and back without leaving the keys", async ({ openWindow }) => {
  const corridor = await openWindow(phone);
  await corridor.open();
  const { page } = corridor;
  await tab(page, "Drive").tap();
  await page.getByRole("button", { name: "Run program" }).tap();
  await expect(page.getByText("The program is driving.")).toBeVisible();
  await expect.poll(() => corridor.robotX()).toBeGreaterThan(80);
  await page.getByRole("button", { name: "Pause" }).tap();
  await expect(page.getByRole("button", { name: "Run program" })).toBeVisible();
  const fingers = await Fingers.of(page);
  await fingers.down(await middleOf(corridor.driveKey("left")));
  await expect(page.getByText("You are driving.")).toBeVisible();
  // The system takes the finger away: the robot must not drive on.
  await fingers.takeAway();
  await corridor.robotStands();
  await expect(corridor.driveKey("left")).toHaveAttribute("aria-pressed", "false");
});

test("changes nothing in the maze while driving with a thumb", async ({ openWindow }) => {
  const corridor = await openWindow(phone);
  await corridor.open();
  const { page } = corridor;
  await tab(page, "Drive").tap();
  await page.getByRole("button", { name: "Whole maze" }).tap();
  await corridor.maze.tap({ column: 3, row: 6 });
  await tab(page, "Program").tap();
  await corridor.maze.tap({ column: 2, row: 6 });
  await corridor.maze.expectSquare({ column: 2, row: 6 }, "block");
  await page.getByRole("button", { name: "Undo" }).first().tap();
  // The first tap would be undone now if it had changed anything.
  await corridor.maze.expectSquare({ column: 2, row: 6 }, "open");
  await expect(page.getByRole("button", { name: "Undo" }).first()).toBeDisabled();
});

test("writes a program on a phone", async ({ openWindow }) => {
  const corridor = await openWindow(phone);
  await corridor.open();
  const { program, page } = corridor;
  for (const left of [2, 1]) {
    await expect(program.lines).toHaveCount(left);
    await page.getByRole("button", { name: "Move or delete line 1" }).tap();
    await page.getByRole("button", { name: "Delete line", exact: true }).tap();
  }
  await program.button("Add line").tap();
  await program.condition(1).selectOption("front <");
  await program.number(1).tap();
  await program.number(1).fill("60");
  await program.action(1).selectOption("turn 180");
  await expect(program.line(1)).toHaveAccessibleName(/if front is less than 60, turn 180/);
  await corridor.dismissMessages();
  await corridor.speed.selectOption("4×");
  await corridor.run.tap();
  await expect(program.line(1)).toHaveAttribute("aria-current", "step");
  await expect(corridor.robotPlace).toHaveText(/facing left/);
  await expect(corridor.bumps).toHaveText("0 bumps");
});

test("moves and deletes a line behind its one button", async ({ openWindow }) => {
  const corridor = await openWindow(phone);
  await corridor.open();
  const { program, page } = corridor;
  await page.getByRole("button", { name: "Move or delete line 2" }).tap();
  const menu = corridor.dialog("Move or delete line 2");
  await expect(menu.getByRole("button", { name: "Move down" })).toBeDisabled();
  await menu.getByRole("button", { name: "Move up" }).tap();
  await expect(program.line(2)).toHaveAccessibleName(/if right is more than 60/);
  await page.getByRole("button", { name: "Move or delete line 2" }).tap();
  await menu.getByRole("button", { name: "Delete" }).tap();
  await expect(program.lines).toHaveCount(1);
  await corridor.messages.getByRole("button", { name: "Undo" }).tap();
  await expect(program.lines).toHaveCount(2);
});

for (const device of [phone, smallest]) {
  const { width, height } = device.viewport;
  test(`drags the sheet open and closed at ${width} x ${height}`, async ({ openWindow }) => {
    const corridor = await openWindow(device);
    await corridor.open();
    const { page } = corridor;
    const bar = page.getByRole("button", { name: /^Panel is / });
    const fingers = await Fingers.of(page);
    const pull = async (by: number) => {
      const from = await middleOf(bar);
      await fingers.drag(from, { x: from.x, y: from.y + by });
      // The sheet moves to its place before the next finger can find what lies on it.
      await corridor.frames(30);
    };
    // Half open, the maze is wholly in sight.
    const maze = await boxOf(corridor.maze.grid);
    expect(maze.y + maze.height).toBeLessThanOrEqual((await boxOf(corridor.transport)).y);
    const lines = await boxOf(page.getByRole("tabpanel"));
    await pull(-60);
    await expect(bar).toHaveAccessibleName("Panel is open. Close it");
    await expect
      .poll(async () => (await boxOf(page.getByRole("tabpanel"))).height)
      .toBeGreaterThan(lines.height);
    await pull(60);
    await expect(bar).toHaveAccessibleName("Panel is half open. Open it all");
    await pull(60);
    await expect(bar).toHaveAccessibleName("Panel is closed. Open it by half");
    await expect(corridor.program.button("Add line")).toBeHidden();
    await bar.click();
    await expect(corridor.program.button("Add line")).toBeVisible();
    // A tab of a closed sheet opens it. Pressed, the bar goes on from half to open to closed.
    await bar.click();
    await expect(bar).toHaveAccessibleName("Panel is open. Close it");
    await bar.click();
    await expect(bar).toHaveAccessibleName("Panel is closed. Open it by half");
    await tab(page, "Drive").click();
    await expect(corridor.driveKey("forward")).toBeVisible();
  });
}

test("chooses a preset on a phone", async ({ openWindow }) => {
  const corridor = await openWindow(phone);
  await corridor.open();
  const { page } = corridor;
  await tab(page, "Presets").tap();
  const cards = page.getByRole("list", { name: "Presets" }).getByRole("button");
  const [first, second, third] = await Promise.all([0, 1, 2].map((at) => boxOf(cards.nth(at))));
  // Two columns.
  expect(second?.y).toBe(first?.y);
  expect(third?.x).toBe(first?.x);
  expect(third?.y).toBeGreaterThan((first?.y ?? 0) + (first?.height ?? 0));
  const spiral = page.getByRole("button", { name: "Spiral right turns only" });
  await spiral.tap();
  await expect(spiral).toHaveAttribute("aria-current", "true");
  await expect(corridor.mazeMenu).toHaveAccessibleName("Spiral, Maze menu");
});

for (const device of [phone, smallest]) {
  const { width, height } = device.viewport;
  test(`reads the bump card and takes the mend at ${width} x ${height}`, async ({ openWindow }) => {
    const corridor = await openWindow(device);
    await corridor.open();
    const { page, program } = corridor;
    await program.action(2).selectOption("delayed left 90");
    await corridor.speed.selectOption("4×");
    await corridor.run.tap();
    const card = page.getByRole("region", { name: "Bump: line 2 ran out of room" });
    await expect(card).toBeVisible();
    await expect(card).toContainText(/Only 2\d cm were free/);
    // The whole maze stays in sight above it, and all of the card can be pressed.
    const maze = await boxOf(corridor.maze.grid);
    await expect
      .poll(async () => (await boxOf(card)).y)
      .toBeGreaterThanOrEqual(maze.y + maze.height);
    await expect(card.getByRole("button", { name: "Close" })).toBeInViewport({ ratio: 1 });
    const mend = card.getByRole("button", { name: "Change to left 90" });
    await expect(mend).toBeInViewport({ ratio: 1 });
    expect(await stickingOut(page)).toEqual([]);
    await mend.tap();
    await expect(card).toBeHidden();
    await expect(program.action(2)).toHaveValue("left 90");
  });
}

test("scrubs on a phone", async ({ openWindow }) => {
  const corridor = await openWindow(phone);
  await corridor.open();
  const { page, timeline } = corridor;
  await corridor.speed.selectOption("max");
  await corridor.run.tap();
  await expect(page.getByRole("region", { name: "Solved!" })).toBeVisible();
  await page.getByRole("region", { name: "Solved!" }).getByRole("button", { name: "Close" }).tap();
  const end = await corridor.robotPlace.textContent();
  const fingers = await Fingers.of(page);
  await fingers.drag(await timeline.placeAt(0.9), await timeline.placeAt(0.3));
  await expect(timeline.inThePast).toBeVisible();
  await expect(corridor.robotPlace).not.toHaveText(end ?? "");
  // The keys take the room of the transport only as long as nothing leads back. Right after a drag the
  // browser takes a tap for its end.
  await expect(async () => {
    await tab(page, "Drive").tap();
    await expect(tab(page, "Drive")).toHaveAttribute("aria-selected", "true", { timeout: 1000 });
  }).toPass();
  await timeline.backToNow.tap();
  await expect(corridor.transport).toBeHidden();
  await expect(corridor.robotPlace).toHaveText(end ?? "");
});

test("paints blocks with one finger, and nothing with two", async ({ openWindow }) => {
  const corridor = await openWindow(phone);
  await corridor.open();
  const { page, maze } = corridor;
  const box = await boxOf(maze.grid);
  const side = box.width / 11;
  const at = (column: number, row: number) => ({
    x: box.x + (column + 0.5) * side,
    y: box.y + (row + 0.5) * side,
  });
  const fingers = await Fingers.of(page);
  await fingers.drag(at(6, 1), at(8, 1));
  for (const column of [6, 7, 8]) await maze.expectSquare({ column, row: 1 }, "block");
  await fingers.down(at(0, 0), at(2, 0));
  await fingers.move(at(1, 0), at(1, 0));
  await fingers.lift();
  for (const column of [0, 1, 2]) await maze.expectSquare({ column, row: 0 }, "open");
});

const sizes = [
  [320, 568],
  [360, 640],
  [390, 844],
  [414, 896],
  [667, 375],
  [844, 390],
  [600, 900],
  [768, 1024],
  [1024, 768],
] as const;
for (const [width, height] of sizes) {
  test(`reaches and reads everything with a finger at ${width} x ${height}`, async ({
    openWindow,
  }) => {
    const corridor = await openWindow({ ...phone, viewport: { width, height } });
    await corridor.open();
    const { page } = corridor;
    const expectInOrder = async (what: string) => {
      expect(await stickingOut(page), what).toEqual([]);
      expect(await tooSmallToTouch(page), what).toEqual([]);
      expect(await zoomedInto(page), what).toEqual([]);
      // Between the two the page scrolls under its foot.
      if (width < 600 || height < 600) expect(await unreadable(page), what).toEqual([]);
    };
    await expectInOrder("first visit");
    await corridor.step.tap();
    await expect(corridor.timeline.slider).toBeInViewport();
    await expectInOrder("after a step");
    if (width >= 600) return;
    for (const name of ["Drive", "Presets"] as const) {
      await tab(page, name).tap();
      await expectInOrder(name);
    }
  });
}

test("touches every field without the phone zooming in", async ({ openWindow }) => {
  const corridor = await openWindow(smallest);
  await corridor.open();
  const { page } = corridor;
  const expectCalm = async (what: string) => {
    await expect(page.locator("input, select, textarea").first()).toBeAttached();
    expect(await zoomedInto(page), what).toEqual([]);
    expect(await stickingOut(page), what).toEqual([]);
  };
  await expectCalm("program");
  await tab(page, "Presets").tap();
  await expectCalm("presets");
  await corridor.share.tap();
  await expect(corridor.dialog("Share this maze").getByRole("textbox")).toBeVisible();
  await expectCalm("share");
  await page.keyboard.press("Escape");
  await corridor.mazeMenu.tap();
  await expect(page.locator(":popover-open input")).toBeVisible();
  await expectCalm("maze menu");
  await page.keyboard.press("Escape");
  await page.getByRole("button", { name: "View" }).tap();
  await page.locator(":popover-open").getByRole("button", { name: "Resize" }).tap();
  await expect(corridor.dialog("Resize the maze")).toBeVisible();
  await expectCalm("resize");
  await page.keyboard.press("Escape");
  await page.getByRole("button", { name: "More", exact: true }).tap();
  await page.getByRole("button", { name: "Remote", exact: true }).tap();
  await page.getByRole("dialog").getByRole("radio", { name: "Remote" }).tap();
  await expect(page.getByRole("textbox", { name: "Script" })).toBeVisible();
  await expectCalm("remote");
});
