/**
 * The whole loop by what a screen reader is given: roles, names, values, descriptions and the
 * messages of the live region. Nothing is looked at.
 */
import type { Page } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import { LessonsPanel } from "./pages/lessons-panel.ts";
import { KeyboardUser } from "./support/keyboard-user.ts";

/** Notes every message of the page's one voice, from now on. */
async function listen(page: Page): Promise<() => Promise<{ text: string; at: number }[]>> {
  await page.evaluate(() => {
    const heard: { text: string; at: number }[] = [];
    Object.assign(globalThis, { heard });
    const voice = document.querySelector("output#spoken");
    if (voice === null) throw new Error("the page has no voice");
    new MutationObserver(() => {
      const text = voice.textContent ?? "";
      if (text !== "") heard.push({ text, at: performance.now() });
    }).observe(voice, { childList: true, subtree: true, characterData: true });
  });
  return () => page.evaluate(() => (globalThis as unknown as { heard: never[] }).heard);
}

test("finds its way by landmarks, headings and lists", async ({ corridor, page }) => {
  await expect(page.locator("html")).toHaveAttribute("lang", "en");
  await expect(page.locator("html")).toHaveAttribute("dir", "ltr");
  await expect(page.getByRole("banner")).toHaveCount(1);
  await expect(page.getByRole("main")).toHaveCount(1);
  await expect(page.getByRole("complementary", { name: "Driving" })).toHaveCount(1);
  for (const name of ["Maze", "Program", "Run"]) {
    await expect(page.getByRole("region", { name, exact: true })).toHaveCount(1);
  }
  await expect(page.getByRole("heading", { level: 1 })).toHaveCount(1);
  await expect(page.getByRole("heading", { level: 1 })).toHaveText(/Corridor/);
  await corridor.share.click();
  await expect(
    corridor.dialog("Share this maze").getByRole("heading", { level: 2, name: "Share this maze" }),
  ).toBeVisible();
  await page.keyboard.press("Escape");
  // No level is left out on the way down.
  const levels = await page
    .getByRole("heading")
    .evaluateAll((headings) => headings.map(({ tagName }) => Number(tagName.slice(1))));
  for (const [at, level] of levels.entries()) {
    expect(level).toBeLessThanOrEqual((levels[at - 1] ?? 0) + 1);
  }
  await expect(corridor.program.region.getByRole("list").getByRole("listitem")).toHaveCount(2);
});

test("names everything that can be pressed, typed into or chosen", async ({ page }) => {
  const nameless = await page
    .locator("button:visible, input:visible, select:visible, a:visible, [role=grid] td")
    .evaluateAll((controls) =>
      controls
        .filter((control) => {
          const labels = control instanceof HTMLInputElement ? (control.labels ?? []) : [];
          const words = [
            control.getAttribute("aria-label"),
            control.textContent,
            control.getAttribute("title"),
            ...Array.from(labels, (label) => label.textContent),
          ];
          return words.every((word) => (word ?? "").trim() === "");
        })
        .map(({ outerHTML }) => outerHTML.slice(0, 100)),
    );
  expect(nameless).toEqual([]);
});

test("knows the maze as a grid, square by square", async ({ corridor }) => {
  const { maze } = corridor;
  await expect(maze.grid).toHaveAttribute("aria-rowcount", "7");
  await expect(maze.grid).toHaveAttribute("aria-colcount", "11");
  await expect(maze.grid).toHaveAccessibleDescription(/^Arrow keys move from square to square\./);
  await expect(maze.cursor).toHaveAccessibleName(
    "row 7, column 1, open, start, facing right, robot here, facing right",
  );
  await expect(maze.cursor).toHaveRole("gridcell");
  await maze.expectSquare({ column: 3, row: 6 }, "block");
  await maze.expectSquare({ column: 10, row: 0 }, "open, goal");
  // Only the squares around the cursor exist in the page, however large the maze is.
  expect(await maze.grid.getByRole("gridcell").count()).toBeLessThanOrEqual(9);
});

