/**
 * Cards and messages about a run: the bump card, the solved card, and the hint about driving in
 * circles.
 */
import { encodeLink } from "@corridor/link";
import type { Locator, Page } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import type { CorridorPage } from "./pages/corridor-page.ts";
import { waitForAnimations } from "./support/wait-for-animations.ts";
import { expectNoAxeViolations } from "./support/axe.ts";
import { smallWindow } from "./support/window-sizes.ts";

// The stage of this window is lower than the card of a bump, which is in the panel instead.
test.use(smallWindow);

/**
 * Line 2 turns too late: it continues towards the wall that it detected. At any speed it bumps in
 * the same tick, and at the highest the page draws the fewest frames.
 */
async function bump(corridor: CorridorPage): Promise<Locator> {
  await corridor.program.action(2).selectOption("delayed left 90");
  await corridor.speed.selectOption("max");
  await corridor.run.click();
  const card = corridor.bumpCard(2);
  await expect(card).toBeVisible();
  return card;
}

/** Keeps the only message on the screen: its time does not pass while it has the focus. */
async function holdMessage(corridor: CorridorPage): Promise<void> {
  await corridor.messages.getByRole("button", { name: "Dismiss" }).focus();
}

async function leavesDriveKeysUncovered(corridor: CorridorPage): Promise<void> {
  await corridor.speed.selectOption("max");
  await corridor.transport.getByRole("button", { name: "Write my own" }).click();
  await expect(corridor.program.button("Add line")).toBeFocused();
  await holdMessage(corridor);
  await corridor.page.keyboard.press("Control+Enter");
  await expect(corridor.page.getByRole("region", { name: "Bump" })).toBeVisible();
  await expect(corridor.message(/^Your program is empty now\./)).toBeVisible();
  for (const key of ["forward", "left", "stop", "right", "reverse"]) {
    await corridor.driveKey(key).click({ trial: true });
  }
  await expect(corridor.message(/^Your program is empty now\./)).toBeVisible();
}

async function explainsAndFixes(corridor: CorridorPage): Promise<void> {
  const { program } = corridor;
  const card = await bump(corridor);
  await expect(card).toContainText(
    /Line 2 chose “delayed left 90” at \d+\.\d s with (4\d|50) cm in front\. It drives on first and needs 75 cm\./,
  );
  // Both distances are from the robot's centre, as the sensors measure.
  await expect(card.getByRole("definition")).toHaveText([/^75 cm$/, /^(4\d|50) cm$/]);
  await expect(corridor.run).toBeVisible();

  // The fix is withdrawn after an edit that it was not made for.
  const change = card.getByRole("button", { name: "Change to left 90" });
  await program.button("Delete line 1").click();
  await expect(change).toBeHidden();
  await program.button("Undo").click();
  await change.click();
  await expect(card).toBeHidden();
  await expect(program.action(2)).toHaveValue("left 90");

  await expect(corridor.messages).toContainText("Fixed. Press Run to continue.");
  await corridor.messages.getByRole("button", { name: "Run from the start" }).click();
  await expect(corridor.page.getByRole("region", { name: "Solved!" })).toBeVisible();
  await expect(corridor.bumps).toHaveText("0 bumps");
  await expect(corridor.messages).not.toContainText("Fixed");
}

async function replaysTheBump(corridor: CorridorPage): Promise<void> {
  const card = await bump(corridor);
  const clock = await corridor.clock.textContent();
  await corridor.speed.selectOption("4×");
  // Checked in each frame: on a slow machine, the replay can end between two looks from outside.
  const replay = corridor.page.waitForFunction((end) => {
    const isShown = document.querySelector("[data-card]") !== null;
    const run = document.querySelector("section[aria-label=Run]")?.textContent ?? "";
    return !isShown && !run.includes(end);
  }, clock ?? "");
  await card.getByRole("button", { name: "Watch again" }).click();
  await replay;
  await expect(card).toBeVisible();
  await expect(corridor.clock).toHaveText(clock ?? "");
  await expect(corridor.bumps).toHaveText("1 bump");

  // Closed by keyboard, it does not stop the run again.
  await card.getByRole("button", { name: "Close" }).focus();
  await corridor.page.keyboard.press("Escape");
  await expect(card).toBeHidden();
  await corridor.page.keyboard.press("Control+Enter");
  await expect(corridor.pause).toBeVisible();
  await expect(corridor.clock).toHaveText(/0:0[5-9]|0:[1-5]|[1-9]:/);
  await expect(corridor.pause).toBeVisible();
}

