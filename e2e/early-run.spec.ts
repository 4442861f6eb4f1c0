// cspell:words Lauf Starten Umweg
/**
 * Before the page's main script: index.html draws a static shell, and on a first visit its Run
 * button already drives the robot. The page takes over the shell's state.
 */
import type { Locator, Page } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import { CorridorPage } from "./pages/corridor-page.ts";
import { clearStorageOnLoad } from "./support/clear-storage.ts";
import { waitForAnimations } from "./support/wait-for-animations.ts";
import { smallWindow } from "./support/window-sizes.ts";
import { withMotion } from "./support/with-motion.ts";

test.use({ ...withMotion, ...smallWindow });

/** Delays the page's main script. @returns a function that lets the script load */
async function delayScript(page: Page): Promise<() => void> {
  let releaseScript = (): void => {};
  const released = new Promise<void>((resolve) => (releaseScript = resolve));
  await page.route(/\/assets\/index-[\w-]+\.js$/, async (route) => {
    await released;
    await route.continue();
  });
  return releaseScript;
}

/** The newest tick that the worker has reported before the page displays ticks. */
function reportedTick(page: Page): Promise<number> {
  return page.evaluate(() => {
    type Message = { type: string; frame?: { snapshot: { tick: number } } };
    const { queue } = Reflect.get(window, "corridorSimulator") as { queue: Message[] };
    return queue.findLast(({ frame }) => frame !== undefined)?.frame?.snapshot.tick ?? 0;
  });
}

/** Waits for the first paint: before that, missing styles may show two variants of one text. */
async function waitForPaint(page: Page): Promise<void> {
  await page.waitForFunction(() => performance.getEntriesByType("paint").length > 0);
  await page.evaluate(() => document.fonts.ready);
}

async function box(locator: Locator): Promise<string> {
  const rect = await locator.boundingBox();
  if (rect === null) return "not displayed";
  return [rect.x, rect.y, rect.width, rect.height].map(Math.round).join(" ");
}

/** The invitation's text, before and after the page has taken over. */
async function invitation(page: Page): Promise<Locator> {
  const text = await page.locator("p[data-word=invitation]").first().textContent();
  return page.getByText(text ?? "", { exact: true }).filter({ visible: true });
}

async function continuesRun(page: Page): Promise<void> {
  const releaseScript = await delayScript(page);
  const corridor = new CorridorPage(page);
  await page.goto("/", { waitUntil: "commit" });
  await corridor.run.click();
  await expect(corridor.pause).toBeVisible();
  await expect.poll(() => reportedTick(page)).toBeGreaterThan(30);
  releaseScript();
  await corridor.waitUntilReady();
  await expect(corridor.pause).toBeVisible();
  // 30 ticks of 5/3 cm: the robot was not reset.
  expect(await corridor.robotX()).toBeGreaterThan(90);
  await corridor.pause.click();
  await corridor.timeline.slider.focus();
  await page.keyboard.press("Home");
  await expect(corridor.robotPose).toHaveText("Robot at 50, 650, facing right");
  await expect(corridor.clock).toHaveText("Time 0:00.0");
  await corridor.timeline.backToNow.click();
  await expect.poll(() => corridor.robotX()).toBeGreaterThan(90);
}

async function waitsForSimulator(page: Page): Promise<void> {
  let releaseScript = (): void => {};
  const released = new Promise<void>((resolve) => (releaseScript = resolve));
  await page.route(/\/assets\/simulator\.worker-[\w-]+\.js$/, async (route) => {
    await released;
    await route.continue();
  });
  const corridor = new CorridorPage(page);
  await page.goto("/", { waitUntil: "commit" });
  // Run is pressed before the page: the page waits for the simulator, but only for a limited time.
  await corridor.run.click();
  await expect(page.locator("[data-early]")).toHaveCount(0);
  releaseScript();
  await expect(corridor.pause).toBeVisible();
  await expect.poll(() => corridor.robotX()).toBeGreaterThan(90);
}

