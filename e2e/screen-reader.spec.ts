/**
 * A full session through what a screen reader uses: roles, names, values, descriptions and live
 * region announcements. No check uses the visual display.
 */
import type { Page } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import { CorridorPage } from "./pages/corridor-page.ts";
import { LessonsPanel } from "./pages/lessons-panel.ts";
import { clearStorageOnLoad } from "./support/clear-storage.ts";
import { KeyboardUser } from "./support/keyboard-user.ts";
import { smallWindow } from "./support/window-sizes.ts";

test.use(smallWindow);

/** Records every announcement of the live region from now on. */
async function recordAnnouncements(
  page: Page,
): Promise<() => Promise<{ text: string; at: number }[]>> {
  await page.evaluate(() => {
    const announcements: { text: string; at: number }[] = [];
    Object.assign(globalThis, { announcements });
    const liveRegion = document.querySelector("output#spoken");
    if (liveRegion === null) throw new Error("the page has no live region");
    new MutationObserver(() => {
      const text = liveRegion.textContent ?? "";
      if (text !== "") announcements.push({ text, at: performance.now() });
    }).observe(liveRegion, { childList: true, subtree: true, characterData: true });
  });
  return () =>
    page.evaluate(() => (globalThis as unknown as { announcements: never[] }).announcements);
}

test("names and describes the page, its maze and its robot, and turns run announcements off", async ({
  corridor,
  page,
}) => {
  await test.step("has landmarks, headings and lists for navigation", async () => {
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
      corridor
        .dialog("Share this maze")
        .getByRole("heading", { level: 2, name: "Share this maze" }),
    ).toBeVisible();
    await page.keyboard.press("Escape");
    // Heading levels are not skipped on the way down.
    const levels = await page
      .getByRole("heading")
      .evaluateAll((headings) => headings.map(({ tagName }) => Number(tagName.slice(1))));
    for (const [at, level] of levels.entries()) {
      expect(level).toBeLessThanOrEqual((levels[at - 1] ?? 0) + 1);
    }
    await expect(corridor.program.region.getByRole("list").getByRole("listitem")).toHaveCount(2);
  });
  await test.step("names every control", async () => {
    const unnamed = await page
      .locator("button:visible, input:visible, select:visible, a:visible, [role=grid] td")
      .evaluateAll((controls) =>
        controls
          .filter((control) => {
            const labels = control instanceof HTMLInputElement ? (control.labels ?? []) : [];
            const names = [
              control.getAttribute("aria-label"),
              control.textContent,
              control.getAttribute("title"),
              ...Array.from(labels, (label) => label.textContent),
            ];
            return names.every((name) => (name ?? "").trim() === "");
          })
          .map(({ outerHTML }) => outerHTML.slice(0, 100)),
      );
    expect(unnamed).toEqual([]);
  });
  await test.step("describes the maze as a grid, square by square", async () => {
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
    // The page contains only the squares around the cursor, however large the maze is.
    expect(await maze.grid.getByRole("gridcell").count()).toBeLessThanOrEqual(9);
  });
  // In a small window, Describe is in a menu.
  await page.setViewportSize({ width: 1440, height: 900 });
  await test.step("describes the robot on request, once as an announcement and once as text", async () => {
    const announcements = await recordAnnouncements(page);
    const description =
      "At 0.0 s the robot is in row 7, column 1, facing right. Front is 250 cm, right 50 cm, back 50 cm, left 50 cm. No line is true, so “otherwise” decides: forward.";
    await page.keyboard.press("i");
    await expect(corridor.announcement).toHaveText(description);
    await expect(corridor.message(description)).toBeVisible();
    await corridor.maze.cursor.focus();
    await page.keyboard.press("i");
    await expect.poll(async () => (await announcements()).length).toBe(2);
    await expect(corridor.message(description)).toHaveCount(1);

    // The button describes another tick: the line that runs after a step, with its truth value.
    await page.keyboard.press("Control+Shift+Enter");
    await expect(corridor.message(description)).toHaveCount(0);
    await expect(corridor.program.line(2)).toHaveAttribute("aria-current", "step");
    await expect(corridor.run).toBeVisible();
    await page.getByRole("button", { name: "Describe" }).press("Enter");
    await expect(
      corridor.message(
        /^At \d+\.\d s the robot is in row \d, column \d, facing [a-z ]+\. .*Line 2: if front is less than 50, left 90\. Front is [\d.]+, true\.$/,
      ),
    ).toBeVisible();
  });
  await test.step("gives full names and no bare numbers in the transport", async () => {
    await expect(corridor.timeline.slider).toBeVisible();
    const snapshot = await corridor.transport.ariaSnapshot();
    expect(snapshot).not.toMatch(/text: "?\d+"?$/m);
  });
  await test.step("turns run announcements off, still answers requests, and stores the choice across a reload", async () => {
    await corridor.reset.click();
    await expect(corridor.clock).toHaveText("Time 0:00.0");
    await page.keyboard.press("?");
    const list = corridor.dialog("Keyboard shortcuts");
    await list.getByRole("checkbox", { name: /^Read the run aloud/ }).uncheck();
    await page.keyboard.press("Escape");
    await corridor.reload();
    const announcements = await recordAnnouncements(page);
    await corridor.speed.selectOption("max");
    await page.keyboard.press("Control+Enter");
    await expect(page.getByRole("region", { name: "Solved!" })).toBeVisible();
    expect(await announcements()).toEqual([]);
    await page.keyboard.press("i");
    await expect(corridor.announcement).toHaveText(/^At 39\.6 s the robot is in row 1, column 11/);
  });
});

