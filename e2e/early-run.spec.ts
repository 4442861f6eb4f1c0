/**
 * Before the page's own script: index.html draws an empty house, and on a first visit its Run
 * drives the robot already. The page that moves in takes over what there is.
 */
import type { Locator, Page } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import { CorridorPage } from "./pages/corridor-page.ts";

/** Keeps the page's script on its way. @returns what lets it come */
async function holdScript(page: Page): Promise<() => void> {
  let letCome = (): void => {};
  const isComing = new Promise<void>((resolve) => (letCome = resolve));
  await page.route(/\/assets\/index-[\w-]+\.js$/, async (route) => {
    await isComing;
    await route.continue();
  });
  return letCome;
}

/** The newest tick that the worker has told, before there is a page to show it. */
function toldTick(page: Page): Promise<number> {
  return page.evaluate(() => {
    type Heard = { type: string; frame?: { snapshot: { tick: number } } };
    const { heard } = Reflect.get(window, "corridorSimulator") as { heard: Heard[] };
    return heard.findLast(({ frame }) => frame !== undefined)?.frame?.snapshot.tick ?? 0;
  });
}

/**
 * A reader sees what was painted: before that the styles may not have come, by which one of two
 * places is hidden.
 */
async function isPainted(page: Page): Promise<void> {
  await page.waitForFunction(() => performance.getEntriesByType("paint").length > 0);
  await page.evaluate(() => document.fonts.ready);
}

async function box(locator: Locator): Promise<string> {
  const place = await locator.boundingBox();
  if (place === null) return "not there";
  return [place.x, place.y, place.width, place.height].map(Math.round).join(" ");
}

/** The words of the invitation, before and after the page has moved in. */
async function invitation(page: Page): Promise<Locator> {
  const words = await page.locator("p[data-word=invitation]").first().textContent();
  return page.getByText(words ?? "", { exact: true }).filter({ visible: true });
}

test("presses Run before the page's own script has come, and the run goes on in it", async ({
  page,
}) => {
  const letCome = await holdScript(page);
  const corridor = new CorridorPage(page);
  await page.goto("/", { waitUntil: "commit" });
  await corridor.run.click();
  await expect(corridor.pause).toBeVisible();
  await expect.poll(() => toldTick(page)).toBeGreaterThan(30);
  letCome();
  await corridor.waitUntilReady();
  await expect(corridor.pause).toBeVisible();
  // 30 ticks of 5/3 cm: it was not put back.
  expect(await corridor.robotX()).toBeGreaterThan(90);
  await corridor.pause.click();
  await corridor.timeline.slider.focus();
  await page.keyboard.press("Home");
  await expect(corridor.robotPose).toHaveText("Robot at 50, 650, facing right");
  await expect(corridor.clock).toHaveText("Time 0:00.0");
  await corridor.timeline.backToNow.click();
  await expect.poll(() => corridor.robotX()).toBeGreaterThan(90);
});

test("gets the page also while the robot's own file does not come", async ({ page }) => {
  let letCome = (): void => {};
  const isComing = new Promise<void>((resolve) => (letCome = resolve));
  await page.route(/\/assets\/simulator\.worker-[\w-]+\.js$/, async (route) => {
    await isComing;
    await route.continue();
  });
  const corridor = new CorridorPage(page);
  await page.goto("/", { waitUntil: "commit" });
  // Pressed at once: the page waits for the robot, but not for ever.
  await corridor.run.click();
  await expect(page.locator("[data-early]")).toHaveCount(0);
  letCome();
  await expect(corridor.pause).toBeVisible();
  await expect.poll(() => corridor.robotX()).toBeGreaterThan(90);
});

test("has each file of the page fetched once, with the robot's first tick", async ({ page }) => {
  const asked: string[] = [];
  page.on("request", (request) => asked.push(new URL(request.url()).pathname));
  const corridor = new CorridorPage(page);
  await page.goto("/", { waitUntil: "commit" });
  await corridor.run.click();
  await corridor.waitUntilReady();
  const scripts = asked.filter((path) => /\/assets\/(?:index|react)-[\w-]+\.js$/.test(path));
  expect(scripts.map((path) => path.replace(/-[\w-]+\.js$/, "")).toSorted()).toEqual([
    "/assets/index",
    "/assets/react",
  ]);
});

test("pauses and goes on before the page's own script has come", async ({ page }) => {
  const letCome = await holdScript(page);
  const corridor = new CorridorPage(page);
  await page.goto("/", { waitUntil: "commit" });
  await corridor.run.click();
  await corridor.pause.click();
  await expect(corridor.run).toBeVisible();
  const tick = await toldTick(page);
  letCome();
  await corridor.waitUntilReady();
  await expect(corridor.run).toBeVisible();
  await expect.poll(() => corridor.robotX()).toBe(Math.round(50 + (tick * 5) / 3));
});

test("presses it with the keyboard, and stays on the button when the page moves in", async ({
  page,
}) => {
  const letCome = await holdScript(page);
  const corridor = new CorridorPage(page);
  await page.goto("/", { waitUntil: "commit" });
  await expect(corridor.run).toBeVisible();
  await page.keyboard.press("Tab");
  await expect(corridor.run).toBeFocused();
  await page.keyboard.press("Enter");
  await expect(corridor.pause).toBeFocused();
  letCome();
  await corridor.waitUntilReady();
  await expect(corridor.pause).toBeFocused();
  await page.keyboard.press("Space");
  await expect(corridor.run).toBeFocused();
});