async function showsTheSolution(corridor: CorridorPage): Promise<void> {
  const card = await bump(corridor);
  const again = card.getByRole("button", { name: "Run from the start" });
  await expect(again).toHaveCount(0);
  await corridor.program.action(2).selectOption("left 90");
  await again.click();
  const solved = corridor.page.getByRole("region", { name: "Solved!" });
  await expect(solved).toContainText("Your 2 lines take the robot from start to goal.");
  await expect(corridor.bumps).toHaveText("0 bumps");
  await expect(solved.getByRole("definition")).toHaveText(["39.6 s", "2", "0"]);
  await expectNoAxeViolations(corridor.page, "solved card");
  const nextMaze = solved.getByRole("button", { name: /^Next maze: / });
  const name = ((await nextMaze.textContent()) ?? "").replace("Next maze: ", "");
  await nextMaze.click();
  await expect(corridor.mazeMenu).toHaveAccessibleName(`${name}, Maze menu`);
  await expect(solved).toBeHidden();
}

async function reportsPushingAndCircles(corridor: CorridorPage): Promise<void> {
  await corridor.program.deleteAllLines();
  await corridor.speed.selectOption("max");
  await corridor.run.click();
  const card = corridor.page.getByRole("region", { name: "Bump", exact: true });
  await expect(card).toContainText("A line for this place is missing.");
  await card.getByRole("button", { name: "Close" }).click();
  await corridor.run.click();
  await expect(corridor.message(/^The robot pushes against a wall/)).toBeVisible();
  await corridor.reset.click();
  await corridor.dismissMessages();
  await corridor.program.addLine("front <", "50", "turn 180");
  await corridor.run.click();
  await expect(
    corridor.message(/^The robot passed here 3 times in the same direction\.$/),
  ).toBeVisible();
  await expect(corridor.messages.getByRole("button", { name: /^Show line/ })).toHaveCount(0);
}

async function reportsTurnTooEarly(corridor: CorridorPage): Promise<void> {
  const link = encodeLink({
    maze: {
      format: "corridor/maze",
      version: 1,
      name: "Side way",
      blocks: ["#####", ".....", ...Array.from({ length: 8 }, () => "##.##")],
      start: { column: 0, row: 1, heading: "east" },
      goals: [],
    },
    program: {
      format: "corridor/program",
      version: 1,
      name: "Too early",
      default: "forward",
      rules: [{ when: { sensor: "right", is: ">", than: 60 }, do: "right 90" }],
    },
  });
  await corridor.page.evaluate((hash) => (location.hash = hash), link.ok ? link.text : "");
  await expect(corridor.mazeMenu).toHaveAccessibleName("Side way, Maze menu");
  await corridor.speed.selectOption("max");
  await corridor.run.click();
  const card = corridor.bumpCard(1);
  await expect(card).toContainText(
    /Line 1 chose “right 90” at \d+\.\d s, at the edge of the opening/,
  );
  // The mark in the list is on the same line.
  await expect(corridor.program.line(1)).toHaveAccessibleName(/^Line 1, look here/);
  await card.getByRole("button", { name: "Change to delayed right 90" }).click();
  await expect(corridor.program.action(1)).toHaveValue("delayed right 90");
}

/** The robot is at its start with the first program, and no message covers a control. */
async function startOver(corridor: CorridorPage): Promise<void> {
  await corridor.reset.click();
  await expect(corridor.clock).toHaveText("Time 0:00.0");
  await corridor.dismissMessages();
}