test("hears the lines as they drive, in order, at most one message a second, and each only once", async ({
  corridor,
  page,
}) => {
  test.slow();
  // As slow as it goes, so that each line lasts longer than its sentence, on a busy machine too.
  await corridor.speed.selectOption("0.25×");
  const heard = await listen(page);
  await page.keyboard.press("Control+Enter");
  await expect(corridor.announcement).toHaveText("Line 1: delayed right 90. Right is 248.3 cm.", {
    timeout: 90_000,
  });
  await page.keyboard.press("Control+Enter");
  await expect(corridor.announcement).toHaveText(/^Paused at \d+\.\d s\.$/);
  const said = await heard();
  expect(said.map(({ text }) => text).slice(0, 4)).toEqual([
    // What says it comes with the first run: the robot may have gone some way.
    expect.stringMatching(/^Otherwise: forward\. Front is [\d.]+ cm\.$/),
    "Line 2: left 90. Front is 48.3 cm.",
    // A busy machine tells it some ticks after the turn.
    expect.stringMatching(/^Otherwise: forward\. Front is 2[45]\d(\.\d)? cm\.$/),
    "Line 1: delayed right 90. Right is 248.3 cm.",
  ]);
  const gaps = said.slice(1).map(({ at }, before) => at - (said[before]?.at ?? 0));
  // A timer may ring a little early by the page's own clock.
  expect(Math.min(...gaps)).toBeGreaterThan(900);
  // Nothing changes: nothing is said.
  await corridor.waitForFrames(90);
  expect(await heard()).toHaveLength(said.length);
});

test("builds, programs, bumps, mends, goes back and solves by ear", async ({ corridor, page }) => {
  test.slow();
  const heard = await listen(page);
  const keys = new KeyboardUser(page);
  const { maze, program, timeline } = corridor;
  // A block is put and taken away again.
  await maze.moveCursorTo({ column: 2, row: 6 });
  await keys.key("Space");
  await expect(corridor.announcement).toHaveText("row 7, column 3, block");
  await keys.key("Space");
  await expect(corridor.announcement).toHaveText("row 7, column 3, open");

  // The line that is chosen wrong is told with its reason, and says so by its own name.
  await keys.choose(program.action(2), "delayed left 90");
  await expect(corridor.announcement).toHaveText(
    /^Advice for line 2: front < 50 leaves too little room/,
  );
  await expect(program.line(2)).toHaveAccessibleName(
    /^Line 2: if front is less than 50, delayed left 90\. Front is 250, false.* Advice: /,
  );

  await keys.press(corridor.run);
  await expect(corridor.announcement).toHaveText(
    /^Bump: look at line 2\. Bump at \d+\.\d s\. Line 2 chose “delayed left 90” at \d+\.\d s with (4\d|50) cm in front\. It drives on first and needs 75 cm\. The bump card offers \d fix(es)?\.$/,
    { timeout: 30_000 },
  );
  await expect(program.line(2)).toHaveAccessibleName(/^Line 2, bumped: /);
  const card = corridor.bumpCard(2);
  await keys.press(card.getByRole("button", { name: "Change to left 90" }));
  await expect(corridor.announcement).toHaveText(/^Fixed\./);

  // The slider says its moments itself; the voice only that it is the past.
  await keys.tabTo(timeline.slider);
  await keys.key("Home");
  await expect(timeline.slider).toHaveAttribute("aria-valuetext", /^0\.0 s/);
  await expect(corridor.announcement).toHaveText("You see an earlier moment of the run.");
  await keys.press(timeline.backToNow);
  await expect(corridor.announcement).toHaveText(/^Back to now, \d+\.\d s\.$/);

  await keys.press(corridor.reset);
  await expect(corridor.announcement).toHaveText("The robot is back at its start.");
  await keys.choose(corridor.speed, "max");
  await keys.key("Control+Enter");
  await expect(corridor.announcement).toHaveText(
    "Goal reached after 39.6 s (tick 2380), in row 1, column 11, by “otherwise”.",
  );
  await expect(page.getByRole("region", { name: "Solved!" })).toBeVisible();
  // The fast run was quiet but for its end, and no news was said twice.
  const texts = (await heard()).map(({ text }) => text);
  expect(texts.slice(-2)).toEqual([
    "The robot is back at its start.",
    "Goal reached after 39.6 s (tick 2380), in row 1, column 11, by “otherwise”.",
  ]);
  const news = texts.filter((text) => /^(Bump|Goal|Advice|Mended)/.test(text));
  expect(new Set(news).size).toBe(news.length);
});

