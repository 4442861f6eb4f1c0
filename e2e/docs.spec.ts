/**
 * The documentation at /docs, read on its own, with calls from its console. The page fixture fails
 * the test at every policy violation.
 */
import type { RunOptions } from "axe-core";
import type { Page } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import { allButColours, axeViolations, onlyColours, type PageParts } from "./support/axe.ts";

test("executes the calls that the documentation shows, in a console as dark as the page", async ({
  page,
  relay,
}) => {
  const hosts = new Set<string>();
  page.on("request", (request) => hosts.add(new URL(request.url()).host));
  await page.emulateMedia({ colorScheme: "dark" });
  await page.goto("/docs");
  await page.getByRole("link", { name: "API console" }).click();
  const health = page.locator("#operations-Service-checkHealth");
  const block = health.locator(".opblock-summary-description");
  await expect(block).toBeVisible();
  const [ink, paper] = await block.evaluate((words) => [
    getComputedStyle(words).color,
    getComputedStyle(words.closest("#console") ?? words).backgroundColor,
  ]);
  const light = (colour = ""): number => Number(/\d+/.exec(colour)?.[0]);
  expect(light(ink)).toBeGreaterThan(150);
  expect(light(paper)).toBeLessThan(60);
  await health
    .getByRole("button", { name: /healthz/ })
    .first()
    .click();
  await health.getByRole("button", { name: "Execute" }).click();
  await expect(health.locator(".live-responses-table")).toContainText('"status": "ok"');
  expect([...hosts]).toEqual([new URL(relay).host]);
});

test("links to sections and pages, copies a script and stores the language of scripts", async ({
  page,
}) => {
  await test.step("a language counts for every block of every page, and the block stays in place", async () => {
    await page.goto("/docs");
    await page.getByRole("radio", { name: "curl" }).check();
    await page.goto("/docs/recipes");
    const maze = page.getByRole("group", { name: "Language for the maze" });
    await expect(maze.getByRole("radio", { name: "curl" })).toBeChecked();
    await maze.scrollIntoViewIfNeeded();
    const before = (await maze.boundingBox())?.y;
    await maze.getByText("JavaScript", { exact: true }).click();
    expect((await maze.boundingBox())?.y).toBeCloseTo(before ?? Number.NaN, 0);
    const follower = page.getByRole("group", { name: "Language of the wall follower" });
    await expect(follower.getByRole("radio", { name: "JavaScript" })).toBeChecked();
    // The quickstart has one more language. A page that does not offer it ignores the choice.
    await page.goto("/docs");
    await page.getByRole("radio", { name: "Java", exact: true }).check();
    await page.goto("/docs/recipes");
    await expect(follower.getByRole("radio", { name: "Python" })).toBeChecked();
  });

  await test.step("links from the top of a long page to its sections", async () => {
    await page.goto("/docs/commands");
    const contents = page.getByRole("navigation", { name: "On this page" });
    await contents.getByRole("link", { name: "Deadline" }).click();
    await expect(page.getByRole("heading", { name: "Deadline" })).toBeInViewport();
    await expect(contents).not.toBeInViewport();
  });

  await test.step("copies a complete script", async () => {
    await page.goto("/docs");
    await page.getByRole("radio", { name: "Python", exact: true }).check();
    const panel = page.getByRole("group", { name: "Python" });
    await panel.getByRole("button", { name: "Copy" }).click();
    await expect(panel.getByRole("status")).toHaveText("Copied");
    const script = await page.evaluate(() => navigator.clipboard.readText());
    expect(script).toMatch(/^from corridor import Robot\n[^]*front\)\)\s*$/);
  });

  await test.step("reaches the last page from the row of links on a phone, with the links wide enough to tap", async () => {
    await page.setViewportSize({ width: 390, height: 844 });
    const pages = page.getByRole("navigation", { name: "Documentation" }).getByRole("link");
    for (const link of await pages.all()) {
      expect((await link.boundingBox())?.width).toBeGreaterThanOrEqual(44);
    }
    await pages.last().click();
    await expect(page).toHaveURL(/maze-format$/);
    await expect(page.getByRole("link", { name: "File formats" })).toBeInViewport({ ratio: 1 });
  });
});

test("shows one language at a time, by keyboard and without JavaScript", async ({
  browser,
  relay,
}) => {
  const context = await browser.newContext({ javaScriptEnabled: false });
  const page = await context.newPage();
  await page.goto(`${relay}/docs`);
  await expect(page.getByText("from corridor import Robot")).toBeVisible();
  await page.getByRole("radio", { name: "Python", exact: true }).press("ArrowRight");
  await expect(page.getByRole("radio", { name: "JavaScript", exact: true })).toBeFocused();
  await expect(page.getByText("const robot =")).toBeVisible();
  await expect(page.getByText("from corridor import Robot")).toBeHidden();
  await context.close();
});

test("has no axe violations on any page, in both themes and on the smallest phone", async ({
  page,
}) => {
  await page.setViewportSize({ width: 320, height: 640 });
  const paths = new Set(["/docs", "/problems/too-late"]);
  const places = new Set<string>();
  // Iterating over a set includes elements added during the iteration: each section's navigation links its
  // pages.
  for (const path of paths) {
    await page.emulateMedia({ colorScheme: "light" });
    await page.goto(path);
    const links = page.getByRole("navigation", { name: "Documentation" }).getByRole("link");
    const addresses = await links.evaluateAll((all) =>
      all.map((link) => link.getAttribute("href")),
    );
    for (const address of addresses) paths.add(address ?? "");
    const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    expect(overflow, path).toBeLessThanOrEqual(0);
    const context = { exclude: ["#console"] };
    expect(await violations(page, allButColours, context), path).toEqual([]);
    const newPlaces = await markNewPlaces(page, places);
    if (newPlaces.length === 0) continue;
    for (const place of newPlaces) places.add(place);
    for (const colorScheme of ["light", "dark"] as const) {
      await page.emulateMedia({ colorScheme });
      const onlyNew = { include: ["[data-new]"], ...context };
      expect(await violations(page, onlyColours, onlyNew), `${path}, ${colorScheme}`).toEqual([]);
    }
  }
  expect([...paths]).toEqual(
    expect.arrayContaining(["/docs/python-reference", "/docs/conformance", "/docs/run-format"]),
  );
});

/**
 * Marks one element of each place that no earlier page had, such as code in a cell of a table. Its
 * place determines the colours of an element, and axe needs most of its time for colours.
 * @param known places of earlier pages
 * @returns the new places
 */
async function markNewPlaces(page: Page, known: ReadonlySet<string>): Promise<string[]> {
  return page.evaluate(
    (earlier) => {
      const seen = new Set(earlier);
      const placeOf = (element: Element): string => {
        const parent = element.parentElement;
        const ownName = `${element.tagName}.${element.className}`;
        return parent === null ? ownName : `${placeOf(parent)} ${ownName}`;
      };
      const newPlaces: string[] = [];
      for (const element of document.querySelectorAll("body *:not(#console, #console *)")) {
        const place = placeOf(element);
        if (seen.has(place)) continue;
        seen.add(place);
        newPlaces.push(place);
        element.toggleAttribute("data-new", true);
      }
      return newPlaces;
    },
    [...known],
  );
}

async function violations(page: Page, options: RunOptions, parts: PageParts): Promise<string[]> {
  const found = await axeViolations(page, options, parts);
  return found.map(({ id, help }) => `${id}: ${help}`);
}
