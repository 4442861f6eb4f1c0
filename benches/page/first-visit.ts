/**
 * Measures a first visit: the time from the start of the navigation until the page receives the
 * robot's first tick. Run is pressed as soon as it is enabled. The baseline is the first paint of a
 * React page with one word. Both pages are built, compressed and served in the same way.
 */
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import type { Browser } from "playwright";
import { build } from "vite";
import { precompress } from "../../apps/web/build/precompress.ts";
import { formatNumber } from "../core/goals.ts";
import { serveFolder } from "./serve-folder.ts";
import type { Section } from "./section.ts";

const ROUNDS = 15;
const page = fileURLToPath(new URL("../../apps/web/dist", import.meta.url));

/** Set by `pressRunAndRecordTick`, in milliseconds since the start of the navigation. */
declare global {
  var runPressedAt: number | undefined;
  var firstTickAt: number | undefined;
}

export const firstVisit: Section = {
  title: "First visit",
  measure: async ({ browser }) => {
    const folder = await buildEmptyPage();
    const [empty, corridor] = await Promise.all([serveFolder(folder), serveFolder(page)]);
    const paints: number[] = [];
    const results: { paint: number; pressed: number; tick: number }[] = [];
    try {
      // The first round warms up the disk cache and the servers.
      for (let round = 0; round <= ROUNDS; round++) {
        const paint = await visit(browser, empty.url, firstPaint);
        const result = await visit(browser, corridor.url, firstTick);
        if (round === 0) continue;
        paints.push(paint);
        results.push(result);
      }
    } finally {
      await Promise.all([empty.stop(), corridor.stop()]);
      rmSync(folder, { recursive: true, force: true });
    }
    const rows = [
      ["empty React page, first paint", paints],
      ["Corridor, first paint", results.map(({ paint }) => paint)],
      ["Corridor, Run enabled", results.map(({ pressed }) => pressed)],
      ["Corridor, first tick", results.map(({ tick }) => tick)],
    ] as const;
    for (const [label, times] of rows) console.log(`  ${label}: ${formatNumber(median(times))} ms`);
    return [
      {
        label: "first tick, relative to the first paint of an empty React page",
        measured: median(results.map(({ tick }, round) => tick / (paints[round] ?? Number.NaN))),
        bound: { atMost: 1.5 },
        unit: "times",
      },
    ];
  },
};

/** Builds the baseline page. @returns the output folder */
async function buildEmptyPage(): Promise<string> {
  const outDir = mkdtempSync(join(tmpdir(), "corridor-empty-"));
  await build({
    root: fileURLToPath(new URL("variants/empty-react/", import.meta.url)),
    configFile: false,
    logLevel: "error",
    define: { "process.env.NODE_ENV": '"production"' },
    plugins: [precompress()],
    build: { outDir, emptyOutDir: true, chunkSizeWarningLimit: 1000 },
  });
  return outDir;
}

/** Opens a URL in a new browser context with empty caches, and evaluates `measure` in the page. */
async function visit<Result>(
  browser: Browser,
  url: string,
  measure: () => Promise<Result>,
): Promise<Result> {
  const context = await browser.newContext({ serviceWorkers: "block" });
  try {
    const window = await context.newPage();
    await window.addInitScript(pressRunAndRecordTick);
    await window.goto(url, { waitUntil: "commit" });
    return await window.evaluate(measure);
  } finally {
    await context.close();
  }
}

/**
 * Runs in the page before its own scripts. Presses Run when it is enabled, and receives messages of
 * the worker right before the page does.
 */
function pressRunAndRecordTick(): void {
  const PlainWorker = globalThis.Worker;
  globalThis.Worker = class extends PlainWorker {
    constructor(address: string | URL, options?: WorkerOptions) {
      super(address, options);
      type Message = { type?: string; frame?: { snapshot: { tick: number } } };
      this.addEventListener("message", ({ data }: MessageEvent<Message>) => {
        if (data.type !== "frame" || (data.frame?.snapshot.tick ?? 0) < 1) return;
        globalThis.firstTickAt ??= performance.now();
      });
    }
  };
  const observer = new MutationObserver(() => {
    const run = [...document.querySelectorAll("button")].find(
      (button) => button.textContent.trim() === "Run" && !button.disabled,
    );
    if (run === undefined) return;
    observer.disconnect();
    globalThis.runPressedAt = performance.now();
    run.click();
  });
  observer.observe(document, { subtree: true, childList: true });
}

/** Runs in the page. @returns milliseconds since the start of the navigation */
async function firstPaint(): Promise<number> {
  return new Promise((resolve) => {
    new PerformanceObserver((list) => {
      const paint = list.getEntriesByName("first-contentful-paint")[0];
      if (paint !== undefined) resolve(paint.startTime);
    }).observe({ type: "paint", buffered: true });
  });
}

/** Runs in the page. @returns times in milliseconds since the start of the navigation */
async function firstTick(): Promise<{ paint: number; pressed: number; tick: number }> {
  for (;;) {
    const paint = performance.getEntriesByName("first-contentful-paint")[0]?.startTime;
    const { runPressedAt: pressed, firstTickAt: tick } = globalThis;
    if (paint !== undefined && pressed !== undefined && tick !== undefined) {
      return { paint, pressed, tick };
    }
    await new Promise((resolve) => setTimeout(resolve, 20));
  }
}

function median(numbers: readonly number[]): number {
  const sorted = numbers.toSorted((a, b) => a - b);
  return sorted[Math.floor(sorted.length / 2)] ?? Number.NaN;
}
