/**
 * Building a program from dropdowns, with the mouse and by keyboard alone, and observing it as it
 * runs.
 */
import type { CorridorPage } from "./pages/corridor-page.ts";
import { expect, test } from "./fixtures.ts";
import { smallWindow } from "./support/window-sizes.ts";

test.use(smallWindow);

const goal = /^Goal reached after 39\.6 s \(tick 2380\)/;

async function buildsWithMouse(corridor: CorridorPage): Promise<void> {
  const { program } = corridor;
  await program.deleteAllLines();
  await expect(program.lines).toHaveCount(0);
  await program.button("Add line").click();
  await expect(program.line(1)).toHaveAccessibleName(
    "Line 1: choose a condition. Skipped until then.",
  );
  await expect(program.line(1).getByText("skipped", { exact: true })).toBeVisible();
  await program.condition(1).selectOption("right >");
  await program.number(1).fill("60");
  await program.action(1).selectOption("delayed right 90");
  await program.addLine("front <", "50", "left 90");
  await program.otherwise.selectOption("forward");
  await expect(program.line(2)).toHaveAccessibleName(
    "Line 2: if front is less than 50, left 90. Front is 250, false.",
  );
  await corridor.speed.selectOption("max");
  await corridor.run.click();
  await expect(corridor.runNote).toHaveText(goal);
}

async function buildsByKeyboard(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  const { program } = corridor;
  const { keyboard } = page;
  await program.line(1).focus();
  await keyboard.press("Delete");
  await expect(program.line(1)).toBeFocused();
  await keyboard.press("Delete");
  await expect(program.lines).toHaveCount(0);

  await program.button("Add line").focus();
  await keyboard.press("Enter");
  // The condition of a new line has the focus, and typing selects an option.
  await expect(program.condition(1)).toBeFocused();
  await keyboard.type("right >");
  await expect(program.condition(1)).toHaveValue(await optionValue(corridor, "right >"));
  await keyboard.press("Tab");
  await expect(program.number(1)).toBeFocused();
  await keyboard.press("Control+a");
  await keyboard.type("60");
  await keyboard.press("Tab");
  await keyboard.type("delayed right");
  await program.button("Add line").focus();
  await keyboard.press("Space");
  await expect(program.condition(2)).toBeFocused();
  await keyboard.type("front <");
  await keyboard.press("Tab");
  await keyboard.press("Control+a");
  await keyboard.type("50");
  await keyboard.press("Tab");
  await keyboard.type("left 90");
  await expect(program.line(1)).toHaveAccessibleName(
    /if right is more than 60, delayed right 90\./,
  );
  await expect(program.line(2)).toHaveAccessibleName(/if front is less than 50, left 90\./);

  await corridor.speed.focus();
  await keyboard.type("max");
  await keyboard.press("Control+Enter");
  await expect(corridor.runNote).toHaveText(goal);
}

/** The value of an option in the condition menu of the first line. */
async function optionValue(corridor: CorridorPage, label: string): Promise<string> {
  const option = corridor.program.condition(1).locator("option", { hasText: label });
  return (await option.first().getAttribute("value")) ?? "";
}

async function movesLines(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  const { program } = corridor;
  const right = /if right is more than 60/;
  const front = /if front is less than 50/;
  await program.button("Move line 2 up").click();
  await expect(program.line(1)).toHaveAccessibleName(front);
  await expect(program.line(2)).toHaveAccessibleName(right);
  // The top line cannot move up, so the focus moves to its enabled button.
  await expect(program.button("Move line 1 down")).toBeFocused();
  await page.keyboard.press("Enter");
  await expect(program.line(2)).toHaveAccessibleName(front);
  await expect(program.button("Move line 2 up")).toBeFocused();

  await program.line(2).focus();
  await page.keyboard.press("Alt+ArrowUp");
  await expect(program.line(1)).toHaveAccessibleName(front);
  await expect(program.line(1)).toBeFocused();
  await program.number(1).focus();
  await page.keyboard.press("Alt+ArrowDown");
  await expect(program.line(2)).toHaveAccessibleName(front);
  await expect(program.number(2)).toBeFocused();
  // In a field, Delete removes a digit and never the line.
  await page.keyboard.press("Home");
  await page.keyboard.press("Delete");
  await expect(program.number(2)).toHaveValue("0");
  await expect(program.lines).toHaveCount(2);
}

async function deletesLine(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  const { program } = corridor;
  await program.button("Delete line 1").click();
  await expect(program.lines).toHaveCount(1);
  await expect(corridor.message("Line 1 deleted.")).toBeVisible();
  await corridor.messages.getByRole("button", { name: "Undo" }).click();
  await expect(program.lines).toHaveCount(2);
  await expect(program.line(1)).toHaveAccessibleName(/if right is more than 60/);
  await expect(corridor.message("Line 1 deleted.")).toBeHidden();

  await program.line(2).focus();
  await page.keyboard.press("Delete");
  await expect(program.lines).toHaveCount(1);
  await expect(program.line(1)).toBeFocused();
  await page.keyboard.press("Control+z");
  await expect(program.lines).toHaveCount(2);
  await page.keyboard.press("Control+Shift+Z");
  await expect(program.lines).toHaveCount(1);
}

