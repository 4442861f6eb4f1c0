/** Runs axe on a state of the page, in the light and the dark theme. */
import { AxeBuilder } from "@axe-core/playwright";
import { expect, type Page } from "playwright/test";
import { waitForAnimations } from "./wait-for-animations.ts";

/** @param state names the state in the report */
export async function expectNoAxeViolations(page: Page, state: string): Promise<void> {
  await setTheme(page, "light");
  expect(await describeViolations(allRules(page)), `axe, ${state}, light`).toEqual([]);
  await setTheme(page, "dark");
  expect(await describeViolations(onlyColours(page)), `axe, ${state}, dark`).toEqual([]);
}

/** Otherwise axe also describes every element that passes. */
const resultTypes: ["violations"] = ["violations"];

/** All rules, and target size, which is off by default. */
export function allRules(page: Page): AxeBuilder {
  const rules = { "target-size": { enabled: true } };
  return new AxeBuilder({ page }).options({ resultTypes, rules });
}

/** The themes differ only in their colours. */
export function onlyColours(page: Page): AxeBuilder {
  return new AxeBuilder({ page }).options({
    resultTypes,
    runOnly: { type: "rule", values: ["color-contrast"] },
  });
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