test("announces the deciding lines in order, at most once a second, and each decision only once", async ({
  corridor,
  page,
}) => {
  test.slow();
  // At the slowest speed, each line lasts longer than its announcement, also on a busy machine.
  await corridor.speed.selectOption("0.25×");
  const announcements = await recordAnnouncements(page);
  await page.keyboard.press("Control+Enter");
  await expect(corridor.announcement).toHaveText("Line 1: delayed right 90. Right is 248.3 cm.", {
    timeout: 90_000,
  });
  await page.keyboard.press("Control+Enter");
  await expect(corridor.announcement).toHaveText(/^Paused at \d+\.\d s\.$/);
  const recorded = await announcements();
  expect(recorded.map(({ text }) => text).slice(0, 4)).toEqual([
    // The code for announcements loads with the first run, so the robot may already have moved.
    expect.stringMatching(/^Otherwise: forward\. Front is [\d.]+ cm\.$/),
    "Line 2: left 90. Front is 48.3 cm.",
    // On a busy machine, the announcement is some ticks after the turn.
    expect.stringMatching(/^Otherwise: forward\. Front is 2[45]\d(\.\d)? cm\.$/),
    "Line 1: delayed right 90. Right is 248.3 cm.",
  ]);
  const gaps = recorded.slice(1).map(({ at }, before) => at - (recorded[before]?.at ?? 0));
  // A timer may fire slightly early by the page's own clock.
  expect(Math.min(...gaps)).toBeGreaterThan(900);
  // No announcement without a change.
  await corridor.waitForFrames(90);
  expect(await announcements()).toHaveLength(recorded.length);
});