test("explains bumps, offers a fix and shows the solution", async ({ corridor }) => {
  const { page, program } = corridor;
  await test.step("leaves the drive keys uncovered by a message while a card is above the robot", async () => {
    await page.setViewportSize({ width: 1024, height: 768 });
    await leavesDriveKeysUncovered(corridor);
    await page.setViewportSize(smallWindow.viewport);
    await startOver(corridor);
    await program.button("Undo").click();
    await expect(program.lines).toHaveCount(2);
  });
  await test.step("explains why line 2 bumped, applies the fix and passes the place", async () => {
    await explainsAndFixes(corridor);
    await startOver(corridor);
  });
  await test.step("replays the bump, and shows its card again where it happened", async () => {
    await replaysTheBump(corridor);
    await startOver(corridor);
  });
  await test.step("offers to run from the start after a line was fixed by hand, shows the figures of the solution, and opens the next maze", () =>
    showsTheSolution(corridor));
  await test.step("reports that the robot only pushes against a wall, or drives in circles, and names no line where two must change", async () => {
    await corridor.choosePreset("Long way round");
    await reportsPushingAndCircles(corridor);
    await startOver(corridor);
  });
  await test.step("reports that a turn came too early, though another line met the wall", () =>
    reportsTurnTooEarly(corridor));
});

/**
 * Messages that cover a card, a control of the run or the controls that return to now, with what
 * they cover.
 */
function coveredByMessages(page: Page): Promise<string[]> {
  return page.evaluate(() => {
    const texts = [...document.querySelectorAll("section[aria-label=Messages] button")];
    const messages = new Set(texts.map((button) => button.parentElement));
    const uncovered = document.querySelectorAll(
      "[data-card], section[aria-label=Run] button, section[aria-label=Run] select",
    );
    return [...messages].flatMap((message) => {
      const one = message?.getBoundingClientRect();
      if (one === undefined) return [];
      return [...uncovered].flatMap((each) => {
        if (!each.checkVisibility()) return [];
        const other = each.getBoundingClientRect();
        const isOver =
          Math.min(one.right, other.right) - Math.max(one.left, other.left) > 1 &&
          Math.min(one.bottom, other.bottom) - Math.max(one.top, other.top) > 1;
        return isOver ? [`${message?.textContent} | ${each.textContent}`] : [];
      });
    });
  });
}

const backward = {
  east: { dx: -1, dy: 0 },
  west: { dx: 1, dy: 0 },
  north: { dx: 0, dy: 1 },
  south: { dx: 0, dy: -1 },
};

/** Cards and messages that cover the robot, the end of its trail, a button of the run or a tab. */
async function coveredByCards(
  corridor: CorridorPage,
  { start }: (typeof bumps)[number],
): Promise<string[]> {
  const { page } = corridor;
  const [, x = "0", y = "0"] =
    /^Robot at (\d+), (\d+)/.exec((await corridor.robotPose.textContent()) ?? "") ?? [];
  const grid = await corridor.maze.grid.boundingBox();
  if (grid === null) throw new Error("the maze is not on the screen");
  const scale = grid.width / (mazeSize.columns * 100);
  // Its centre and 20 cm around.
  const robot = {
    left: grid.x + (Number(x) - 20) * scale,
    top: grid.y + (Number(y) - 20) * scale,
    right: grid.x + (Number(x) + 20) * scale,
    bottom: grid.y + (Number(y) + 20) * scale,
  };
  // The last 100 cm of its trail: the robot drove forward to its centre.
  const { dx, dy } = backward[start.heading];
  const [endX, endY] = [Number(x) + 100 * dx, Number(y) + 100 * dy];
  const trail = {
    left: grid.x + (Math.min(Number(x), endX) - 5) * scale,
    top: grid.y + (Math.min(Number(y), endY) - 5) * scale,
    right: grid.x + (Math.max(Number(x), endX) + 5) * scale,
    bottom: grid.y + (Math.max(Number(y), endY) + 5) * scale,
  };
  return page.evaluate(
    ([robotBox, trailBox]) => {
      const over = [
        ...document.querySelectorAll(
          "[data-card], section[aria-label=Messages] span:has(> button)",
        ),
      ];
      const uncovered = [
        ...document.querySelectorAll("section[aria-label=Run] button, [role=tab]"),
      ].filter((each) => each.checkVisibility());
      const boxes = [
        { name: "robot", box: robotBox },
        { name: "trail's end", box: trailBox },
        ...uncovered.map((each) => ({ name: each.textContent, box: each.getBoundingClientRect() })),
      ];
      return over.flatMap((each) => {
        const one = each.getBoundingClientRect();
        return boxes.flatMap(({ name, box }) =>
          Math.min(one.right, box.right) - Math.max(one.left, box.left) > 1 &&
          Math.min(one.bottom, box.bottom) - Math.max(one.top, box.top) > 1
            ? [`${each.textContent} | ${name}`]
            : [],
        );
      });
    },
    [robot, trail] as const,
  );
}

