/**
 * The lines of a running program: how many are visible with their truth values, and that none
 * moves.
 */
import { encodeLink } from "@corridor/link";
import { mazePresets } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { Page } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import { CorridorPage } from "./pages/corridor-page.ts";
import { chooseLanguage } from "./support/choose-language.ts";
import { phone } from "./support/phone.ts";
import { Texts } from "./support/texts.ts";
import { waitForAnimations } from "./support/wait-for-animations.ts";

/**
 * The first line turns with a delay, the second on the spot, and "otherwise" drives. All kinds of
 * notes are displayed, and no advice.
 */
const rules: ProgramDocument["rules"] = [
  { when: { sensor: "right", is: ">", than: 60 }, do: "delayed right 90" },
  { when: { sensor: "front", is: "<", than: 50 }, do: "left 90" },
  { when: { sensor: "back", is: "<", than: 30 }, do: "forward" },
  { when: { sensor: "left", is: "<", than: 30 }, do: "forward" },
  { when: { sensor: "right", is: "<", than: 30 }, do: "forward" },
  { when: { sensor: "left", is: ">", than: "right", plus: 300 }, do: "forward" },
];

function linkOf(count: number): string {
  const maze = mazePresets.find(({ id }) => id === "long-way-round")?.maze;
  if (maze === undefined) throw new Error("the preset is missing");
  const link = encodeLink({
    maze,
    program: {
      format: "corridor/program",
      version: 1,
      name: `${count} lines`,
      default: "forward",
      rules: rules.slice(0, count),
    },
  });
  if (!link.ok) throw new Error(link.code);
  return link.text;
}

interface Lines {
  /** position and height of each line, as JSON */
  positions: string;
  /** number of lines that are visible with their truth values without scrolling */
  visible: number;
  /** ids of the lines that drive now */
  running: string[];
}

/**
 * Records the lines once, or in each frame until several have driven one after the other. The page
 * records them, because a run can end between two questions of a slow test.
 */
async function recordLines(page: Page, until: "now" | "several have driven"): Promise<Lines[]> {
  return page.evaluate((end) => {
    const boxOf = (element: Element) => element.getBoundingClientRect();
    const isVisible = (line: Element): boolean =>
      [line, line.querySelector("[data-is]")].every((part) => {
        if (part === null) return false;
        const box = boxOf(part);
        if (box.height === 0 || box.top < 0 || box.bottom > innerHeight) return false;
        for (let above = part.parentElement; above !== null; above = above.parentElement) {
          if (!/auto|scroll|hidden|clip/.test(getComputedStyle(above).overflowY)) continue;
          if (box.top < boxOf(above).top || box.bottom > boxOf(above).bottom) return false;
        }
        return true;
      });
    const look = (): Lines => {
      const lines = [...document.querySelectorAll("[id^='program-line-']")];
      return {
        positions: JSON.stringify(lines.map((line) => [boxOf(line).top, boxOf(line).height])),
        visible: lines.filter(isVisible).length,
        running: lines.filter((line) => line.ariaCurrent !== null).map(({ id }) => id),
      };
    };
    return new Promise<Lines[]>((resolve) => {
      const seen: Lines[] = [];
      const driven = new Set<string>();
      const recordFrame = (): void => {
        const lines = look();
        seen.push(lines);
        for (const id of lines.running) driven.add(id);
        if (end === "now" || driven.size > 1) resolve(seen);
        else requestAnimationFrame(recordFrame);
      };
      recordFrame();
    });
  }, until);
}

async function lookAtLines(page: Page): Promise<Lines> {
  const [lines] = await recordLines(page, "now");
  if (lines === undefined) throw new Error("No frame was recorded.");
  return lines;
}

