// cspell:words Programms Beispiel rechte Vorlagen Kamm Roboter Ziel
/** A first-time visitor: finds a robot in a maze, with a program that solves it. */
import { expect, test } from "./fixtures.ts";

/** The first program in the first maze, at any speed: 2380 ticks are 39.6 s. */
const solved = "Goal reached after 39.6 s (tick 2380), in row 1, column 11, by “otherwise”.";

test("shows a robot in a maze, with a program that drives it", async ({ corridor, page }) => {
  await expect(page).toHaveTitle("Corridor: a robot in a maze");
  await expect(corridor.mazeMenu).toHaveAccessibleName("Long way round, Maze menu");
  await expect(corridor.driver("Program")).toBeChecked();
  await expect(corridor.program.name).toHaveValue("Example: right wall");
  await expect(corridor.program.lines).toHaveCount(2);
  await expect(corridor.robotPose).toHaveText("Robot at 50, 650, facing right");
  await expect(corridor.clock).toHaveText("Time 0:00.0");
  await expect(corridor.runNote).toHaveText("Run starts the program. Step takes one decision.");
  await corridor.maze.expectSquare(
    { column: 0, row: 6 },
    "open, start, facing right, robot here, facing right",
  );
  await corridor.maze.expectSquare({ column: 10, row: 0 }, "open, goal");
});

test("runs at 16 times the speed and reports that the goal is reached", async ({ corridor }) => {
  await corridor.speed.selectOption("16×");
  await corridor.run.click();
  await expect(corridor.runNote).toHaveText(solved);
  await expect(corridor.run).toBeVisible();
  await expect(corridor.clock).toHaveText("Time 0:39.6");
  await expect(corridor.bumps).toHaveText("0 bumps");
});

test("runs twice at maximum speed with the same result", async ({ corridor }) => {
  await corridor.speed.selectOption("max");
  await corridor.run.click();
  await expect(corridor.runNote).toHaveText(solved);
  // The pose is reported a few times a second, and may follow the run note.
  await corridor.waitForRobotToStop();
  const pose = await corridor.robotPose.textContent();
  await corridor.reset.click();
  await expect(corridor.clock).toHaveText("Time 0:00.0");
  await expect(corridor.runNote).not.toContainText("Goal");
  await corridor.run.click();
  await expect(corridor.runNote).toHaveText(solved);
  await expect(corridor.robotPose).toHaveText(pose ?? "");
});

test("pauses, and continues from the same place", async ({ corridor }) => {
  await corridor.run.click();
  await expect(corridor.robotPose).not.toHaveText("Robot at 50, 650, facing right");
  await corridor.pause.click();
  await expect(corridor.run).toBeVisible();
  await corridor.waitForRobotToStop();
  await expect(corridor.bumps).toHaveText("0 bumps");
  await corridor.speed.selectOption("max");
  await corridor.run.click();
  await expect(corridor.runNote).toHaveText(solved);
});

test("advances by ticks and decisions with Step, and returns the robot with Reset", async ({
  corridor,
  page,
}) => {
  // 100 cm/s are 5/3 cm a tick: 51.67, 53.33, 55, then 60 after six ticks, a tenth of a second.
  for (const x of [52, 53, 55]) {
    await corridor.step.click({ modifiers: ["Shift"] });
    await expect(corridor.robotPose).toHaveText(`Robot at ${x}, 650, facing right`);
  }
  // A long press does the same on a touch screen. It ends once it had its effect.
  await corridor.step.hover();
  for (const x of [57, 58, 60]) {
    await page.mouse.down();
    await expect(corridor.robotPose).toHaveText(`Robot at ${x}, 650, facing right`);
    await page.mouse.up();
  }
  await expect(corridor.clock).toHaveText("Time 0:00.1");
  // The next change of decision is at the first wall ahead.
  await corridor.step.click();
  await expect(corridor.program.line(2)).toHaveAttribute("aria-current", "step");
  await expect(corridor.run).toBeVisible();
  await corridor.maze.click({ column: 5, row: 6 });
  await corridor.reset.click();
  await expect(corridor.robotPose).toHaveText("Robot at 50, 650, facing right");
  await expect(corridor.clock).toHaveText("Time 0:00.0");
  await expect(corridor.program.lines).toHaveCount(2);
  await corridor.maze.expectSquare({ column: 5, row: 6 }, "block");
});

test("completes a whole turn with one Step", async ({ corridor }) => {
  await corridor.program.condition(1).selectOption("front >");
  await corridor.program.action(1).selectOption("turn 180");
  await corridor.step.click();
  await expect(corridor.robotPose).toHaveText("Robot at 50, 650, facing left");
  // 180 degrees at 150 degrees a second.
  await expect(corridor.clock).toHaveText("Time 0:01.2");
  await expect(corridor.run).toBeVisible();
});

test("starts an empty program with one press, and undoes it", async ({ corridor, page }) => {
  const { program } = corridor;
  const writeOwn = corridor.transport.getByRole("button", { name: "Write my own" });
  await corridor.step.click();
  await writeOwn.click();
  await expect(program.name).toHaveValue("");
  await expect(program.lines).toHaveCount(0);
  await expect(program.region.getByText("Get the robot to the goal.")).toBeVisible();
  await expect(corridor.clock).toHaveText("Time 0:00.0");
  await expect(writeOwn).toHaveCount(0);
  await expect(program.button("Add line")).toBeFocused();
  await page.keyboard.press("Enter");
  await expect(program.lines).toHaveCount(1);
  await expect(program.region.getByText("Get the robot to the goal.")).toBeVisible();
  for (let step = 0; step < 2; step++) await program.button("Undo").click();
  await expect(program.name).toHaveValue("Example: right wall");
  await expect(writeOwn).toBeVisible();
});