async function continuesPaused(page: Page): Promise<void> {
  const releaseScript = await delayScript(page);
  const corridor = new CorridorPage(page);
  await page.goto("/", { waitUntil: "commit" });
  await corridor.run.click();
  await corridor.pause.click();
  await expect(corridor.run).toBeVisible();
  const tick = await reportedTick(page);
  releaseScript();
  await corridor.waitUntilReady();
  await expect(corridor.run).toBeVisible();
  await expect.poll(() => corridor.robotX()).toBe(Math.round(50 + (tick * 5) / 3));
}

async function runsByKeyboardInGerman(page: Page): Promise<void> {
  const releaseScript = await delayScript(page);
  await page.goto("/?lang=de", { waitUntil: "commit" });
  const transport = page.getByRole("region", { name: "Lauf" });
  const run = transport.getByRole("button", { name: "Starten", exact: true });
  const pause = transport.getByRole("button", { name: "Pause", exact: true });
  await expect(run).toBeVisible();
  await page.keyboard.press("Tab");
  await expect(run).toBeFocused();
  await page.keyboard.press("Enter");
  await expect(pause).toBeFocused();
  await expect.poll(() => reportedTick(page)).toBeGreaterThan(10);
  releaseScript();
  await expect(page.getByRole("button", { name: /^Langer Umweg/ })).toBeVisible();
  await expect(page.locator("html")).toHaveAttribute("lang", "de");
  await expect(pause).toBeFocused();
  await page.keyboard.press("Space");
  await expect(run).toBeFocused();
}

async function showsInvitationInOnePlace(page: Page): Promise<void> {
  await page.setViewportSize({ width: 390, height: 844 });
  const releaseScript = await delayScript(page);
  await page.goto("/", { waitUntil: "commit" });
  await expect(page.locator("[data-does=run]")).toBeVisible();
  await waitForPaint(page);
  const text = await (await invitation(page)).textContent();
  await page.evaluate((text) => {
    const rects = new Set<string>();
    Reflect.set(window, "rectsSeen", rects);
    const recordRect = () => {
      const visible = [...document.querySelectorAll("p")].find(
        (each) => each.textContent === text && each.checkVisibility({ visibilityProperty: true }),
      );
      const { x, y, width, height } = visible?.getBoundingClientRect() ?? new DOMRect();
      rects.add([x, y, width, height].map(Math.round).join(" "));
      requestAnimationFrame(recordRect);
    };
    recordRect();
  }, text);
  releaseScript();
  await new CorridorPage(page).waitUntilReady();
  await expect(page.locator("#root [data-word]")).toHaveCount(0);
  const rects = await page.evaluate(() => [...(Reflect.get(window, "rectsSeen") as Set<string>)]);
  expect(rects).toEqual([await box(page.getByText(text ?? "", { exact: true }))]);
}

async function fetchesFilesOnce(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  const requested: string[] = [];
  page.on("request", (request) => requested.push(new URL(request.url()).pathname));
  await page.goto("/", { waitUntil: "commit" });
  await corridor.run.click();
  await corridor.waitUntilReady();
  const scripts = requested.filter((path) => /\/assets\/(?:index|react)-[\w-]+\.js$/.test(path));
  expect(scripts.map((path) => path.replace(/-[\w-]+\.js$/, "")).toSorted()).toEqual([
    "/assets/index",
    "/assets/react",
  ]);
}

async function doesNotRepeatInvitation(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  await page.getByRole("button", { name: "Not now" }).click();
  const releaseScript = await delayScript(page);
  await page.goto("/", { waitUntil: "commit" });
  await expect(page.locator("#wordmark")).toBeAttached();
  await corridor.waitForFrames(10);
  await expect(page.getByText("New here?").filter({ visible: true })).toHaveCount(0);
  releaseScript();
  await corridor.waitUntilReady();
  await expect(page.getByText("New here?")).toHaveCount(0);
}

