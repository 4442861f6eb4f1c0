/**
 * Runs axe on a state of the page, in the light and the dark theme. Not with `AxeBuilder`, which
 * opens a page of its own and loads axe into both for each run: that covers frames of other sites.
 */
import axe, { type Result, type RunOptions } from "axe-core";
import { expect, type Page } from "playwright/test";
import { waitForAnimations } from "./wait-for-animations.ts";

/** All rules, and target size, which is off by default. */
export const allRules: RunOptions = { rules: { "target-size": { enabled: true } } };

/** For a page with the elements of another page, which stands for their colours. */
export const allButColours: RunOptions = {
  rules: { ...allRules.rules, "color-contrast": { enabled: false } },
};

/** The themes differ only in their colours. */
export const onlyColours = onlyRule("color-contrast");

export function onlyRule(rule: string): RunOptions {
  return { runOnly: { type: "rule", values: [rule] } };
}

/** @param state names the state in the report */
export async function expectNoAxeViolations(page: Page, state: string): Promise<void> {
  await setTheme(page, "light");
  expect(await describeViolations(page, allRules), `axe, ${state}, light`).toEqual([]);
  await setTheme(page, "dark");
  expect(await describeViolations(page, onlyColours), `axe, ${state}, dark`).toEqual([]);
}

/** selectors */
export interface PageParts {
  /** default: the whole page */
  include?: string[];
  exclude: string[];
}

/** Violations in a page without frames. */
export async function axeViolations(
  page: Page,
  options: RunOptions,
  parts: PageParts = { exclude: [] },
): Promise<Result[]> {
  expect(page.frames(), "axe covers pages without frames").toHaveLength(1);
  if (!(await page.evaluate(() => "axe" in window))) await page.evaluate(axe.source);
  return page.evaluate(
    async ([context, runOptions]) => {
      const { axe: loaded } = window as unknown as { axe: typeof axe };
      const { violations } = await loaded.run(context, runOptions);
      return violations;
    },
    [
      parts,
      // Otherwise axe also describes every element that passes.
      { ...options, resultTypes: ["violations"] } satisfies RunOptions,
    ] as const,
  );
}

/** Sets the theme, and waits until all colour transitions have finished. */
async function setTheme(page: Page, colorScheme: "light" | "dark"): Promise<void> {
  await page.emulateMedia({ colorScheme, reducedMotion: "reduce" });
  await expect(page.locator("html")).toHaveAttribute("data-theme", colorScheme);
  await waitForAnimations(page);
}

async function describeViolations(page: Page, options: RunOptions): Promise<string[]> {
  const violations = await axeViolations(page, options);
  return violations.flatMap(({ id, help, nodes }) =>
    nodes.map(({ target }) => `${id}: ${help}: ${target.join(" ")}`),
  );
}
