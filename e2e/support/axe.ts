/** Runs axe on a state of the page, in the light and the dark theme. */
import { AxeBuilder } from "@axe-core/playwright";
import { expect, type Page } from "playwright/test";
import { waitForAnimations } from "./wait-for-animations.ts";

/** @param state names the state in the report */
export async function expectNoAxeViolations(page: Page, state: string): Promise<void> {
  await setTheme(page, "light");
  // The target-size rule is off by default.
  const allRules = new AxeBuilder({ page }).options({
    rules: { "target-size": { enabled: true } },
  });
  expect(await describeViolations(allRules), `axe, ${state}, light`).toEqual([]);
  await setTheme(page, "dark");
  // The themes differ only in their colours.
  const colours = new AxeBuilder({ page }).withRules("color-contrast");
  expect(await describeViolations(colours), `axe, ${state}, dark`).toEqual([]);
}

/** Sets the theme, and waits until all colour transitions have finished. */
async function setTheme(page: Page, colorScheme: "light" | "dark"): Promise<void> {
  await page.emulateMedia({ colorScheme, reducedMotion: "reduce" });
  await expect(page.locator("html")).toHaveAttribute("data-theme", colorScheme);
  await waitForAnimations(page);
}

async function describeViolations(axe: AxeBuilder): Promise<string[]> {
  const { violations } = await axe.analyze();
  return violations.flatMap(({ id, help, nodes }) =>
    nodes.map(({ target }) => `${id}: ${help}: ${target.join(" ")}`),
  );
}