test("builds, programs, bumps, fixes, goes back and solves with a screen reader, also a mission", async ({
  corridor,
  page,
}) => {
  test.slow();
  const user = new KeyboardUser(page);
  await test.step("maze and program", async () => {
    const announcements = await recordAnnouncements(page);
    const { maze, program, timeline } = corridor;
    // Add a block and remove it.
    await maze.moveCursorTo({ column: 2, row: 6 });
    await user.key("Space");
    await expect(corridor.announcement).toHaveText("row 7, column 3, block");
    await user.key("Space");
    await expect(corridor.announcement).toHaveText("row 7, column 3, open");

    // An announcement gives the advice on the wrong line, and the line's name includes it.
    await user.choose(program.action(2), "delayed left 90");
    await expect(corridor.announcement).toHaveText(
      /^Advice for line 2: front < 50 leaves too little room/,
    );
    await expect(program.line(2)).toHaveAccessibleName(
      /^Line 2: if front is less than 50, delayed left 90\. Front is 250, false.* Advice: /,
    );

    await user.press(corridor.run);
    await expect(corridor.announcement).toHaveText(
      /^Bump: look at line 2\. Bump at \d+\.\d s\. Line 2 chose “delayed left 90” at \d+\.\d s with (4\d|50) cm in front\. It drives on first and needs 75 cm\. The bump card offers \d fix(es)?\.$/,
    );
    await expect(program.line(2)).toHaveAccessibleName(/^Line 2, look here: /);
    const card = corridor.bumpCard(2);
    await user.press(card.getByRole("button", { name: "Change to left 90" }));
    await expect(corridor.announcement).toHaveText(/^Fixed\./);

    // The slider's value describes its tick. The live region announces only the switch to the past.
    await user.tabTo(timeline.slider);
    await user.key("Home");
    await expect(timeline.slider).toHaveAttribute("aria-valuetext", /^0\.0 s/);
    await expect(corridor.announcement).toHaveText("You see an earlier moment of the run.");
    await user.press(timeline.backToNow);
    await expect(corridor.announcement).toHaveText(/^Back to now, \d+\.\d s\.$/);

    await user.press(corridor.reset);
    await expect(corridor.announcement).toHaveText("The robot is back at its start.");
    await user.choose(corridor.speed, "max");
    await user.key("Control+Enter");
    await expect(corridor.announcement).toHaveText(
      "Goal reached after 39.6 s (tick 2380), in row 1, column 11, by “otherwise”.",
    );
    await expect(page.getByRole("region", { name: "Solved!" })).toBeVisible();
    // The fast run announced only its end, and nothing twice.
    const texts = (await announcements()).map(({ text }) => text);
    expect(texts.slice(-2)).toEqual([
      "The robot is back at its start.",
      "Goal reached after 39.6 s (tick 2380), in row 1, column 11, by “otherwise”.",
    ]);
    const results = texts.filter((text) => /^(Bump|Goal|Advice|Fixed)/.test(text));
    expect(new Set(results).size).toBe(results.length);
  });
  await test.step("solves a mission: its task, its hint, its outcome", async () => {
    const lessons = new LessonsPanel(page);
    await user.press(page.getByRole("banner").getByRole("button", { name: "Lessons" }));
    await expect(lessons.path.getByRole("button", { name: /^\d+\. / })).toHaveCount(14);
    await user.press(lessons.path.getByRole("button", { name: /^3\. / }));
    await expect(lessons.card.getByRole("heading", { level: 2 })).toBeVisible();
    await user.press(lessons.button("Show a hint"));
    await expect(lessons.card.getByRole("listitem")).toHaveCount(1);
    const announcements = await recordAnnouncements(page);
    await user.choose(corridor.program.action(1), "turn 180");
    await user.choose(corridor.speed, "16×");
    await user.key("Control+Enter");
    await expect(corridor.announcement).toHaveText("Task solved. Lines used: 1 of 1");
    const texts = (await announcements()).map(({ text }) => text);
    expect(texts.filter((text) => text.startsWith("Task solved"))).toHaveLength(1);
  });
});

test("says last that the robot is back, and one verdict of a failed mission", async ({ page }) => {
  const corridor = new CorridorPage(page);
  const lessons = new LessonsPanel(page);
  await clearStorageOnLoad(page);
  let delay = 0;
  await page.route("**/announce-run-*.js", async (route) => {
    // A slow network. The wait does not replace an expectation.
    await page.waitForTimeout(delay);
    await route.continue();
  });
  for (const milliseconds of [0, 1000]) {
    await test.step(`with announcements that load ${milliseconds} ms late`, async () => {
      delay = milliseconds;
      await corridor.open();
      await lessons.openMission(6);
      await corridor.speed.selectOption("max");
      const loaded = page.waitForResponse("**/announce-run-*.js");
      await corridor.run.click();
      await expect(lessons.outcome).toHaveText(/^Bump at /);
      await corridor.reset.click();
      await loaded;
      await expect(corridor.announcement).toHaveText("The robot is back at its start.");
    });
  }
  await test.step("one verdict, and nothing of it after Reset", async () => {
    const announcements = await recordAnnouncements(page);
    await corridor.run.click();
    await expect(lessons.outcome).toHaveText(/^Bump at .* A line for this place is missing\.$/);
    const verdict = (await lessons.outcome.textContent()) ?? "";
    await expect(corridor.announcement).toHaveText(verdict);
    await corridor.reset.click();
    await expect(lessons.outcome).toHaveCount(0);
    await expect(corridor.announcement).toHaveText("The robot is back at its start.");
    const texts = (await announcements()).map(({ text }) => text);
    expect(texts.filter((text) => /^(Bump at|Time is up)|Press Reset/.test(text))).toEqual([
      verdict,
    ]);
  });
});
