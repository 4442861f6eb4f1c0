import { encodeLink } from "@corridor/link";
import { mazePresets } from "@corridor/maze";
import { programPresets } from "@corridor/program";
import { Recording, type RunDocument } from "@corridor/recording";
import { expect, test } from "./fixtures.ts";
import type { CorridorPage } from "./pages/corridor-page.ts";
import { expectNoAxeViolations } from "./support/axe.ts";
import { smallWindow } from "./support/window-sizes.ts";
import { withMotion } from "./support/with-motion.ts";

test.use({ ...withMotion, ...smallWindow });

/**
 * A link to a run in which a preset algorithm drives through a preset maze to its goal.
 * @param ticks the run ends at this tick, if the robot has not reached the goal before
 */
function runLink(mazeId: string, ticks = 36_000): { link: string; run: RunDocument } {
  const preset = mazePresets.find(({ id }) => id === mazeId);
  const program = programPresets.find(({ id }) => id === "right-wall")?.program;
  if (preset === undefined || program === undefined) throw new Error(mazeId);
  const recording = new Recording({ ...preset.maze, name: mazeId }, program);
  while (recording.run.goalTick === null && recording.run.tick < ticks) recording.step();
  const written = recording.toDocument(mazeId);
  if (!written.ok) throw new Error(written.reason);
  const encoded = encodeLink({ run: written.run });
  if (!encoded.ok) throw new Error(encoded.code);
  return { link: `/#${encoded.text}`, run: written.run };
}

async function racesLinkedRun(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  const { link } = runLink("tree");
  await page.evaluate((hash) => (location.hash = hash), link.slice("/#".length));
  await expect(corridor.mazeMenu).toHaveAccessibleName("tree, Maze menu");
  await expect(corridor.timeline.pastLabel).toBeVisible();
  await page.getByRole("button", { name: "Race this run" }).click();
  await expect(corridor.message(/^Ghost A is ready\./)).toBeVisible();
  await expect(corridor.clock).toHaveText("Time 0:00.0");
  await expect(page.getByRole("button", { name: "Race against 1 ghost" })).toBeVisible();

  // The student's own solution takes a different time.
  await page.getByRole("button", { name: "Presets", exact: true }).click();
  await corridor.dialog("Presets").getByText("Show an algorithm").click();
  await corridor
    .dialog("Presets")
    .getByRole("button", { name: /^Left wall/ })
    .click();
  await corridor.speed.selectOption("max");
  await corridor.run.click();
  const card = page.getByRole("region", { name: "Solved!" });
  await expect(card).toContainText(
    /You were first, \d+\.\d s before ghost A\.|Ghost A was first, \d+\.\d s before you\./,
  );
  await card.getByRole("button", { name: "Show all results" }).click();
  const dialog = corridor.dialog("Race");
  const rows = dialog.getByRole("row");
  await expect(rows).toHaveCount(3);
  await expect(rows.nth(1)).toContainText("You");
  await expect(rows.nth(2)).toContainText("Ghost A");
  await expect(rows.nth(2)).toContainText("Right wall");
  const times = await rows.locator("td:nth-child(2)").allTextContents();
  expect(times).toEqual([
    expect.stringMatching(/^\d+\.\d s$/),
    expect.stringMatching(/^\d+\.\d s$/),
  ]);
  expect(times[0]).not.toBe(times[1]);

  await expectNoAxeViolations(page, "the table of a race");

  // A run in another maze is rejected with a reason.
  const other = runLink("spiral");
  await dialog
    .getByRole("textbox", { name: "Link of a run" })
    .fill(`http://localhost${other.link}`);
  await dialog.getByRole("button", { name: "Add ghost" }).click();
  await expect(dialog.getByRole("alert")).toContainText("another maze, “spiral”");
  await dialog.getByRole("textbox", { name: "Link of a run" }).fill("http://localhost/m/SRCN");
  await dialog.getByRole("button", { name: "Add ghost" }).click();
  await expect(dialog.getByRole("alert")).toContainText("This link has no run.");
  await dialog.getByRole("button", { name: "Remove ghost A" }).click();
  await expect(dialog).toBeHidden();
  await expect(page.getByRole("button", { name: "Race against 1 ghost" })).toBeHidden();
}

