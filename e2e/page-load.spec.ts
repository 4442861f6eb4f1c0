/**
 * Opening the page: load failures are reported, and no other project is displayed before the
 * requested one.
 */
import { encodeLink } from "@corridor/link";
import { generateTree } from "@corridor/maze";
import type { Page } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import type { CorridorPage } from "./pages/corridor-page.ts";
import { smallWindow } from "./support/window-sizes.ts";

test.use(smallWindow);

const failures = [
  { problem: "the texts do not load", file: "**/assets/words-en-*.json", status: 404 },
  { problem: "the texts are truncated", file: "**/assets/words-en-*.json", status: 200 },
  { problem: "the page's script does not load", file: "**/assets/index-*.js", status: 404 },
];

test("reports in plain English that a part did not load, and tries again", async ({
  browser,
  relay,
}) => {
  // Not an openWindow fixture: the browser logs an error for the missing file, as expected.
  const context = await browser.newContext({
    ...smallWindow,
    baseURL: relay,
    serviceWorkers: "block",
  });
  const page = await context.newPage();
  for (const { problem, file, status } of failures) {
    await test.step(problem, async () => {
      await page.goto("about:blank");
      await page.route(file, (route) => route.fulfill({ status, body: '{"cut' }));
      await page.goto("/?lang=de#a-link");
      const alert = page.getByRole("alert");
      await expect(alert).toContainText("Corridor did not load");
      await expect(page).toHaveURL(/\?lang=de#a-link$/);
      await page.unroute(file);
      await alert.getByRole("button", { name: "Try again" }).click();
      await expect(page.getByRole("grid")).toBeVisible();
      await expect(page.locator("html")).toHaveAttribute("lang", "de");
    });
  }
  await context.close();
});

test("lays out the shell right-to-left from the first paint on a first visit in Arabic", async ({
  openWindow,
}) => {
  const { page } = await openWindow({ locale: "ar-EG", serviceWorkers: "block" });
  const layout = () =>
    page.evaluate(() =>
      ["header", "header svg", "main"].map((selector) => {
        const { x = -1, width = -1 } =
          document.querySelector(selector)?.getBoundingClientRect() ?? {};
        // Rounded to two pixels: React places elements at whole pixels.
        return [selector, 2 * Math.round(x / 2), 2 * Math.round(width / 2)].join(" ");
      }),
    );
  let release = (): void => undefined;
  const released = new Promise<void>((resolve) => (release = resolve));
  await page.route("**/assets/index-*.js", async (route) => {
    await released;
    await route.continue();
  });
  await page.goto("/", { waitUntil: "commit" });
  await expect(page.locator("header")).toHaveCSS("display", "flex");
  await expect(page.locator("html")).toHaveAttribute("dir", "rtl");
  const before = await layout();
  release();
  await expect(page.getByRole("grid")).toBeVisible();
  await expect(page.locator("html")).toHaveAttribute("lang", "ar");
  expect(await layout()).toEqual(before);
});

/** Creates a project, and records from then on whether an opening page ever displays its name. */
async function createOwnProject(corridor: CorridorPage): Promise<void> {
  await corridor.choosePreset("Comb");
  await corridor.program.name.fill("Mine alone");
  await expect(corridor.saveState).toHaveText("Saved on this device");
  await corridor.page.goto("about:blank");
  await corridor.page.addInitScript(() => {
    const observer = new MutationObserver(() => {
      const bar = document.querySelector("header")?.textContent ?? "";
      if (bar.includes("Comb")) Reflect.set(window, "hasDisplayedOwn", true);
    });
    observer.observe(document, { subtree: true, childList: true, characterData: true });
  });
}

function hasDisplayedOwn(page: Page): Promise<boolean> {
  return page.evaluate(() => Reflect.get(window, "hasDisplayedOwn") === true);
}

const shared = encodeLink({
  maze: generateTree({ columns: 9, rows: 9, seed: 5, name: "From my teacher" }),
});

async function waitsForLink(corridor: CorridorPage, link: string): Promise<void> {
  const { page } = corridor;
  let release = (): void => undefined;
  const released = new Promise<void>((resolve) => (release = resolve));
  await page.route("**/assets/follow-page-address-*.js", async (route) => {
    await released;
    await route.continue();
  });
  await page.goto(`/#${link}`);
  await expect(page.getByText("Opening", { exact: true })).toBeVisible();
  await expect(page.getByRole("grid")).toHaveCount(0);
  release();
  await expect(corridor.mazeMenu).toHaveAccessibleName("From my teacher, Maze menu");
  await expect(page.getByText("Opening", { exact: true })).toHaveCount(0);
  await expect(corridor.message("Your own maze and program are saved.")).toBeVisible();
  // The link contains no program, so the user's program stays.
  await expect(corridor.program.name).toHaveValue("Mine alone");
  expect(await hasDisplayedOwn(page)).toBe(false);
}

async function reportsIncompleteLink(corridor: CorridorPage, link: string): Promise<void> {
  await corridor.page.goto(`/#${link.slice(0, -4)}`);
  await expect(corridor.message("A part of this link is missing.")).toBeVisible();
  await expect(corridor.mazeMenu).toHaveAccessibleName("Comb, Maze menu");
}

test("displays the user's own project only where no link replaces it", async ({ corridor }) => {
  if (!shared.ok) throw new Error(shared.code);
  const { text } = shared;
  await createOwnProject(corridor);
  await test.step("displays the user's own project after reporting that a link is incomplete", () =>
    reportsIncompleteLink(corridor, text));
  await corridor.page.goto("about:blank");
  await test.step("does not display the user's own project before that of a link", () =>
    waitsForLink(corridor, text));
});

test("the licenses of the packages in the page, its worker and its font are served", async ({
  request,
}) => {
  const text = await (await request.get("/third-party-licenses.txt")).text();
  for (const name of ["react", "matter-js", "@fontsource-variable/inter"])
    expect(text).toContain(`${name} `);
});