test("reads Run in the reader's language, and finds names in it too", async ({ page }) => {
  const letCome = await holdScript(page);
  await page.goto("/?lang=de", { waitUntil: "commit" });
  const transport = page.getByRole("region", { name: "Lauf" });
  await transport.getByRole("button", { name: "Starten", exact: true }).click();
  await expect.poll(() => toldTick(page)).toBeGreaterThan(10);
  letCome();
  await transport.getByRole("button", { name: "Pause", exact: true }).click();
  await expect(page.getByRole("button", { name: /^Langer Umweg/ })).toBeVisible();
  await expect(page.locator("html")).toHaveAttribute("lang", "de");
});

test("comes back to a work of its own: Run waits for it", async ({ corridor, page }) => {
  await corridor.choosePreset("Spiral");
  await expect(corridor.saveState).toHaveText("Saved on this device");
  const letCome = await holdScript(page);
  await page.reload({ waitUntil: "commit" });
  await expect(page.locator("#wordmark")).toBeAttached();
  await corridor.waitForFrames(10);
  await expect(corridor.run).toBeHidden();
  letCome();
  await corridor.waitUntilReady();
  await expect(corridor.mazeMenu).toHaveAccessibleName("Spiral, Maze menu");
  await corridor.run.click();
  await expect(corridor.pause).toBeVisible();
});

test("opens a link: Run waits for what it brings", async ({ corridor, page, openWindow }) => {
  await corridor.choosePreset("Comb");
  const link = await corridor.shareLink({ withProgram: true });
  const other = await openWindow();
  const letCome = await holdScript(other.page);
  await other.page.goto(link, { waitUntil: "commit" });
  await expect(other.page.locator("#wordmark")).toBeAttached();
  await other.waitForFrames(10);
  await expect(other.run).toBeHidden();
  letCome();
  await other.waitUntilReady();
  await expect(other.mazeMenu).toHaveAccessibleName("Comb, Maze menu");
  await expect(other.page).toHaveURL("/");
  await expect(page).toHaveURL(link);
});

test("sees the invitation all the time from the first paint on, in one place, when the page moves in", async ({
  openWindow,
}) => {
  const { page } = await openWindow({ viewport: { width: 390, height: 844 } });
  const letCome = await holdScript(page);
  await page.goto("/", { waitUntil: "commit" });
  await expect(page.locator("[data-does=run]")).toBeVisible();
  await isPainted(page);
  const text = await (await invitation(page)).textContent();
  await page.evaluate((words) => {
    const places = new Set<string>();
    Reflect.set(window, "placesSeen", places);
    const look = () => {
      const shown = [...document.querySelectorAll("p")].find(
        (each) => each.textContent === words && each.checkVisibility({ visibilityProperty: true }),
      );
      const { x, y, width, height } = shown?.getBoundingClientRect() ?? new DOMRect();
      places.add([x, y, width, height].map(Math.round).join(" "));
      requestAnimationFrame(look);
    };
    look();
  }, text);
  letCome();
  await new CorridorPage(page).waitUntilReady();
  await expect(page.locator("#root [data-word]")).toHaveCount(0);
  const places = await page.evaluate(() => [...(Reflect.get(window, "placesSeen") as Set<string>)]);
  expect(places).toEqual([await box(page.getByText(text ?? "", { exact: true }))]);
});

test("is not invited again before the page's own script has come", async ({ page }) => {
  const corridor = new CorridorPage(page);
  await page.goto("/");
  await corridor.waitUntilReady();
  await page.getByRole("button", { name: "Not now" }).click();
  const letCome = await holdScript(page);
  await page.goto("/", { waitUntil: "commit" });
  await expect(page.locator("#wordmark")).toBeAttached();
  await corridor.waitForFrames(10);
  await expect(page.getByText("New here?").filter({ visible: true })).toHaveCount(0);
  letCome();
  await corridor.waitUntilReady();
  await expect(page.getByText("New here?")).toHaveCount(0);
});

for (const [width, height] of [
  [1440, 900],
  [1024, 768],
  [760, 900],
  [700, 500],
  [390, 844],
  [320, 640],
] as const) {
  for (const lang of ["en", "ar"]) {
    test(`stands at ${width} x ${height} where the page will stand, in ${lang}`, async ({
      openWindow,
    }) => {
      const { page } = await openWindow({ viewport: { width, height } });
      const letCome = await holdScript(page);
      await page.goto(`/?lang=${lang}`, { waitUntil: "commit" });
      const run = page.locator("[data-does=run]");
      await expect(run).toBeVisible();
      await isPainted(page);
      const parts = [run, page.locator("h1"), page.locator("header").first(), page.locator("main")];
      parts.push(await invitation(page));
      const before = await Promise.all(parts.map(box));
      letCome();
      await expect(page.locator("main canvas").first()).toBeAttached();
      await expect(page.locator("[data-early]")).toHaveCount(0);
      expect(await Promise.all(parts.map(box))).toEqual(before);
    });
  }
}
