/**
 * Runs axe on a state of the page, in the light and the dark theme. Not with `AxeBuilder`, which
 * opens a page of its own and loads axe into both for each run: that covers frames of other sites.
 */
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import type axe from "axe-core";
import type { ElementContext, Result, RunOptions } from "axe-core";
import { expect, type Page } from "playwright/test";
import { waitForAnimations } from "./wait-for-animations.ts";

/** The minified source: a browser compiles it faster, and each new page compiles it. */
const axeSource = readFileSync(
  createRequire(import.meta.url).resolve("axe-core/axe.min.js"),
  "utf8",
);

/** All rules, and target size, which is off by default. */
export const allRules: RunOptions = { rules: { "target-size": { enabled: true } } };

/** Selectors of the parts of a page that axe checks. */
export interface PageParts {
  include?: string[];
  exclude: string[];
}

const wholePage: PageParts = { exclude: [] };
const modal = "dialog:modal";

/** For a page with the elements of another page, which stands for their colours. */
export const allButColours: RunOptions = {
  rules: { ...allRules.rules, "color-contrast": { enabled: false } },
};

/** The themes differ only in their colours. */
export const onlyColours = onlyRule("color-contrast");

export function onlyRule(rule: string): RunOptions {
  return { runOnly: { type: "rule", values: [rule] } };
}

/**
 * Runs axe in both themes. Begins with the current one, because changing it repaints the page.
 * Checks colours only in a modal dialog while one is open: nobody can use the page behind it, whose
 * colours do not change, and colours are the most expensive rule.
 * @param state names the state in the report
 */
export async function expectNoAxeViolations(page: Page, state: string): Promise<void> {
  const isDark = (await page.locator("html").getAttribute("data-theme")) === "dark";
  const [first, second] = isDark ? (["dark", "light"] as const) : (["light", "dark"] as const);
  await setTheme(page, first);
  const isModal = (await page.locator(modal).count()) > 0;
  const inDialog: PageParts = isModal ? { include: [modal], exclude: [] } : wholePage;
  const found = isModal
    ? [
        ...(await describeViolations(page, allButColours)),
        ...(await describeViolations(page, onlyColours, inDialog)),
      ]
    : await describeViolations(page, allRules);
  expect(found, `axe, ${state}, ${first}`).toEqual([]);
  await setTheme(page, second);
  const colours = await describeViolations(page, onlyColours, inDialog);
  expect(colours, `axe, ${state}, ${second}`).toEqual([]);
}

/**
 * Violations in a page without frames.
 * @param parts where axe checks
 */
export async function axeViolations(
  page: Page,
  options: RunOptions,
  parts: PageParts = wholePage,
): Promise<Result[]> {
  expect(page.frames(), "axe covers pages without frames").toHaveLength(1);
  if (!(await page.evaluate(() => "axe" in window))) await page.evaluate(axeSource);
  return page.evaluate(
    async ([context, runOptions]) => {
      const { axe: loaded } = window as unknown as { axe: typeof axe };
      const { violations } = await loaded.run(context, runOptions);
      return violations;
    },
    [
      parts satisfies ElementContext,
      {
        ...options,
        // Otherwise axe also describes every element that passes.
        resultTypes: ["violations"],
        // Otherwise axe also reads all style sheets, for a rule that is off by default.
        preload: { assets: ["media"] },
      } satisfies RunOptions,
    ] as const,
  );
}

/** Sets the theme, and waits until all colour transitions have finished. */
async function setTheme(page: Page, colorScheme: "light" | "dark"): Promise<void> {
  await page.emulateMedia({ colorScheme, reducedMotion: "reduce" });
  await expect(page.locator("html")).toHaveAttribute("data-theme", colorScheme);
  await waitForAnimations(page);
}

async function describeViolations(
  page: Page,
  options: RunOptions,
  parts?: PageParts,
): Promise<string[]> {
  const violations = await axeViolations(page, options, parts);
  return violations.flatMap(({ id, help, nodes }) =>
    nodes.map(({ target }) => `${id}: ${help}: ${target.join(" ")}`),
  );
}
