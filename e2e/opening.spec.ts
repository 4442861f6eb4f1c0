/**
 * Before the page stands: what cannot be loaded is told, and no other work shows than the one asked
 * for.
 */
import { encodeLink } from "@corridor/link";
import { generateTree } from "@corridor/maze";
import type { Page } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import type { CorridorPage } from "./pages/corridor-page.ts";

for (const { what, file, status } of [
  { what: "the page's words do not come", file: "**/assets/words-en-*.json", status: 404 },
  { what: "the page's words are cut off", file: "**/assets/words-en-*.json", status: 200 },
  { what: "the page's script does not come", file: "**/assets/index-*.js", status: 404 },
]) {
  test(`is told in plain English when ${what}, and tries again`, async ({ browser, relay }) => {
    // Not a watched window: a file that does not come is an error, and is wanted here.
    const context = await browser.newContext({ baseURL: relay, serviceWorkers: "block" });
    const page = await context.newPage();
    await page.route(file, (route) => route.fulfill({ status, body: '{"cut' }));
    await page.goto("/?lang=de#a-link");
    const alert = page.getByRole("alert");
    await expect(alert).toContainText("Corridor did not load");
    await expect(page).toHaveURL(/\?lang=de#a-link$/);
    await page.unroute(file);
    await alert.getByRole("button", { name: "Try again" }).click();
    await expect(page.getByRole("grid")).toBeVisible();
    await expect(page.locator("html")).toHaveAttribute("lang", "de");
    await context.close();
  });
}

test("visits in Arabic for the first time, and the house stands the right way round from the start", async ({
  openWindow,
}) => {
  const { page } = await openWindow({ locale: "ar-EG", serviceWorkers: "block" });
  const places = () =>
    page.evaluate(() =>
      ["header", "header svg", "main"].map((words) => {
        const { x = -1, width = -1 } = document.querySelector(words)?.getBoundingClientRect() ?? {};
        // To two pixels: React's house has its parts on whole ones.
        return [words, 2 * Math.round(x / 2), 2 * Math.round(width / 2)].join(" ");
      }),
    );
  let letGo = (): void => undefined;
  const isHeld = new Promise<void>((resolve) => (letGo = resolve));
  await page.route("**/assets/index-*.js", async (route) => {
    await isHeld;
    await route.continue();
  });
  await page.goto("/", { waitUntil: "commit" });
  await expect(page.locator("header")).toHaveCSS("display", "flex");
  await expect(page.locator("html")).toHaveAttribute("dir", "rtl");
  const before = await places();
  letGo();
  await expect(page.getByRole("grid")).toBeVisible();
  await expect(page.locator("html")).toHaveAttribute("lang", "ar");
  expect(await places()).toEqual(before);
});

/**
 * Makes a work of one's own, and notes from then on whether its name is ever on a page that opens.
 */
async function makeOwnWork(corridor: CorridorPage): Promise<void> {
  await corridor.choosePreset("Comb");
  await corridor.program.name.fill("Mine alone");
  await expect(corridor.saveState).toHaveText("Saved on this device");
  await corridor.page.goto("about:blank");
  await corridor.page.addInitScript(() => {
    const watch = new MutationObserver(() => {
      const bar = document.querySelector("header")?.textContent ?? "";
      if (bar.includes("Comb")) Reflect.set(window, "hasShownOwn", true);
    });
    watch.observe(document, { subtree: true, childList: true, characterData: true });
  });
}

function hasShownOwn(page: Page): Promise<boolean> {
  return page.evaluate(() => Reflect.get(window, "hasShownOwn") === true);
}

const shared = encodeLink({
  maze: generateTree({ columns: 9, rows: 9, seed: 5, name: "From my teacher" }),
});

test("opens a link, and sees nothing of the own work before it", async ({ openWindow }) => {
  if (!shared.ok) throw new Error(shared.code);
  const corridor = await openWindow({ serviceWorkers: "block" });
  await corridor.open();
  await makeOwnWork(corridor);
  const { page } = corridor;
  let letGo = (): void => undefined;
  const isHeld = new Promise<void>((resolve) => (letGo = resolve));
  await page.route("**/assets/follow-page-address-*.js", async (route) => {
    await isHeld;
    await route.continue();
  });
  await page.goto(`/#${shared.text}`);
  await expect(page.getByText("Opening", { exact: true })).toBeVisible();
  await expect(page.getByRole("grid")).toHaveCount(0);
  letGo();
  await expect(corridor.mazeMenu).toHaveAccessibleName("From my teacher, Maze menu");
  await expect(page.getByText("Opening", { exact: true })).toHaveCount(0);
  await expect(corridor.message("Your own work is saved.")).toBeVisible();
  // Its program stays the reader's: the link brought none.
  await expect(corridor.program.name).toHaveValue("Mine alone");
  expect(await hasShownOwn(page)).toBe(false);
});

test("opens a link that is cut off, and sees the own work once that is told", async ({
  openWindow,
}) => {
  if (!shared.ok) throw new Error(shared.code);
  const corridor = await openWindow({ serviceWorkers: "block" });
  await corridor.open();
  await makeOwnWork(corridor);
  const { page } = corridor;
  await page.goto(`/#${shared.text.slice(0, -4)}`);
  await expect(corridor.message("A part of this link is missing.")).toBeVisible();
  await expect(corridor.mazeMenu).toHaveAccessibleName("Comb, Maze menu");
});