for (const width of [390, 320]) {
  test(`starts an empty program on a phone of ${width} px`, async ({ openWindow }) => {
    const phone = await openWindow({
      viewport: { width, height: 640 },
      hasTouch: true,
      isMobile: true,
    });
    await phone.open();
    const label = phone.program.region.getByText("Example: right wall", { exact: true });
    await expect(label).toBeInViewport();
    const writeOwn = phone.transport.getByRole("button", { name: "Write my own" });
    const own = await writeOwn.boundingBox();
    const run = await phone.run.boundingBox();
    expect(own?.y).toBe(run?.y);
    await writeOwn.tap();
    await expect(phone.program.region.getByText("Get the robot to the goal.")).toBeInViewport();
    await expect(phone.reset).toBeVisible();
    await expect(label).toHaveCount(0);
  });
}

test("offers to write a program only while no script drives", async ({ corridor, page }) => {
  const writeOwn = corridor.transport.getByRole("button", { name: "Write my own" });
  await expect(writeOwn).toBeVisible();
  await page.getByRole("radio", { name: "Remote", exact: true }).click();
  await expect(writeOwn).toHaveCount(0);
  await page.getByRole("radio", { name: "Program", exact: true }).click();
  await expect(writeOwn).toBeVisible();
});

test("says beside the button what it is for, also in a low window", async ({ openWindow }) => {
  const corridor = await openWindow({ viewport: { width: 1024, height: 768 } });
  await corridor.open();
  const invitation = corridor.page.getByRole("region", { name: "Lessons" });
  await expect(invitation.getByText("New here?")).toBeInViewport({ ratio: 1 });
  const begin = await invitation
    .getByRole("button", { name: "Start with mission 1" })
    .boundingBox();
  const words = await invitation.getByText("New here?").boundingBox();
  // Both share a row.
  expect(Math.abs((begin?.y ?? 0) - (words?.y ?? 99))).toBeLessThan(12);
  expect(words?.height).toBeLessThan(40);
});

test("hides the invitation to the first mission once the program needs the space", async ({
  corridor,
  page,
}) => {
  const invitation = page.getByRole("button", { name: "Start with mission 1" });
  await corridor.program.number(1).fill("70");
  await expect(invitation).toBeVisible();
  await corridor.program.button("Add line").click();
  await expect(invitation).toHaveCount(0);
});

test("shows the example in the selected language, and then opens mazes with an empty program", async ({
  corridor,
}) => {
  const { page } = corridor;
  await page.getByRole("button", { name: "EN, Language" }).click();
  await page.getByRole("menuitemradio", { name: "Deutsch" }).click();
  await expect(page.getByLabel("Name des Programms")).toHaveValue("Beispiel: rechte Wand");
  await page.getByRole("button", { name: "Vorlagen", exact: true }).click();
  await page
    .getByRole("dialog", { name: "Vorlagen" })
    .getByRole("button", { name: /^Kamm/ })
    .click();
  await expect(page.getByText("Bring den Roboter ans Ziel.", { exact: true })).toBeVisible();
});

test("opens a maze with an empty program, unless the user has written one", async ({
  corridor,
}) => {
  const { program } = corridor;
  await corridor.choosePreset("Comb");
  await expect(corridor.message("Your program is empty: get the robot to the goal.")).toBeVisible();
  await expect(program.lines).toHaveCount(0);
  await expect(program.region.getByText("Get the robot to the goal.")).toBeVisible();
  await program.addLine("front <", "50", "left 90");
  await corridor.choosePreset("Spiral");
  await expect(program.lines).toHaveCount(1);
  await corridor.choosePreset("Empty");
  await expect(program.region.getByText("This maze has no goal yet.")).toBeVisible();
});

/** Where the right-wall program ends in each preset maze; null if the maze has no goal. */
const presets = [
  { title: "First steps", end: "tick 478" },
  { title: "Straight corridor", end: "tick 465" },
  { title: "Spiral", end: "tick 3166" },
  { title: "Comb", end: "tick 802" },
  { title: "Tree", end: "tick 5731" },
  { title: "Long way round", end: "tick 2380" },
  { title: "Two rooms", end: "tick 1211" },
  { title: "Empty", end: null },
];

test("opens every preset maze and solves those with a goal", async ({ corridor }) => {
  await corridor.program.nameAsOwn();
  await corridor.speed.selectOption("max");
  for (const { title, end } of presets) {
    await corridor.choosePreset(title);
    await expect(corridor.message(`“${title}” is open.`)).toBeVisible();
    await expect(corridor.clock).toHaveText("Time 0:00.0");
    await corridor.dismissMessages();
    if (end === null) continue;
    await corridor.run.click();
    await expect(corridor.runNote).toContainText(end);
  }
});

test("undoes the selection of a maze from its message", async ({ corridor }) => {
  await corridor.choosePreset("Spiral");
  await corridor.messages.getByRole("button", { name: "Undo" }).click();
  await expect(corridor.mazeMenu).toHaveAccessibleName("Long way round, Maze menu");
  await expect(corridor.message(/is open/)).toBeHidden();
  await corridor.maze.expectSquare({ column: 10, row: 0 }, "open, goal");
});