/** Opens a program of the given number of lines in the open page, with the robot at its start. */
async function openLines(page: Page, count: number): Promise<void> {
  await page.evaluate((hash) => (location.hash = hash), linkOf(count));
  await expect(page.locator(`input[value="${count} lines"]`)).toBeAttached();
  await expect(page.locator("[id^='program-line-']")).toHaveCount(count);
  await expect(page.getByText(/ 0:00[.,]0$/)).toBeAttached();
}

/** How many lines are visible at a size, with two of them driving one after the other. */
interface Screen {
  width: number;
  height: number;
  count: number;
}

async function showsRunningLines(page: Page, screen: Screen, lang: string): Promise<void> {
  const { width, height, count } = screen;
  const texts = Texts.load(lang);
  const button = (path: string) => page.getByRole("button", { name: texts.t(path), exact: true });
  await page.setViewportSize({ width, height });
  await openLines(page, count);
  await expect(page.locator("[id^='program-line-'] [data-is='false']").first()).toBeVisible();
  await page.evaluate(() => document.fonts.ready);
  await waitForAnimations(page);
  const before = await lookAtLines(page);
  expect(before.visible).toBe(count);
  await button("shell.run.run").click();
  // Several lines drive one after the other, each with its progress.
  for (const { positions, visible } of await recordLines(page, "several have driven")) {
    expect(positions).toBe(before.positions);
    expect(visible).toBe(count);
  }
  await button("shell.run.pause").click();
  expect((await lookAtLines(page)).positions).toBe(before.positions);
}

/** Shows lines on each screen in English and in German, and ends in English. */
async function showsRunningLinesInBothLanguages(corridor: CorridorPage, screens: Screen[]) {
  const { page } = corridor;
  // Not the first visit, whose invitation takes space until a run.
  await corridor.open(`/#${linkOf(screens[0]?.count ?? 0)}`);
  const [english, german] = [Texts.load("en"), Texts.load("de")];
  for (const lang of ["en", "de"]) {
    if (lang === "de") await chooseLanguage(page, english, "de");
    for (const screen of screens) {
      const { width, height, count } = screen;
      await test.step(`${count} lines at ${width} x ${height}, in ${lang}`, () =>
        showsRunningLines(page, screen, lang));
    }
  }
  await chooseLanguage(page, german, "en");
}

async function movesNoLineAtBump(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  await page.setViewportSize({ width: 1440, height: 900 });
  await openLines(page, 6);
  // A line that turns late in front of a wall runs out of space, and gets advice before the run.
  const action = page.getByRole("combobox", { name: "Line 2, action" });
  await action.selectOption("delayed left 90");
  await expect(page.getByRole("button", { name: "Change to left 90" })).toBeVisible();
  await page.locator("main").click({ position: { x: 5, y: 5 } });
  const before = await lookAtLines(page);
  await expect(page.getByRole("group", { name: "Hold to drive" })).toHaveCount(0);
  await expect(page.getByLabel("Distances in cm")).toBeInViewport({ ratio: 1 });
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await expect(page.getByRole("listitem", { name: /^Line 2, look here/ })).toBeVisible();
  expect((await lookAtLines(page)).positions).toBe(before.positions);
  // The drive keys are displayed again when the user drives.
  await corridor.selectDriver("Me");
  await expect(page.getByRole("group", { name: "Hold to drive" })).toBeInViewport({ ratio: 1 });
}

test("shows the lines of a running program, and moves none, in English and German", async ({
  page,
}) => {
  const corridor = new CorridorPage(page);
  await showsRunningLinesInBothLanguages(corridor, [
    { width: 1440, height: 900, count: 6 },
    { width: 1024, height: 768, count: 4 },
  ]);
  await test.step("moves no line at a bump, and shows the readings in one row while a long program drives", () =>
    movesNoLineAtBump(corridor));
});

test("shows 3 lines of a running program on a phone, and moves none, in English and German", async ({
  openWindow,
}) => {
  const corridor = await openWindow(phone);
  await showsRunningLinesInBothLanguages(corridor, [{ ...phone.viewport, count: 3 }]);
});
