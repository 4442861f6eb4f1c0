/** Whatever happens to the page, the device or the network: what the reader made is still there. */
import { CorridorPage } from "./pages/corridor-page.ts";
import { expect, test } from "./fixtures.ts";

const square = { column: 2, row: 6 };

/** Every work on the device, as text. */
function worksOf({ page }: CorridorPage): Promise<string[]> {
  return page.evaluate(() =>
    Object.entries(localStorage)
      .filter(([key]) => key.startsWith("corridor.work."))
      .map(([, text]) => String(text)),
  );
}

test("edits, and finds the edit on the device 300 ms later without pressing anything", async ({
  corridor,
  page,
}) => {
  await corridor.program.name.selectText();
  const steps = await page.evaluate(async () => {
    document.execCommand("insertText", false, "Typed just now");
    const isKept = () =>
      Object.values(localStorage).some((text) => String(text).includes("Typed just now"));
    // Timer steps of 10 ms are counted, so that a slow machine is not blamed for its own pauses.
    let count = 0;
    for (; !isKept() && count < 100; count++) {
      await new Promise((resolve) => setTimeout(resolve, 10));
    }
    return count;
  });
  expect(steps).toBeGreaterThan(0);
  expect(steps).toBeLessThanOrEqual(30);
  await corridor.reload();
  await expect(corridor.program.name).toHaveValue("Typed just now");
});

test("closes the tab right after an edit, and finds it in a new one", async ({
  corridor,
  context,
}) => {
  await corridor.maze.click(square);
  await corridor.page.close({ runBeforeUnload: true });
  const next = new CorridorPage(await context.newPage());
  await next.open();
  await next.maze.expectSquare(square, "block");
});

test("reloads in the middle of a run, and finds the edits that were made while it drove", async ({
  corridor,
}) => {
  await corridor.run.click();
  await expect(corridor.robotPose).not.toHaveText("Robot at 50, 650, facing right");
  await corridor.maze.click({ column: 10, row: 6 });
  await corridor.program.number(1).fill("75");
  await expect(corridor.pause).toBeVisible();
  await corridor.reload();
  await corridor.maze.expectSquare({ column: 10, row: 6 }, "block");
  await expect(corridor.program.number(1)).toHaveValue("75");
});

test("opens a link while an edit is not saved yet, and goes back to it", async ({
  corridor,
  page,
}) => {
  const link = await corridor.shareLink({ withProgram: true });
  await corridor.program.name.fill("Mine, and not saved yet");
  // At once, within the time that autosave waits.
  await page.evaluate((address) => (location.hash = new URL(address).hash), link);
  await expect(corridor.program.name).toHaveValue("Example: right wall");
  await expect(corridor.message("Your own work is saved.")).toBeVisible();
  await corridor.messages.getByRole("button", { name: "Back to my maze" }).click();
  await expect(corridor.program.name).toHaveValue("Mine, and not saved yet");
});

test("opens two links one after the other, and goes back to the own maze", async ({
  corridor,
  page,
}) => {
  const links: string[] = [];
  for (const preset of ["Spiral", "Comb"]) {
    await corridor.choosePreset(preset);
    links.push(await corridor.shareLink({ withProgram: false }));
  }
  await corridor.choosePreset("Tree");
  await corridor.program.name.fill("Mine");
  await expect(corridor.saveState).toHaveText("Saved on this device");
  await corridor.dismissMessages();
  for (const [at, link] of links.entries()) {
    await page.evaluate((address) => (location.hash = new URL(address).hash), link);
    await expect(corridor.mazeMenu).toHaveAccessibleName(`${["Spiral", "Comb"][at]}, Maze menu`);
  }
  await corridor.messages.getByRole("button", { name: "Back to my maze" }).first().click();
  await expect(corridor.mazeMenu).toHaveAccessibleName("Tree, Maze menu");
  await expect(corridor.program.name).toHaveValue("Mine");
});

test("opens a second link from elsewhere after a reload, and still goes back to the own maze", async ({
  corridor,
  page,
}) => {
  await corridor.choosePreset("Spiral");
  const first = await corridor.shareLink({ withProgram: false });
  await corridor.choosePreset("Comb");
  const second = await corridor.shareLink({ withProgram: false });
  await corridor.choosePreset("Tree");
  await corridor.program.name.fill("Mine");
  await expect(corridor.saveState).toHaveText("Saved on this device");
  for (const link of [first, second]) {
    await page.goto("about:blank");
    await corridor.open(link);
  }
  await expect(corridor.mazeMenu).toHaveAccessibleName("Comb, Maze menu");
  await corridor.messages.getByRole("button", { name: "Back to my maze" }).click();
  await expect(corridor.mazeMenu).toHaveAccessibleName("Tree, Maze menu");
});

test("edits in one tab what another tab damaged on the device, and keeps both entries", async ({
  corridor,
  page,
}) => {
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
  await expect.poll(async () => (await worksOf(corridor)).join()).toContain("After the damage");
  const kept = await page.evaluate(() => Object.values(localStorage).map(String));
  expect(kept).toContain(damaged);
  await corridor.reload();
  await expect(corridor.program.name).toHaveValue("After the damage");
});

test("goes on in two tabs that opened the very same work, and finds both afterwards", async ({
  corridor,
  context,
}) => {
  await corridor.program.name.fill("One work");
  await expect(corridor.saveState).toHaveText("Saved on this device");
  const second = new CorridorPage(await context.newPage());
  await second.open();
  await second.program.name.fill("From the second tab");
  await expect(second.saveState).toHaveText("Saved on this device");
  await corridor.program.name.fill("From the first tab");
  await expect.poll(async () => (await worksOf(corridor)).join()).toContain("From the first tab");
  expect((await worksOf(corridor)).join()).toContain("From the second tab");
});

test("asks for a part that does not come, is told so, and gets it with Try again", async ({
  browser,
  relay,
}) => {
  // Not a watched window: the browser reports the file that is missing, which is wanted here.
  const context = await browser.newContext({ baseURL: relay, serviceWorkers: "block" });
  const reader = new CorridorPage(await context.newPage());
  let isDown = true;
  await reader.page.route(/assets\/ResizeDialog-/, (route) =>
    isDown ? route.abort() : route.continue(),
  );
  await reader.open();
  await reader.program.name.fill("Kept");
  await reader.maze.button("Resize").click();
  const failure = reader.dialog("This part did not load");
  await expect(failure).toContainText("Nothing is lost.");
  // Still down, and the service too: the page stays.
  await reader.page.route("**/healthz", (route) => (isDown ? route.abort() : route.continue()));
  const hasTried = reader.page.waitForEvent("requestfailed", (request) =>
    request.url().endsWith("/healthz"),
  );
  await failure.getByRole("button", { name: "Try again" }).click();
  await hasTried;
  await expect(failure).toBeVisible();
  await expect(reader.program.name).toHaveValue("Kept");
  isDown = false;
  await failure.getByRole("button", { name: "Try again" }).click();
  await expect(reader.dialog("Resize the maze")).toBeVisible();
  await reader.page.keyboard.press("Escape");
  await expect(reader.program.name).toHaveValue("Kept");
  await context.close();
});
