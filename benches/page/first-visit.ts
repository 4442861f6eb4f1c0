/**
 * A first visit: from the start of the navigation until the robot has driven its first tick, with Run
 * pressed as soon as it can be; beside the first paint of a page that has React and one word.
 */
import type { Browser } from "playwright";
import { digits } from "../core/goals.ts";
import { serveVariants } from "./serve-variants.ts";
import type { Section } from "./section.ts";

const ROUNDS = 15;

export const firstVisit: Section = {
  title: "First visit",
  measure: async ({ browser, url }) => {
    const empty = await serveVariants("variants/empty-react/");
    const paints: number[] = [];
    const ticks: number[] = [];
    try {
      // The first round warms the disk and the server.
      for (let round = 0; round <= ROUNDS; round++) {
        const paint = await visit(browser, empty.url, firstPaint);
        const tick = await visit(browser, url, firstTick);
        if (round === 0) continue;
        paints.push(paint);
        ticks.push(tick);
      }
    } finally {
      await empty.stop();
    }
    const ratio = median(ticks.map((tick, round) => tick / (paints[round] ?? Number.NaN)));
    console.log(`  empty React page, first paint: ${digits(median(paints))} ms`);
    console.log(`  Corridor, first tick: ${digits(median(ticks))} ms`);
    return [
      {
        words: "first tick against the first paint of an empty React page",
        measured: ratio,
        bound: { atMost: 1.5 },
        unit: "times",
      },
    ];
  },
};

/** Opens an address as somebody who has never been there. @returns milliseconds since the navigation */
async function visit(browser: Browser, url: string, until: () => Promise<number>): Promise<number> {
  const context = await browser.newContext({ serviceWorkers: "block" });
  try {
    const page = await context.newPage();
    await page.goto(url, { waitUntil: "commit" });
    return await page.evaluate(until);
  } finally {
    await context.close();
  }
}

/** Runs in the page. */
async function firstPaint(): Promise<number> {
  return new Promise((resolve) => {
    new PerformanceObserver((list) => {
      const paint = list.getEntriesByName("first-contentful-paint")[0];
      if (paint !== undefined) resolve(paint.startTime);
    }).observe({ type: "paint", buffered: true });
  });
}

/** Runs in the page: presses Run once the robot stands there, and waits until it stands elsewhere. */
async function firstTick(): Promise<number> {
  return new Promise((resolve) => {
    let start: string | null = null;
    const look = (): void => {
      const place = /Robot at [^A-Za-z]+/.exec(document.body?.textContent ?? "")?.[0];
      if (place === undefined) return;
      if (start === null) {
        const run = [...document.querySelectorAll("button")].find(
          (button) => button.textContent === "Run" && !button.disabled,
        );
        if (run === undefined) return;
        start = place;
        run.click();
      } else if (place !== start) {
        watch.disconnect();
        resolve(performance.now());
      }
    };
    const watch = new MutationObserver(look);
    watch.observe(document, { subtree: true, childList: true, characterData: true });
    look();
  });
}

function median(numbers: readonly number[]): number {
  const sorted = numbers.toSorted((a, b) => a - b);
  return sorted[Math.floor(sorted.length / 2)] ?? Number.NaN;
}