test("asks where the robot is, and is told once, in words that can be read too", async ({
  corridor,
  page,
}) => {
  const heard = await listen(page);
  const description =
    "At 0.0 s the robot is in row 7, column 1, facing right. Front is 250 cm, right 50 cm, back 50 cm, left 50 cm. No line is true, so “otherwise” decides: forward.";
  await page.keyboard.press("i");
  await expect(corridor.announcement).toHaveText(description);
  await expect(corridor.message(description)).toBeVisible();
  await corridor.maze.cursor.focus();
  await page.keyboard.press("i");
  await expect.poll(async () => (await heard()).length).toBe(2);
  await expect(corridor.message(description)).toHaveCount(1);

  // Another moment, by the button: the line that runs after a step, with its truth.
  await page.keyboard.press("Control+Shift+Enter");
  await expect(corridor.message(description)).toHaveCount(0);
  await expect(corridor.program.line(2)).toHaveAttribute("aria-current", "step");
  await expect(corridor.run).toBeVisible();
  await page.getByRole("button", { name: "Describe" }).press("Enter");
  await expect(
    corridor.message(
      /^At \d+\.\d s the robot is in row \d, column \d, facing [a-z ]+\. .*Line 2, running: if front is less than 50, left 90\. Front is [\d.]+, true\.$/,
    ),
  ).toBeVisible();
});

test("switches the spoken run off, still hears answers, and finds it off after a reload", async ({
  corridor,
  page,
}) => {
  await page.keyboard.press("?");
  const list = corridor.dialog("Keyboard shortcuts");
  await list.getByRole("checkbox", { name: /^Read the run aloud/ }).uncheck();
  await page.keyboard.press("Escape");
  await corridor.reload();
  const heard = await listen(page);
  await corridor.speed.selectOption("max");
  await page.keyboard.press("Control+Enter");
  await expect(page.getByRole("region", { name: "Solved!" })).toBeVisible();
  expect(await heard()).toEqual([]);
  await page.keyboard.press("i");
  await expect(corridor.announcement).toHaveText(/^At 39\.6 s the robot is in row 1, column 11/);
});

test("does a mission by ear: its task, its hint, its outcome", async ({ corridor, page }) => {
  const keys = new KeyboardUser(page);
  const lessons = new LessonsPanel(page);
  await keys.press(page.getByRole("banner").getByRole("button", { name: "Lessons" }));
  await expect(lessons.path.getByRole("button", { name: /^\d+\. / })).toHaveCount(14);
  await keys.press(lessons.path.getByRole("button", { name: /^3\. / }));
  await expect(lessons.card.getByRole("heading", { level: 2 })).toBeVisible();
  await keys.press(lessons.button("Show a hint"));
  await expect(lessons.card.getByRole("listitem")).toHaveCount(1);
  const heard = await listen(page);
  await keys.choose(corridor.program.action(1), "turn 180");
  await keys.choose(corridor.speed, "16×");
  await keys.key("Control+Enter");
  await expect(corridor.announcement).toHaveText("Challenge solved. Lines used: 1 of 1");
  const texts = (await heard()).map(({ text }) => text);
  expect(texts.filter((text) => text.startsWith("Challenge solved"))).toHaveLength(1);
});

test("hears of the transport whole names, and no number without a word", async ({ corridor }) => {
  await corridor.step.click();
  await expect(corridor.run).toBeVisible();
  await expect(corridor.timeline.slider).toBeVisible();
  const heard = await corridor.transport.ariaSnapshot();
  expect(heard).not.toMatch(/text: "?\d+"?$/m);
});