async function showsTruthValues(corridor: CorridorPage): Promise<void> {
  const { program } = corridor;
  await expect(program.line(1)).toContainText("50 > 60");
  await expect(program.line(1)).toHaveAccessibleName(/Right is 50, false\.$/);
  await expect(program.line(2)).toContainText("250 < 50");
  await expect(program.region.getByRole("group", { name: "otherwise" })).toBeVisible();

  await program.number(1).fill("40");
  await expect(program.line(1)).toContainText("50 > 40");
  await expect(program.line(1)).toHaveAccessibleName(
    "Line 1: if right is more than 40, delayed right 90. Right is 50, true.",
  );
  await expect(program.line(1)).toHaveAttribute("aria-current", "step");
  await expect(program.runningLineNote).toHaveText("not read this time");
  await expect(program.runningLineNote).toBeVisible();
  await expect(program.line(2)).not.toHaveAttribute("aria-current");
  await expect(corridor.sensor("front")).toHaveText("250");
  await expect(corridor.sensor("right")).toHaveText("50");
  await expect(corridor.sensor("back")).toHaveText("50");

  await program.condition(1).selectOption("choose a condition");
  await expect(program.line(1)).toHaveAccessibleName(
    "Line 1: choose a condition. Skipped until then.",
  );
  await expect(program.number(1)).toBeHidden();
  await program.condition(1).selectOption("left > right +");
  await expect(program.number(1)).toHaveValue("40");
  await expect(program.line(1)).toHaveAccessibleName(/if left is more than right plus 40/);
}

async function explainsInvalidNumber(corridor: CorridorPage): Promise<void> {
  const { program } = corridor;
  const number = program.number(1);
  for (const text of ["", "sixty", "-1", "100001", "1e3x"]) {
    await number.fill(text);
    await expect(number).toHaveAttribute("aria-invalid", "true");
    await expect(program.region.getByText("Type a distance from 0 to 100000 cm.")).toBeVisible();
    await expect(program.line(1)).toHaveAccessibleName(/if right is more than 60/);
  }
  await number.blur();
  await expect(number).toHaveValue("60");
  await expect(number).toHaveAttribute("aria-invalid", "false");
  await expect(program.region.getByText("Type a distance")).toBeHidden();
  await number.fill("72.5");
  await number.blur();
  await expect(number).toHaveValue("72.5");
  await expect(program.line(1)).toHaveAccessibleName(/if right is more than 72\.5/);
}

async function keepsPressBelowInvalidNumber(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  const { program } = corridor;
  const error = program.region.getByText("Type a distance");
  // A real press holds the button down while the field loses the focus and the page renders.
  const press = async (name: string) => {
    await program.number(1).fill("abc");
    await page.keyboard.press("Enter");
    await expect(error).toBeVisible();
    await program.button(name).hover();
    await page.mouse.down();
    await expect(program.number(1)).not.toHaveValue("abc");
    await page.mouse.up();
  };
  await press("Add line");
  await expect(program.lines).toHaveCount(3);
  await expect(error).toHaveCount(0);
  await press("Move line 2 up");
  await expect(program.line(1)).toHaveAccessibleName(/if front is less than 50/);
  await expect(error).toHaveCount(0);
  await expect(program.number(2)).toHaveValue("60");
}

const algorithms = [
  { name: "Back and forth", lines: 1 },
  { name: "Right wall", lines: 2 },
  { name: "Left wall", lines: 2 },
  { name: "Farthest distance", lines: 3 },
  { name: "Left at every wall", lines: 1 },
];

async function loadsEachAlgorithm(corridor: CorridorPage): Promise<void> {
  const { program } = corridor;
  for (const { name, lines } of algorithms) {
    await program.loadAlgorithm(name);
    await expect(program.name).toHaveValue(name);
    await expect(program.lines).toHaveCount(lines);
    await expect(corridor.message(`${name} is loaded.`)).toBeVisible();
    await corridor.dismissMessages();
  }
  await program.button("Undo").click();
  await expect(program.name).toHaveValue("Farthest distance");
  await corridor.speed.selectOption("max");
  await corridor.run.click();
  await expect(corridor.runNote).toContainText("Goal reached after 38.5 s (tick 2310)");
}

async function appliesEditImmediately(corridor: CorridorPage): Promise<void> {
  const { program } = corridor;
  await corridor.choosePreset("Empty");
  await program.deleteAllLines();
  await program.otherwise.selectOption("left 90");
  await corridor.run.click();
  await expect(corridor.robotPose).toHaveText(/facing up/);
  await program.otherwise.selectOption("forward");
  await expect(corridor.robotPose).not.toHaveText(/^Robot at 50, 650/);
}

/** The first program again, and the robot at its start. */
async function startOver(corridor: CorridorPage): Promise<void> {
  const undo = corridor.program.button("Undo");
  while (await undo.isEnabled()) await undo.click();
  await expect(corridor.program.line(1)).toHaveAccessibleName(/if right is more than 60, delayed/);
  await expect(corridor.program.line(2)).toHaveAccessibleName(/if front is less than 50, left 90/);
  await corridor.reset.click();
  await corridor.dismissMessages();
  await corridor.speed.selectOption("1");
}

test("edits a program, and observes it as it runs", async ({ corridor }) => {
  const step = (title: string, check: (page: CorridorPage) => Promise<void>) =>
    test.step(title, async () => {
      await check(corridor);
      await startOver(corridor);
    });
  await step("loads each ready-made algorithm, and undoes the last one", loadsEachAlgorithm);
  await step(
    "shows each line's truth value with its numbers, and the line that decides",
    showsTruthValues,
  );
  await step("explains an invalid number, and restores the last valid one", explainsInvalidNumber);
  await step(
    "does not lose a press on a button below an invalid number",
    keepsPressBelowInvalidNumber,
  );
  await step("moves lines by buttons and keys, and keeps the focus on the line", movesLines);
  await step("deletes a line, and restores it from the message", deletesLine);
  await step(
    "builds the right-wall program with the mouse, runs it and reaches the goal",
    buildsWithMouse,
  );
  await step("builds the same program by keyboard alone", buildsByKeyboard);
  await test.step("applies an edit of a line to the running robot immediately", () =>
    appliesEditImmediately(corridor));
});
