/** "Try it in other mazes": in how many mazes the program works, and where it fails. */
import type { Locator } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import type { CorridorPage } from "./pages/corridor-page.ts";
import { expectNoAxeViolations } from "./support/axe.ts";
import { horizontalOverflow, smallTouchTargets } from "./support/layout.ts";
import { smallWindow } from "./support/window-sizes.ts";

test.use(smallWindow);

const title = "Try it in other mazes";

async function tryOthers(corridor: CorridorPage) {
  await corridor.program.button(title).click();
  const dialog = corridor.dialog(title);
  await expect(dialog).toBeVisible();
  return dialog;
}

/** A program that neither bumps nor leaves its square. */
async function turnForever({ program }: CorridorPage): Promise<void> {
  await program.condition(1).selectOption("front >");
  await program.number(1).fill("1");
  await program.action(1).selectOption("turn 180");
}

/** The number of mazes in which a program works, once all have been tried. */
function sentenceOf(dialog: Locator): Locator {
  return dialog.getByText(/^Works in \d+ of 100 mazes\.$/).first();
}

/** Waits for a message, and puts the pointer on it, so that it does not disappear. */
async function holdMessage(corridor: CorridorPage, text: string): Promise<void> {
  await corridor.message(text).hover();
}

async function backToMyMaze(corridor: CorridorPage): Promise<void> {
  await corridor.messages.getByRole("button", { name: "Back to my maze" }).click();
  await expect(corridor.mazeMenu).toHaveAccessibleName("Long way round, Maze menu");
}

async function worksInAllTrees(corridor: CorridorPage): Promise<void> {
  const dialog = await tryOthers(corridor);
  await expect(dialog.getByText("Time limit: 5 minutes of robot time")).toBeVisible();
  await expect(dialog.getByText("Works in 100 of 100 mazes.").first()).toBeVisible();
  await expect(dialog.getByText("Bumps: 0. Time limit reached: 0.")).toBeVisible();
  await expect(dialog.getByRole("button", { name: /^Seed \d+: works, goal after/ })).toHaveCount(
    100,
  );
  await expect(dialog.getByRole("button", { name: "Show a failure" })).toBeHidden();
  await corridor.page.keyboard.press("Escape");
  await expect(dialog).toBeHidden();
}

async function opensTheBumpAndReturns(corridor: CorridorPage): Promise<void> {
  const { program } = corridor;
  await program.number(2).fill("20");
  const dialog = await tryOthers(corridor);
  await expect(sentenceOf(dialog)).toBeVisible();
  await expectNoAxeViolations(corridor.page, "other mazes");
  const first = dialog.getByRole("button", { name: /^Seed \d+: bump after/ }).first();
  // Values are surrounded by invisible isolation marks.
  const name = ((await first.getAttribute("aria-label")) ?? "").replaceAll(/[^ -~]/g, "");
  const [, seed, minutes, seconds] = /^Seed (\d+): bump after (\d+):(\d+\.\d)/.exec(name) ?? [];
  const bumpAt = Number(minutes) * 60 + Number(seconds);
  await first.click();

  await holdMessage(corridor, `Your program bumps in “Tree 11, seed ${seed}”.`);
  await expect(dialog).toBeHidden();
  await expect(corridor.mazeMenu).toHaveAccessibleName(`Tree 11, seed ${seed}, Maze menu`);
  const displayed = /^Time (\d+):([\d.]+)$/.exec((await corridor.clock.textContent()) ?? "");
  const displayedAt = Number(displayed?.[1]) * 60 + Number(displayed?.[2]);
  expect(displayedAt).toBeGreaterThanOrEqual(bumpAt - 2.1);
  // The run is replayed to its end, where the robot bumps.
  await expect(corridor.bumps).toHaveText("1 bump");

  await program.number(2).fill("50");
  await backToMyMaze(corridor);
  await expect(program.number(2)).toHaveValue("50");
  await program.button("Undo").click();
  await expect(program.number(2)).toHaveValue("20");
}

