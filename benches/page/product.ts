/**
 * Opens the product's page with a running program: same maze, program and trail as in the variants.
 */
import { encodeLink } from "@corridor/link";
import type { ProgramDocument, Rule } from "@corridor/program";
import { sensorNames } from "@corridor/protocol";
import type { Browser, Page } from "playwright";
import { BenchRun, benchProgram, STAGE_PX } from "./variants/bench-run.ts";
import { waitUntilStored } from "./wait-until-stored.ts";

/** Width of the panel beside the stage, and approximate height of the bars above and below it. */
const PANEL_PX = 412;
const CHROME_PX = 260;

/**
 * The program of the benchmark run, extended to a number of lines. The conditions of the added
 * lines are never true, so that the robot drives the same path. All lines display their truth
 * values.
 */
export function longProgram(lines: number): ProgramDocument {
  const program = benchProgram();
  const added = Array.from({ length: lines - program.rules.length }, (_, at): Rule => ({
    when: { sensor: sensorNames[at % sensorNames.length] ?? "front", is: "<", than: 1 + (at % 20) },
    do: "stop",
  }));
  return { ...program, rules: [...added, ...program.rules] };
}

/**
 * Opens the built page, drives at maximum speed until the trail has its points, and continues in
 * real time.
 * @param program drives the same path as the program of the benchmark run
 */
export async function openProduct(
  browser: Browser,
  url: string,
  side: number,
  program: ProgramDocument = benchProgram(),
): Promise<Page> {
  const benchRun = new BenchRun(side);
  benchRun.driveTrail();
  const link = encodeLink({ maze: benchRun.maze, program });
  if (!link.ok) throw new Error(`the maze cannot be encoded as a link: ${link.code}`);
  const width = STAGE_PX + PANEL_PX;
  const page = await browser.newPage({ viewport: { width, height: STAGE_PX + CHROME_PX } });
  // A long timeout, because the machine may be busy. Opening the page is not measured.
  page.setDefaultTimeout(120_000);
  await page.addInitScript(interceptFrames);
  await page.goto(`${url}/#${link.text}`);
  const canvas = page.locator("canvas").first();
  await canvas.waitFor();
  const height = (await canvas.boundingBox())?.height ?? STAGE_PX;
  await page.setViewportSize({ width, height: 2 * STAGE_PX + CHROME_PX - Math.round(height) });

  const speed = page.getByRole("combobox", { name: "Speed" });
  await speed.selectOption("max");
  await page.getByRole("button", { name: "Run", exact: true }).click();
  const seconds = benchRun.ticks / 60;
  // The trail must be complete. Driving longer does not change the cost of a frame.
  await page.waitForFunction((min) => {
    const clock = /Time\s+(\d+):([\d.]+)/.exec(document.body.innerText);
    return Number(clock?.[1]) * 60 + Number(clock?.[2]) >= min;
  }, seconds);
  await speed.selectOption("1");
  await waitUntilStored(page);
  return page;
}

declare global {
  /** true blocks the frame messages for the panels, so that only the stage is active */
  var arePanelsMuted: boolean | undefined;
}

/** Blocks the frame messages to the page. The worker continues to draw. */
export async function mutePanels(page: Page): Promise<void> {
  await page.evaluate(() => {
    globalThis.arePanelsMuted = true;
  });
}

/**
 * Runs in the page before its own scripts. Receives messages of every worker before the page does.
 */
function interceptFrames(): void {
  const PlainWorker = globalThis.Worker;
  globalThis.Worker = class extends PlainWorker {
    constructor(address: string | URL, options?: WorkerOptions) {
      super(address, options);
      this.addEventListener("message", (event: MessageEvent<{ type?: string }>) => {
        if (globalThis.arePanelsMuted !== true) return;
        if (event.data.type === "frame") event.stopImmediatePropagation();
      });
    }
  };
}
