// cspell:words Programms Beispiel rechte Vorlagen Kamm Roboter Ziel
/** A first-time visitor: finds a robot in a maze, with a program that solves it. */
import { expect, test } from "./fixtures.ts";
import { chooseLanguage } from "./support/choose-language.ts";
import { clearStorageOnLoad } from "./support/clear-storage.ts";
import { phone } from "./support/phone.ts";
import { Texts } from "./support/texts.ts";
import { smallWindow } from "./support/window-sizes.ts";
import { withMotion } from "./support/with-motion.ts";

test.use(withMotion);

/** The first program in the first maze, at any speed: 2380 ticks are 39.6 s. */
const solved = "Goal reached after 39.6 s (tick 2380), in row 1, column 11, by “otherwise”.";

test("shows a robot in a maze with a program that drives it, tick by tick, and an invitation to the lessons", async ({
  corridor,
  page,
}) => {
  const { program } = corridor;
  const begin = page.getByRole("button", { name: "Start with mission 1" });

  await test.step("maze, program and robot", async () => {
    await expect(page).toHaveTitle("Corridor: a robot in a maze");
    await expect(corridor.mazeMenu).toHaveAccessibleName("Long way round, Maze menu");
    await expect(corridor.driver("Program")).toBeChecked();
    await expect(program.name).toHaveValue("Example: right wall");
    await expect(program.lines).toHaveCount(2);
    await expect(corridor.robotPose).toHaveText("Robot at 50, 650, facing right");
    await expect(corridor.clock).toHaveText("Time 0:00.0");
    await expect(corridor.runNote).toHaveText("Run starts the program. Step takes one decision.");
    await corridor.maze.expectSquare(
      { column: 0, row: 6 },
      "open, start, facing right, robot here, facing right",
    );
    await corridor.maze.expectSquare({ column: 10, row: 0 }, "open, goal");
  });

  await test.step("says beside the button what it is for, also in a low window", async () => {
    await page.setViewportSize({ width: 1024, height: 768 });
    const invitation = page.getByRole("region", { name: "Lessons" });
    await expect(invitation.getByText("New here?")).toBeInViewport({ ratio: 1 });
    const button = await begin.boundingBox();
    const words = await invitation.getByText("New here?").boundingBox();
    // Both share a row.
    expect(Math.abs((button?.y ?? 0) - (words?.y ?? 99))).toBeLessThan(12);
    expect(words?.height).toBeLessThan(40);
    // A low window hides the goal below the program.
    await page.setViewportSize({ width: 1440, height: 900 });
  });

  await test.step("advances by ticks and decisions with Step, and returns the robot with Reset", async () => {
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
    await expect(program.line(2)).toHaveAttribute("aria-current", "step");
    await expect(corridor.run).toBeVisible();
    await corridor.maze.click({ column: 5, row: 6 });
    await corridor.reset.click();
    await expect(corridor.robotPose).toHaveText("Robot at 50, 650, facing right");
    await expect(corridor.clock).toHaveText("Time 0:00.0");
    await expect(program.lines).toHaveCount(2);
    await corridor.maze.expectSquare({ column: 5, row: 6 }, "block");
    await corridor.maze.click({ column: 5, row: 6 });
    await corridor.maze.expectSquare({ column: 5, row: 6 }, "open");
  });

  await test.step("starts an empty program with one press, and undoes it", async () => {
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
    // It is offered only while no script drives.
    await corridor.selectDriver("Remote");
    await writeOwn.waitFor({ state: "detached" });
    await corridor.selectDriver("Program");
    await expect(writeOwn).toBeVisible();
  });

  await test.step("hides the invitation to the first mission once the program needs the space", async () => {
    await program.number(1).fill("70");
    await expect(begin).toBeVisible();
    await program.button("Add line").click();
    await begin.waitFor({ state: "detached" });
  });
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

test("pauses, continues, and reports the same goal at any speed, in every preset maze", async ({
  openWindow,
}) => {
  const corridor = await openWindow(smallWindow);
  await corridor.open();
  await test.step("pauses, and continues from the same place", async () => {
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
  // The pose is reported a few times a second, and may follow the run note.
  await corridor.waitForRobotToStop();
  const pose = await corridor.robotPose.textContent();
  for (const speed of ["16×", "max"]) {
    await test.step(`reports the same goal at ${speed}`, async () => {
      await corridor.reset.click();
      await expect(corridor.clock).toHaveText("Time 0:00.0");
      await expect(corridor.runNote).not.toContainText("Goal");
      await corridor.speed.selectOption(speed);
      await corridor.run.click();
      await expect(corridor.runNote).toHaveText(solved);
      await expect(corridor.run).toBeVisible();
      await expect(corridor.clock).toHaveText("Time 0:39.6");
      await expect(corridor.bumps).toHaveText("0 bumps");
      await expect(corridor.robotPose).toHaveText(pose ?? "");
    });
  }
  await test.step("opens every preset maze and solves those with a goal", async () => {
    await corridor.program.nameAsOwn();
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
});

test("opens a maze with an empty program, unless the user has written one, and undoes that", async ({
  corridor,
  page,
}) => {
  const { program } = corridor;
  await test.step("undoes the selection of a maze from its message", async () => {
    await corridor.choosePreset("Spiral");
    await expect(
      corridor.message("Your program is empty: get the robot to the goal."),
    ).toBeVisible();
    await expect(program.lines).toHaveCount(0);
    await expect(program.region.getByText("Get the robot to the goal.")).toBeVisible();
    await corridor.messages.getByRole("button", { name: "Undo" }).click();
    await expect(corridor.mazeMenu).toHaveAccessibleName("Long way round, Maze menu");
    await expect(corridor.message(/is open/)).toBeHidden();
    await corridor.maze.expectSquare({ column: 10, row: 0 }, "open, goal");
    await expect(program.name).toHaveValue("Example: right wall");
  });
  await test.step("shows the example in the selected language, and then opens mazes with an empty program", async () => {
    await chooseLanguage(page, Texts.load("en"), "de");
    await expect(page.getByLabel("Name des Programms")).toHaveValue("Beispiel: rechte Wand");
    await page.getByRole("button", { name: "Vorlagen", exact: true }).click();
    await page
      .getByRole("dialog", { name: "Vorlagen" })
      .getByRole("button", { name: /^Kamm/ })
      .click();
    await expect(page.getByText("Bring den Roboter ans Ziel.", { exact: true })).toBeVisible();
    await chooseLanguage(page, Texts.load("de"), "en");
  });
  await test.step("keeps the user's own program", async () => {
    await program.addLine("front <", "50", "left 90");
    await corridor.choosePreset("Spiral");
    await expect(program.lines).toHaveCount(1);
    await corridor.choosePreset("Empty");
    await expect(program.region.getByText("This maze has no goal yet.")).toBeVisible();
  });
});

test("starts an empty program on a phone of 390 and 320 px", async ({ openWindow }) => {
  const corridor = await openWindow({ ...phone, viewport: { width: 390, height: 640 } });
  const { page, program } = corridor;
  await clearStorageOnLoad(page);
  const label = program.region.getByText("Example: right wall", { exact: true });
  const writeOwn = corridor.transport.getByRole("button", { name: "Write my own" });
  for (const width of [390, 320]) {
    await page.setViewportSize({ width, height: 640 });
    await corridor.open();
    await expect(label).toBeInViewport();
    const own = await writeOwn.boundingBox();
    const run = await corridor.run.boundingBox();
    expect(own?.y).toBe(run?.y);
    await writeOwn.tap();
    await expect(program.region.getByText("Get the robot to the goal.")).toBeInViewport();
    await expect(corridor.reset).toBeVisible();
    await label.waitFor({ state: "detached" });
  }
});