async function waitsForProject(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  await corridor.choosePreset("Spiral");
  await expect(corridor.saveState).toHaveText("Saved on this device");
  const releaseScript = await delayScript(page);
  await page.reload({ waitUntil: "commit" });
  await expect(page.locator("#wordmark")).toBeAttached();
  await corridor.waitForFrames(10);
  await expect(corridor.run).toBeHidden();
  releaseScript();
  await corridor.waitUntilReady();
  await expect(corridor.mazeMenu).toHaveAccessibleName("Spiral, Maze menu");
  await corridor.run.click();
  await expect(corridor.clock).not.toHaveText(/0:00\.0$/);
}

async function waitsForLink(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  await corridor.choosePreset("Comb");
  const link = await corridor.shareLink({ withProgram: true });
  // Another user, who has no project.
  const other = new CorridorPage(await page.context().newPage());
  await clearStorageOnLoad(other.page);
  const releaseScript = await delayScript(other.page);
  await other.page.goto(link, { waitUntil: "commit" });
  await expect(other.page.locator("#wordmark")).toBeAttached();
  await other.waitForFrames(10);
  await expect(other.run).toBeHidden();
  releaseScript();
  await other.waitUntilReady();
  await expect(other.mazeMenu).toHaveAccessibleName("Comb, Maze menu");
  await expect(other.page).toHaveURL("/");
  await expect(page).toHaveURL(link);
}

const sizes = [
  { width: 1440, height: 900 },
  { width: 1024, height: 768 },
  { width: 760, height: 900 },
  { width: 700, height: 500 },
  { width: 390, height: 844 },
  { width: 320, height: 640 },
] as const;

type Size = (typeof sizes)[number];

async function hasLayoutBeforeScript(page: Page, lang: string, inOrder: readonly Size[]) {
  const releaseScript = await delayScript(page);
  await page.goto(`/?lang=${lang}`, { waitUntil: "commit" });
  const run = page.locator("[data-does=run]");
  await run.waitFor();
  await waitForPaint(page);
  const parts = [run, page.locator("h1"), page.locator("header").first(), page.locator("main")];
  parts.push(await invitation(page));
  const boxesAt = async (size: Size) => {
    await page.setViewportSize(size);
    await waitForAnimations(page);
    return { size, boxes: await Promise.all(parts.map(box)) };
  };
  const before: Awaited<ReturnType<typeof boxesAt>>[] = [];
  for (const size of inOrder) before.push(await boxesAt(size));
  releaseScript();
  await page.locator("main canvas").first().waitFor({ state: "attached" });
  await page.locator("[data-early]").first().waitFor({ state: "detached" });
  for (const expected of before.toReversed()) {
    expect(await boxesAt(expected.size)).toEqual(expected);
  }
}

test("takes over in the page what happened before the page's main script on a first visit", async ({
  page,
}) => {
  await clearStorageOnLoad(page);
  await test.step("continues in the page a run that started before the page's main script", () =>
    continuesRun(page));
  await test.step("displays the page while the simulator's file does not load", () =>
    waitsForSimulator(page));
  await test.step("pauses before the page's main script, and continues after it", () =>
    continuesPaused(page));
  await test.step("presses Run by keyboard in the browser's language, and keeps the focus on the button when the page takes over", () =>
    runsByKeyboardInGerman(page));
  await test.step("shows the invitation from the first paint on, in one place, while the page takes over", () =>
    showsInvitationInOnePlace(page));
  // The page takes over the shell at the last size: a wide one in one language, a phone in the other.
  for (const { lang, inOrder } of [
    { lang: "en", inOrder: sizes },
    { lang: "ar", inOrder: sizes.toReversed() },
  ]) {
    await test.step(`has the layout of the page before the page's script at each size, in ${lang}`, () =>
      hasLayoutBeforeScript(page, lang, inOrder));
  }
});

test("opens the page with what is stored, and each file once", async ({ page }) => {
  const corridor = new CorridorPage(page);
  await test.step("fetches each file of the page once, with the robot's first tick", () =>
    fetchesFilesOnce(corridor));
  await test.step("does not repeat a dismissed invitation before the page's main script", () =>
    doesNotRepeatInvitation(corridor));
  await test.step("waits with Run for a saved project", () => waitsForProject(corridor));
  await test.step("waits with Run for a link to open", () => waitsForLink(corridor));
});
