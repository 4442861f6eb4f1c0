/** Writing a program on a phone, fixing it after a bump, and going back in its run. */
import { expect, test } from "./fixtures.ts";
import type { CorridorPage } from "./pages/corridor-page.ts";
import { TouchInput } from "./support/touch-input.ts";
import { horizontalOverflow } from "./support/layout.ts";
import { boxOf, phone, smallestPhone, tab } from "./support/phone.ts";

async function writesProgram(corridor: CorridorPage): Promise<void> {
  const { program, page } = corridor;
  for (const remaining of [2, 1]) {
    await expect(program.lines).toHaveCount(remaining);
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
  await expect(corridor.robotPose).toHaveText(/facing left/);
  await expect(corridor.bumps).toHaveText("0 bumps");
}

async function movesAndDeletesLine(corridor: CorridorPage): Promise<void> {
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
}

async function fixesBump(corridor: CorridorPage): Promise<void> {
  const { page, program } = corridor;
  await program.action(2).selectOption("delayed left 90");
  await corridor.speed.selectOption("4×");
  await corridor.run.tap();
  const card = corridor.bumpCard(2);
  await expect(card).toBeVisible();
  await expect(card).toContainText(
    /with (4\d|50) cm in front\. It drives on first and needs 75 cm\./,
  );
  // The whole maze stays visible above the card, and the whole card can be tapped.
  const maze = await boxOf(corridor.maze.grid);
  await expect.poll(async () => (await boxOf(card)).y).toBeGreaterThanOrEqual(maze.y + maze.height);
  await expect(card.getByRole("button", { name: "Close" })).toBeInViewport({ ratio: 1 });
  const fix = card.getByRole("button", { name: "Change to left 90" });
  await expect(fix).toBeInViewport({ ratio: 1 });
  expect(await horizontalOverflow(page)).toEqual([]);
  await fix.tap();
  await expect(card).toBeHidden();
  await expect(program.action(2)).toHaveValue("left 90");
}

async function movesNothingAtStart(corridor: CorridorPage): Promise<void> {
  const places = async () => ({
    maze: await boxOf(corridor.maze.grid),
    step: await boxOf(corridor.step),
    timeline: (await boxOf(corridor.transport)).y,
  });
  const before = await places();
  await corridor.run.tap();
  await expect(corridor.timeline.slider).toBeInViewport();
  expect(await places()).toEqual(before);
}

async function scrubsTimeline(corridor: CorridorPage): Promise<void> {
  const { page, timeline } = corridor;
  await corridor.speed.selectOption("max");
  await corridor.run.tap();
  await expect(page.getByRole("region", { name: "Solved!" })).toBeVisible();
  await page.getByRole("region", { name: "Solved!" }).getByRole("button", { name: "Close" }).tap();
  const end = await corridor.robotPose.textContent();
  const touch = await TouchInput.of(page);
  await touch.drag(await timeline.pointAt(0.9), await timeline.pointAt(0.3));
  await expect(timeline.pastLabel).toBeVisible();
  await expect(corridor.robotPose).not.toHaveText(end ?? "");
  // The keys replace the transport only when the present is displayed. Right after a drag, the
  // browser takes a tap as the end of the drag.
  await expect(async () => {
    await tab(page, "Drive").tap();
    await expect(tab(page, "Drive")).toHaveAttribute("aria-selected", "true", { timeout: 1000 });
  }).toPass();
  await timeline.backToNow.tap();
  await expect(corridor.transport).toBeHidden();
  await expect(corridor.robotPose).toHaveText(end ?? "");
}

async function startOver(corridor: CorridorPage): Promise<void> {
  await corridor.reset.tap();
  await expect(corridor.clock).toHaveText("Time 0:00.0");
  await corridor.dismissMessages();
}

test("programs a robot on a phone", async ({ openWindow }) => {
  const corridor = await openWindow(phone);
  const { page } = corridor;
  await corridor.open();
  for (const [width, height] of [
    [667, 375],
    [320, 568],
    [390, 844],
  ] as const) {
    await test.step(`moves neither maze nor buttons when a run starts at ${width} x ${height}`, async () => {
      await page.setViewportSize({ width, height });
      await movesNothingAtStart(corridor);
      await startOver(corridor);
    });
  }
  await test.step("scrubs the timeline", async () => {
    await scrubsTimeline(corridor);
    await tab(page, "Program").tap();
    await startOver(corridor);
  });
  for (const { viewport } of [smallestPhone, phone]) {
    await test.step(`shows the bump card and applies its fix at ${viewport.width} x ${viewport.height}`, async () => {
      await page.setViewportSize(viewport);
      await fixesBump(corridor);
      await startOver(corridor);
    });
  }
  await test.step("moves and deletes a line through its menu", () => movesAndDeletesLine(corridor));
  await test.step("writes a program", () => writesProgram(corridor));
});
