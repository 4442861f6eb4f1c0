/** The presets: ready-made mazes with solved marks, random mazes, algorithms. */
import { generateMaze } from "@corridor/maze";
import { expect, test } from "./fixtures.ts";
import type { CorridorPage } from "./pages/corridor-page.ts";
import { expectNoAxeViolations } from "./support/axe.ts";
import { horizontalOverflow, smallTouchTargets } from "./support/layout.ts";
import { smallWindow } from "./support/window-sizes.ts";

test.use(smallWindow);

async function generatesRooms(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  await page.getByRole("button", { name: "Presets", exact: true }).click();
  const presets = corridor.dialog("Presets");
  await presets.getByRole("radio", { name: "Rooms" }).click();
  await presets.getByRole("slider", { name: "Size" }).fill("31");
  await expect(presets.getByText("31 by 31 squares")).toBeVisible();
  await presets.getByRole("textbox", { name: "Seed" }).fill("4711");
  await presets.getByRole("button", { name: "Open random maze" }).click();

  await expect(corridor.mazeMenu).toHaveAccessibleName("Rooms 31, seed 4711, Maze menu");
  await expect(corridor.message("“Rooms 31, seed 4711” is open.")).toBeVisible();
  await expect(corridor.maze.grid).toHaveAttribute("aria-colcount", "31");
  // The same kind, size and seed produce the same maze everywhere.
  const same = generateMaze({ kind: "rooms", columns: 31, rows: 31, seed: 4711, name: "" });
  const goal = same.goals[0] ?? { column: 0, row: 0 };
  await corridor.maze.expectSquare(goal, "open, goal");
}

async function generatesByKeyboard(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  await page.getByRole("button", { name: "Presets", exact: true }).press("Enter");
  const presets = corridor.dialog("Presets");
  const seed = presets.getByRole("textbox", { name: "Seed" });
  const before = await seed.inputValue();
  await presets.getByRole("radio", { name: "Tree" }).focus();
  await page.keyboard.press("ArrowRight");
  await expect(presets.getByRole("radio", { name: "Loops" })).toBeChecked();
  await page.keyboard.press("Tab");
  await page.keyboard.press("ArrowLeft");
  await expect(presets.getByText("19 by 19 squares")).toBeVisible();
  await page.keyboard.press("Tab");
  await expect(seed).toBeFocused();
  await page.keyboard.press("Tab");
  await page.keyboard.press("Enter");
  await expect(seed).not.toHaveValue(before);
  const generated = await seed.inputValue();
  await page.keyboard.press("Tab");
  await page.keyboard.press("Enter");
  await expect(corridor.mazeMenu).toHaveAccessibleName(`Loops 19, seed ${generated}, Maze menu`);
  await corridor.messages.getByRole("button", { name: "Undo" }).press("Enter");
  await expect(corridor.mazeMenu).toHaveAccessibleName("Long way round, Maze menu");
}

async function rejectsInvalidSeed(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  await page.getByRole("button", { name: "Presets", exact: true }).click();
  const presets = corridor.dialog("Presets");
  await expect(presets.getByRole("slider", { name: "Size" })).toHaveAttribute(
    "aria-valuetext",
    "21 by 21 squares",
  );
  const seed = presets.getByRole("textbox", { name: "Seed" });
  await seed.fill("12");
  await seed.fill("many");
  await expect(presets.getByText("Type a whole number from 0 to 999999999.")).toBeVisible();
  await expect(presets.getByText("Tree 21, seed 12")).toBeVisible();
  await expect(presets.getByRole("heading", { name: "Random maze" })).toBeVisible();
  await expectNoAxeViolations(page, "presets");
  await page.keyboard.press("Escape");
}

async function loadsAlgorithm(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  await page.getByRole("button", { name: "Presets", exact: true }).click();
  const presets = corridor.dialog("Presets");
  const leftWall = presets.getByRole("button", { name: /^Left wall/ });
  // Solutions are hidden until the user requests them.
  await expect(leftWall).toBeHidden();
  await presets.getByText("Show an algorithm").click();
  await leftWall.click();
  await expect(corridor.program.name).toHaveValue("Left wall");
  await expect(corridor.mazeMenu).toHaveAccessibleName("Long way round, Maze menu");
}