async function racesEightRobots(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  await page.setViewportSize({ width: 320, height: 700 });
  await page.evaluate((hash) => (location.hash = hash), runLink("tree").link.slice("/#".length));
  await expect(corridor.mazeMenu).toHaveAccessibleName("tree, Maze menu");
  await corridor.dismissMessages();
  await page.getByRole("button", { name: "Race this run" }).click();
  await expect(corridor.message(/^Ghost A is ready\./)).toBeVisible();
  await corridor.dismissMessages();
  await page.getByRole("button", { name: "Race against 1 ghost" }).click();
  const dialog = corridor.dialog("Race");
  const field = dialog.getByRole("textbox", { name: "Link of a run" });
  for (const [at, badge] of ["B", "C", "D", "E", "F", "G"].entries()) {
    await field.fill(`http://localhost${runLink("tree", 120 + at * 60).link}`);
    await field.press("Enter");
    await expect(dialog.getByRole("button", { name: `Remove ghost ${badge}` })).toBeVisible();
    // Until then, the form is busy with the ghost.
    await expect(field).toHaveValue("");
  }
  await field.fill(`http://localhost${runLink("tree", 600).link}`);
  await field.press("Enter");
  await expect(dialog.getByRole("alert")).toHaveText(
    "A race has room for 8 robots: yours and 7 ghosts. Remove a ghost first.",
  );
  await expect(dialog.getByRole("row")).toHaveCount(9);
  const overflow = await dialog.evaluate((each) => each.scrollWidth - each.clientWidth);
  expect(overflow).toBe(0);
  await expectNoAxeViolations(page, "the table of a race of eight robots");
}

async function endsRaceWithEdit(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  await corridor.open(runLink("spiral").link);
  await page.getByRole("button", { name: "Race this run" }).click();
  const chip = page.getByRole("button", { name: "Race against 1 ghost" });
  await expect(chip).toBeVisible();
  const box = await chip.boundingBox();
  expect(box?.height).toBeGreaterThanOrEqual(44);
  // The tools fit into one row. A second row would take space from the maze.
  const view = await page.getByRole("button", { name: "View", exact: true }).boundingBox();
  expect(view?.y).toBe(box?.y);
  // Two messages would cover the tools, and what they are about.
  await expect(corridor.message(/^Ghost A is ready\./)).toBeVisible();
  await expect(corridor.message("A recorded run.")).not.toBeVisible();
  await corridor.dismissMessages();
  await chip.click();
  await expect(corridor.dialog("Race").getByRole("row")).toHaveCount(3);
  await page.keyboard.press("Escape");
  await corridor.maze.tap({ column: 0, row: 0 });
  await expect(corridor.message("The maze changed, so the race is over.")).toBeVisible();
  await expect(chip).toBeHidden();
}

async function keepsGhostsAcrossReload(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  await corridor.speed.selectOption("max");
  await corridor.run.click();
  const card = page.getByRole("region", { name: "Solved!" });
  await card.getByRole("button", { name: "Race this run" }).click();
  const chip = page.getByRole("button", { name: "Race against 1 ghost" });
  await expect(chip).toBeVisible();
  await page.reload();
  await expect(chip).toBeVisible();
  // The start may not have been saved yet.
  await corridor.reset.click();
  await corridor.speed.selectOption("max");
  await corridor.run.click();
  await expect(card).toContainText("You and ghost A were first, at the same time.");
}

test("races the robot against runs of its own and of a friend", async ({ corridor }) => {
  await test.step("keeps the ghosts of a race across a reload", () =>
    keepsGhostsAcrossReload(corridor));
  await test.step("races a friend's linked run on one clock, and compares time, bumps and lines", () =>
    racesLinkedRun(corridor));
});

test("races on a phone", async ({ openWindow }) => {
  const corridor = await openWindow({ viewport: { width: 390, height: 844 }, hasTouch: true });
  await test.step("offers the race on a phone, and ends it when the maze changes", () =>
    endsRaceWithEdit(corridor));
  await test.step("races eight robots, and says that a ninth has no room", () =>
    racesEightRobots(corridor));
});
