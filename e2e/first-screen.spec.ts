/**
 * What a first visit loads until the robot drives its first tick, as the relay sends it. The budget
 * is the product's promise to slow networks; what a reader may want later comes later.
 */
import type { Page } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import { CorridorPage } from "./pages/corridor-page.ts";

const KIB = 1024;
/** The goals of docs/performance.md. */
const SCRIPT_BUDGET = 152.7 * KIB;
const WHOLE_BUDGET = 223.1 * KIB;

interface Loaded {
  path: string;
  isScript: boolean;
  /** on the line, brotli where the relay has it */
  bytes: number;
}

/** Opens the page as its first visitor, presses Run, and waits for the first tick. */
async function firstScreen(page: Page, relay: string): Promise<Loaded[]> {
  await noteFilesUntilFirstTick(page);
  const corridor = new CorridorPage(page);
  await page.goto("/");
  await corridor.run.click();
  const files = await page.waitForFunction(() => Reflect.get(window, "firstFiles") as unknown);
  const asked = [...new Set((await files.jsonValue()) as string[])].filter((address) =>
    address.startsWith(relay),
  );
  return Promise.all(
    asked.map(async (address) => {
      const answer = await fetch(address, { headers: { "Accept-Encoding": "br" } });
      const body = await answer.arrayBuffer();
      const onLine = Number(answer.headers.get("content-length"));
      return {
        path: new URL(address).pathname,
        isScript: answer.headers.get("content-type")?.includes("javascript") === true,
        bytes: onLine > 0 ? onLine : body.byteLength,
      };
    }),
  );
}

/**
 * Leaves in `firstFiles` what was loaded at the first tick, with which the lines are marked as
 * begun: what comes after that, in the background, is not part of the first screen.
 */
async function noteFilesUntilFirstTick(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const watch = new MutationObserver(() => {
      if (document.querySelector("[data-begun]") === null) return;
      watch.disconnect();
      const files = performance.getEntriesByType("resource").map(({ name }) => name);
      Reflect.set(window, "firstFiles", [location.href, ...files]);
    });
    watch.observe(document, { subtree: true, childList: true, attributeFilter: ["data-begun"] });
  });
}

/** The largest first, so that the reason stands on top when the budget is missed. */
function table(files: readonly Loaded[]): string {
  const rows = files.toSorted((a, b) => b.bytes - a.bytes);
  return rows.map(({ path, bytes }) => `${String(bytes).padStart(8)} ${path}`).join("\n");
}

function sumOf(files: readonly Loaded[]): number {
  return files.reduce((sum, { bytes }) => sum + bytes, 0);
}

test("opens for the first time with little to load, and drives", async ({ page, relay }) => {
  const files = await firstScreen(page, relay);
  const scripts = files.filter(({ isScript }) => isScript);
  const report = `scripts ${(sumOf(scripts) / KIB).toFixed(1)} KiB, everything ${(sumOf(files) / KIB).toFixed(1)} KiB\n${table(files)}`;
  test.info().annotations.push({ type: "first screen", description: report });
  expect(scripts.some(({ path }) => path.includes("simulator.worker"))).toBe(true);
  expect(sumOf(scripts), report).toBeLessThanOrEqual(SCRIPT_BUDGET);
  expect(sumOf(files), report).toBeLessThanOrEqual(WHOLE_BUDGET);
});

test("sees the house in its colours and places before the page's script has come", async ({
  page,
  relay,
}) => {
  const places = () =>
    page.evaluate(() => {
      const boxOf = (words: string) => {
        const box = document.querySelector(words)?.getBoundingClientRect();
        // To two pixels: the lines of text that React brings have heights of their own.
        return [box?.x, box?.y, box?.width, box?.height].map(
          (at) => 2 * Math.round((at ?? -2) / 2),
        );
      };
      const dot = document.querySelector("#wordmark circle");
      return {
        bar: boxOf("header"),
        wordmark: boxOf("header svg"),
        stage: boxOf("main"),
        dot: dot && getComputedStyle(dot).fill,
      };
    });
  let letGo = () => {};
  const held = new Promise<void>((resolve) => (letGo = resolve));
  await page.route(`${relay}/assets/index-*.js`, async (route) => {
    await held;
    await route.continue();
  });
  await page.goto("/", { waitUntil: "commit" });
  await expect(page.locator("header")).toHaveCSS("display", "flex");
  const before = await places();
  letGo();
  await new CorridorPage(page).waitUntilReady();
  expect(before).toEqual(await places());
  expect(before.dot).toBe("rgb(239, 106, 26)");
});
