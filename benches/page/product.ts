/** The product's page with a run under way: the same maze, program and trail as the variants have. */
import { encodeLink } from "@corridor/link";
import type { ProgramDocument, Rule } from "@corridor/program";
import { sensorNames } from "@corridor/protocol";
import type { Browser, Page } from "playwright";
import { Scenery, STAGE_PX, sceneryProgram } from "./variants/scenery.ts";

/** Width of the panel beside the stage, and about what stands above and below it. */
const PANEL_PX = 412;
const AROUND_PX = 260;

/**
 * The scenery's program with so many lines: those above its own are never true, so that the robot drives the
 * same way, and all of them show their truths.
 */
export function longProgram(lines: number): ProgramDocument {
  const program = sceneryProgram();
  const above = Array.from({ length: lines - program.rules.length }, (_, at): Rule => ({
    when: { sensor: sensorNames[at % sensorNames.length] ?? "front", is: "<", than: 1 + (at % 20) },
    do: "stop",
  }));
  return { ...program, rules: [...above, ...program.rules] };
}

/**
 * Opens the built page, drives until the trail has its points, and lets the robot drive on in real time.
 * @param program drives as the scenery's own
 */
export async function openProduct(
  browser: Browser,
  url: string,
  side: number,
  program: ProgramDocument = sceneryProgram(),
): Promise<Page> {
  const scenery = new Scenery(side);
  scenery.runUp();
  const link = encodeLink({ maze: scenery.maze, program });
  if (!link.ok) throw new Error(`the maze fits no link: ${link.code}`);
  const width = STAGE_PX + PANEL_PX;
  const page = await browser.newPage({ viewport: { width, height: STAGE_PX + AROUND_PX } });
  // The machine may be busy; how long this takes is not measured.
  page.setDefaultTimeout(120_000);
  await page.addInitScript(letPanelsBeQuiet);
  await page.goto(`${url}/#${link.text}`);
  const canvas = page.locator("canvas").first();
  await canvas.waitFor();
  const height = (await canvas.boundingBox())?.height ?? STAGE_PX;
  await page.setViewportSize({ width, height: 2 * STAGE_PX + AROUND_PX - Math.round(height) });

  const speed = page.getByRole("combobox", { name: "Speed" });
  await speed.selectOption("max");
  await page.getByRole("button", { name: "Run", exact: true }).click();
  const seconds = scenery.ticks / 60;
  // More than the trail holds does no harm; less would be another picture.
  await page.waitForFunction((most) => {
    const clock = /Time\s+(\d+):([\d.]+)/.exec(document.body.innerText);
    return Number(clock?.[1]) * 60 + Number(clock?.[2]) >= most;
  }, seconds);
  await speed.selectOption("1");
  return page;
}

declare global {
  /** set to keep what the panels show from the page, so that the stage is alone */
  var arePanelsQuiet: boolean | undefined;
}

/** From here on the page hears no news of the run; the worker goes on drawing. */
export async function quietPanels(page: Page): Promise<void> {
  await page.evaluate(() => {
    globalThis.arePanelsQuiet = true;
  });
}

/** Runs in the page before its own scripts: hears every worker's messages first. */
function letPanelsBeQuiet(): void {
  const PlainWorker = globalThis.Worker;
  globalThis.Worker = class extends PlainWorker {
    constructor(address: string | URL, options?: WorkerOptions) {
      super(address, options);
      this.addEventListener("message", (event: MessageEvent<{ type?: string }>) => {
        if (globalThis.arePanelsQuiet !== true) return;
        if (event.data.type === "frame") event.stopImmediatePropagation();
      });
    }
  };
}
