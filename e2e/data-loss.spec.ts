/** Edits are never lost, whatever happens to the page, the device or the network. */
import { CorridorPage } from "./pages/corridor-page.ts";
import { expect, test } from "./fixtures.ts";

/** Far from the robot. */
const square = { column: 9, row: 6 };

/** Every project stored on the device, as text. */
function projectsOf({ page }: CorridorPage): Promise<string[]> {
  return page.evaluate(() =>
    Object.entries(localStorage)
      .filter(([key]) => key.startsWith("corridor.work."))
      .map(([, text]) => String(text)),
  );
}

async function keepsDamagedEntry(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  await corridor.program.name.fill("Before the damage");
  await expect(corridor.saveState).toHaveText("Saved on this device");
  const damaged = await page.evaluate(() => {
    const key = Object.keys(localStorage).find((each) => each.startsWith("corridor.work."));
    if (key === undefined) throw new Error("nothing is saved");
    const text = (localStorage.getItem(key) ?? "").slice(0, -20);
    localStorage.setItem(key, text);
    return text;
  });
  await corridor.program.name.fill("After the damage");
  await expect.poll(async () => (await projectsOf(corridor)).join()).toContain("After the damage");
  const stored = await page.evaluate(() => Object.values(localStorage).map(String));
  expect(stored).toContain(damaged);
  await corridor.reload();
  await expect(corridor.program.name).toHaveValue("After the damage");
}

/** @returns the page of another tab, which the user has now */
async function keepsLatestEdits(corridor: CorridorPage): Promise<CorridorPage> {
  const { page } = corridor;
  const context = page.context();
  await test.step("an edit is stored within 300 ms without any action", async () => {
    await corridor.program.name.selectText();
    const steps = await page.evaluate(async () => {
      document.execCommand("insertText", false, "Typed just now");
      const isStored = () =>
        Object.values(localStorage).some((text) => String(text).includes("Typed just now"));
      // Counts timer steps of 10 ms instead of time, so that a slow machine does not fail the test.
      let count = 0;
      for (; !isStored() && count < 100; count++) {
        await new Promise((resolve) => setTimeout(resolve, 10));
      }
      return count;
    });
    expect(steps).toBeGreaterThan(0);
    expect(steps).toBeLessThanOrEqual(30);
    await corridor.reload();
    await expect(corridor.program.name).toHaveValue("Typed just now");
  });

  let next = corridor;
  await test.step("an edit right before the tab is closed", async () => {
    await corridor.maze.click(square);
    await corridor.page.close({ runBeforeUnload: true });
    next = new CorridorPage(await context.newPage());
    await next.open();
    await next.maze.expectSquare(square, "block");
  });

  await test.step("edits during a run, when the page is reloaded in the middle of it", async () => {
    await next.run.click();
    await expect(next.robotPose).not.toHaveText("Robot at 50, 650, facing right");
    await next.maze.click({ column: 10, row: 6 });
    await next.program.number(1).fill("75");
    await expect(next.pause).toBeVisible();
    await next.reload();
    await next.maze.expectSquare({ column: 10, row: 6 }, "block");
    await expect(next.program.number(1)).toHaveValue("75");
  });
  return next;
}

async function returnsAfterLinks(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  await test.step("a link that opens before an edit is saved", async () => {
    const shared = await corridor.program.name.inputValue();
    const link = await corridor.shareLink({ withProgram: true });
    await corridor.program.name.fill("Mine, and not saved yet");
    // Immediately, before autosave runs.
    await page.evaluate((address) => (location.hash = new URL(address).hash), link);
    await expect(corridor.program.name).toHaveValue(shared);
    await expect(corridor.message("Your own maze and program are saved.")).toBeVisible();
    await corridor.messages.getByRole("button", { name: "Back to my maze" }).click();
    await expect(corridor.program.name).toHaveValue("Mine, and not saved yet");
  });

  const links: string[] = [];
  for (const preset of ["Spiral", "Comb"]) {
    await corridor.choosePreset(preset);
    links.push(await corridor.shareLink({ withProgram: false }));
  }
  await corridor.choosePreset("Tree");
  await corridor.program.name.fill("Mine");
  await expect(corridor.saveState).toHaveText("Saved on this device");
  await test.step("two links in the open page", async () => {
    await corridor.dismissMessages();
    for (const [at, link] of links.entries()) {
      await page.evaluate((address) => (location.hash = new URL(address).hash), link);
      await expect(corridor.mazeMenu).toHaveAccessibleName(`${["Spiral", "Comb"][at]}, Maze menu`);
    }
    await corridor.messages.getByRole("button", { name: "Back to my maze" }).first().click();
    await expect(corridor.mazeMenu).toHaveAccessibleName("Tree, Maze menu");
    await expect(corridor.program.name).toHaveValue("Mine");
  });

  await test.step("links from elsewhere", async () => {
    for (const link of links) {
      await page.goto("about:blank");
      await corridor.open(link);
    }
    await expect(corridor.mazeMenu).toHaveAccessibleName("Comb, Maze menu");
    await corridor.messages.getByRole("button", { name: "Back to my maze" }).click();
    await expect(corridor.mazeMenu).toHaveAccessibleName("Tree, Maze menu");
  });
}

test("keeps edits whatever happens to the page", async ({ corridor }) => {
  await test.step("keeps both entries when one tab edits a project that another tab damaged", () =>
    keepsDamagedEntry(corridor));
  const next =
    await test.step("keeps an edit that was typed just now, made during a run, or right before the tab is closed", () =>
      keepsLatestEdits(corridor));
  await test.step("returns to the user's own maze and edits after opening links", () =>
    returnsAfterLinks(next));
});

test("reports that a part did not load, while the rest works, and loads it with Try again", async ({
  browser,
  relay,
}) => {
  // Not an openWindow fixture: the browser logs an error for the missing file, as expected.
  const context = await browser.newContext({ baseURL: relay, serviceWorkers: "block" });
  const corridor = new CorridorPage(await context.newPage());
  let isDown = true;
  await corridor.page.route(/assets\/ResizeDialog-/, (route) =>
    isDown ? route.abort() : route.continue(),
  );
  await corridor.page.route(/assets\/zoom-gestures-/, (route) => route.abort());
  await corridor.open();
  // The zoom: the rest works.
  await corridor.maze.grid.hover();
  await expect(corridor.messages).toContainText("A part of Corridor did not load.");
  await corridor.maze.click({ column: 4, row: 6 });
  await expect(corridor.maze.button("Undo")).toBeEnabled();

  await corridor.program.name.fill("Retained");
  await corridor.maze.button("Resize").click();
  const failure = corridor.dialog("This part did not load");
  await expect(failure).toContainText("Nothing is lost.");
  // Still down, and the service too: the page stays usable.
  await corridor.page.route("**/healthz", (route) => (isDown ? route.abort() : route.continue()));
  const retried = corridor.page.waitForEvent("requestfailed", (request) =>
    request.url().endsWith("/healthz"),
  );
  await failure.getByRole("button", { name: "Try again" }).click();
  await retried;
  await expect(failure).toBeVisible();
  await expect(corridor.program.name).toHaveValue("Retained");
  isDown = false;
  await failure.getByRole("button", { name: "Try again" }).click();
  await expect(corridor.dialog("Resize the maze")).toBeVisible();
  await corridor.page.keyboard.press("Escape");
  await expect(corridor.program.name).toHaveValue("Retained");
  await context.close();
});