async function reportsTheTimeLimit(corridor: CorridorPage): Promise<void> {
  await turnForever(corridor);
  const dialog = await tryOthers(corridor);
  await expect(dialog.getByText("Works in 0 of 100 mazes.").first()).toBeVisible();
  await expect(dialog.getByText("Bumps: 0. Time limit reached: 100.")).toBeVisible();
  await expect(dialog.getByText(/wrong|false|failed/i)).toHaveCount(0);
  await dialog.getByRole("button", { name: "Show a failure" }).click();
  await holdMessage(corridor, "Time limit reached in “Tree 11, seed 1”.");
  await expect(corridor.clock).toHaveText("Time 5:00.0");
  await backToMyMaze(corridor);
}

/** With a program that reaches no goal. */
async function stopsAndMovesByKeyboard(corridor: CorridorPage): Promise<void> {
  const { keyboard } = corridor.page;
  const dialog = await tryOthers(corridor);
  // The largest mazes have the longest time limit, which leaves time to stop.
  await dialog.getByRole("slider", { name: "Size" }).fill("33");
  await dialog.getByRole("button", { name: "Stop" }).click();
  await expect(dialog.getByText(/^Stopped\. Works in 0 of the first \d+\.$/).first()).toBeVisible();
  const list = dialog.getByRole("list", { name: "Mazes" });
  await list.getByRole("button").first().focus();
  await keyboard.press("ArrowRight");
  await expect(list.getByRole("button", { name: /^Seed 2:/ })).toBeFocused();
  await keyboard.press("End");
  await expect(list.getByRole("button", { name: "Seed 100: not tried yet" })).toBeFocused();
  await keyboard.press("Escape");
  await expect(dialog).toBeHidden();
  await expect(corridor.program.button(title)).toBeFocused();
}

async function selectsOtherMazes(corridor: CorridorPage): Promise<void> {
  // A program that works in some of them.
  await corridor.program.loadAlgorithm("Right wall");
  await corridor.page.getByRole("button", { name: "Replace my lines" }).click();
  const dialog = await tryOthers(corridor);
  await dialog.getByRole("radio", { name: "Rooms" }).click();
  await dialog.getByRole("slider", { name: "Size" }).fill("9");
  await expect(dialog.getByText("9 by 9 squares")).toBeVisible();
  await dialog.getByRole("button", { name: "Next 100" }).click();
  await expect(dialog.getByText("Seeds 101 to 200")).toBeVisible();
  const sentence = sentenceOf(dialog);
  await expect(sentence).toBeVisible();
  const before = (await sentence.textContent()) ?? "";
  await dialog.getByRole("button", { name: "Try again" }).click();
  await expect(sentence).toHaveText(before);
  await dialog.getByRole("button", { name: /^Seed 120:/ }).click();
  await expect(corridor.mazeMenu).toHaveAccessibleName("Rooms 9, seed 120, Maze menu");
}

// One page, because the workers that try the mazes stay warm in it.
test("tries a program in a hundred mazes, opens one of them and returns", async ({ corridor }) => {
  await test.step("shows that the right-wall program works in a hundred trees", () =>
    worksInAllTrees(corridor));
  await test.step("opens a maze two seconds before the bump, and returns with the program corrected there", () =>
    opensTheBumpAndReturns(corridor));
  await test.step("reports a reached time limit as such, never as wrong", () =>
    reportsTheTimeLimit(corridor));
  await test.step("stops, and moves through the mazes by keyboard", () =>
    stopsAndMovesByKeyboard(corridor));
  await test.step("selects other mazes, and gets the same mazes for the same seed", () =>
    selectsOtherMazes(corridor));
});

test("fits a phone", async ({ openWindow }) => {
  const phone = await openWindow({
    viewport: { width: 390, height: 700 },
    hasTouch: true,
    isMobile: true,
  });
  await phone.open();
  await phone.page.getByRole("tab", { name: "Program" }).tap();
  const dialog = await tryOthers(phone);
  await expect(dialog.getByText("Works in 100 of 100 mazes.").first()).toBeVisible();
  for (const width of [390, 320]) {
    await phone.page.setViewportSize({ width, height: 700 });
    expect(await horizontalOverflow(phone.page), `${width} px`).toEqual([]);
    expect(await smallTouchTargets(phone.page), `${width} px`).toEqual([]);
  }
});