const screens = [
  { width: 1440, height: 900 },
  { width: 1024, height: 768 },
  { width: 844, height: 390 },
  { width: 390, height: 844 },
  { width: 320, height: 640 },
];

const mazeSize = { columns: 11, rows: 9 };

/** Bumps straight ahead of the start: in the middle of the maze, in corners and at edges. */
const bumps = [
  { start: { column: 2, row: 4, heading: "east" }, block: { column: 6, row: 4 } },
  { start: { column: 5, row: 3, heading: "south" }, block: null },
  { start: { column: 5, row: 3, heading: "north" }, block: null },
  { start: { column: 3, row: 0, heading: "west" }, block: null },
  { start: { column: 7, row: 8, heading: "east" }, block: null },
] as const;

function linkTo({ start, block }: (typeof bumps)[number]): string {
  const blocks = Array.from({ length: mazeSize.rows }, (_, row) =>
    Array.from({ length: mazeSize.columns }, (__, column) =>
      block?.column === column && block.row === row ? "#" : ".",
    ).join(""),
  );
  const maze = { format: "corridor/maze", version: 1, name: "", blocks, start, goals: [] } as const;
  const program = {
    format: "corridor/program",
    version: 1,
    name: "",
    default: "forward",
    rules: [],
  } as const;
  const link = encodeLink({ maze: { ...maze, goals: [] }, program: { ...program, rules: [] } });
  if (!link.ok) throw new Error(link.code);
  return link.text;
}

async function coverNeitherRobotNorControls(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  for (const [at, bump] of screens.flatMap((size) => bumps.map((each) => [size, each] as const))) {
    await page.setViewportSize(at);
    await page.evaluate((hash) => (location.hash = hash), linkTo(bump));
    await expect(corridor.program.lines).toHaveCount(0);
    await expect(corridor.clock).toHaveText("Time 0:00.0");
    await corridor.dismissMessages();
    await corridor.run.click();
    const card = page.getByRole("region", { name: /^Bump/ });
    await expect(card).toBeVisible();
    await page.evaluate(() => navigator.clipboard.writeText("hello"));
    await page.keyboard.press("ControlOrMeta+V");
    await expect(corridor.message(/^The text you pasted/).first()).toBeVisible();
    await waitForAnimations(page);
    expect(await coveredByCards(corridor, bump), JSON.stringify([at, bump])).toEqual([]);
    await expect(card.getByRole("heading")).toBeInViewport({ ratio: 1 });
    await corridor.reset.click();
    await corridor.dismissMessages();
  }
}

/** The messages cover neither the card nor the transport. */
async function showTwoMessagesBesideCard(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  await corridor.program.action(2).selectOption("delayed left 90");
  const card = corridor.bumpCard(2);
  for (const [width, height] of [
    [1440, 900],
    [1024, 768],
    [768, 1024],
    [844, 390],
    [390, 844],
  ] as const) {
    await page.setViewportSize({ width, height });
    await corridor.run.click();
    await expect(card).toBeVisible();
    await page.keyboard.press("i");
    await holdMessage(corridor);
    await page.evaluate((hash) => (location.hash = hash), `broken${width}`);
    await expect(corridor.messages.getByRole("button", { name: "Dismiss" })).toHaveCount(2);
    await waitForAnimations(page);
    expect(await coveredByMessages(page), `beside the card, ${width} px`).toEqual([]);
    await card.getByRole("button", { name: "Close" }).click();
    await corridor.timeline.slider.press("Home");
    await expect(corridor.timeline.pastLabel).toBeVisible();
    await page.keyboard.press("i");
    await waitForAnimations(page);
    expect(await coveredByMessages(page), `in the past, ${width} px`).toEqual([]);
    await corridor.timeline.backToNow.click();
    await corridor.reset.click();
    await corridor.dismissMessages();
  }
}

test("covers neither the robot nor controls with cards and messages at any size", async ({
  corridor,
}) => {
  test.slow();
  await corridor.speed.selectOption("max");
  await test.step("two messages beside a card, and in the past", () =>
    showTwoMessagesBesideCard(corridor));
  await test.step("a card and a message, wherever the robot bumps", () =>
    coverNeitherRobotNorControls(corridor));
});