async function asksBeforeReplacing(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  const { program } = corridor;
  await corridor.transport.getByRole("button", { name: "Write my own" }).click();
  await expect(program.lines).toHaveCount(0);
  await program.addLine("front <", "40", "left 90");
  await program.loadAlgorithm("Farthest distance");
  const menu = page.getByRole("dialog", { name: "Show an algorithm" });
  await expect(menu.getByRole("alert")).toHaveText("“Farthest distance” would replace your line.");
  await expectNoAxeViolations(page, "the question");
  await menu.getByRole("button", { name: "Keep my lines" }).click();
  await menu.getByRole("button", { name: /^Farthest distance/ }).click();
  await expect(program.number(1)).toHaveValue("40");
  await menu.getByRole("button", { name: "Replace my lines" }).click();
  await expect(menu).toBeHidden();
  await expect(program.name).toHaveValue("Farthest distance");
  await expect(program.lines).toHaveCount(3);
}

async function showsWholeQuestion(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  await corridor.program.number(2).fill("40");
  await page.getByRole("button", { name: "Presets", exact: true }).click();
  const presets = corridor.dialog("Presets");
  await presets.getByText("Show an algorithm").click();
  await presets.getByRole("button", { name: /^Back and forth/ }).focus();
  await page.keyboard.press("Enter");
  await expect(presets.getByRole("button", { name: "Keep my lines" })).toBeInViewport({ ratio: 1 });
  await page.keyboard.press("Tab");
  await page.keyboard.press("Tab");
  await expect(presets.getByRole("button", { name: "Keep my lines" })).toBeFocused();
  await page.keyboard.press("Enter");
  await expect(presets.getByRole("button", { name: /^Back and forth/ })).toBeFocused();
  await page.keyboard.press("Escape");
  await expect(corridor.program.number(2)).toHaveValue("40");
}

test("opens ready-made and random mazes, and algorithms", async ({ corridor }) => {
  const step = (title: string, check: (page: CorridorPage) => Promise<void>) =>
    test.step(title, async () => {
      await check(corridor);
      await corridor.dismissMessages();
    });
  await step("rejects an invalid seed, and keeps the last valid one", rejectsInvalidSeed);
  await step(
    "generates another maze with a new seed by keyboard alone, and undoes it",
    generatesByKeyboard,
  );
  await step("asks before an algorithm replaces the user's lines", asksBeforeReplacing);
  await step("loads an algorithm from the presets", loadsAlgorithm);
  await step(
    "shows the whole question before an algorithm replaces lines, and takes the answer by keys",
    showsWholeQuestion,
  );
  await step("generates a random maze with rooms and the size slider", generatesRooms);
});

test("marks a solved preset maze, also after a reload", async ({ corridor, page }) => {
  await corridor.program.nameAsOwn();
  await corridor.choosePreset("First steps");
  await corridor.speed.selectOption("max");
  await corridor.run.click();
  await expect(corridor.runNote).toContainText("Goal reached");
  await corridor.reload();
  await page.getByRole("button", { name: "Presets", exact: true }).click();
  const presets = corridor.dialog("Presets");
  await expect(presets.getByRole("button", { name: /^First steps/ })).toContainText("solved");
  await expect(presets.getByRole("button", { name: /^Spiral/ })).not.toContainText("solved");
});

test("selects a random maze on a phone", async ({ openWindow }) => {
  const phone = await openWindow({
    viewport: { width: 390, height: 700 },
    hasTouch: true,
    isMobile: true,
  });
  await phone.open();
  // After a step, the phone layout has all its elements.
  await phone.step.tap();
  await phone.page.getByRole("tab", { name: "Presets" }).tap();
  await phone.page.getByRole("radio", { name: "Rooms" }).tap();
  await phone.page.getByRole("textbox", { name: "Seed" }).fill("5");
  for (const width of [390, 320]) {
    await phone.page.setViewportSize({ width, height: 700 });
    expect(await horizontalOverflow(phone.page), `${width} px`).toEqual([]);
    expect(await smallTouchTargets(phone.page), `${width} px`).toEqual([]);
  }
  await phone.page.getByRole("button", { name: "Open random maze" }).tap();
  await expect(phone.mazeMenu).toHaveAccessibleName("Rooms 21, seed 5, Maze menu");
});
