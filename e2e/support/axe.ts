/** Asks axe about a state of the page, in the light and in the dark theme. */
import { AxeBuilder } from "@axe-core/playwright";
import { expect, type Page } from "playwright/test";
import { atRest } from "./at-rest.ts";

/** @param state names the state in the report */
export async function expectNoBarriers(page: Page, state: string): Promise<void> {
  await putOn(page, "light");
  // The size of targets is asked for by name: axe leaves it out unless told.
  const every = new AxeBuilder({ page }).options({ rules: { "target-size": { enabled: true } } });
  expect(await barriers(every), `axe, ${state}, light`).toEqual([]);
  await putOn(page, "dark");
  // The themes differ in their colours and in nothing else.
  const colours = new AxeBuilder({ page }).withRules("color-contrast");
  expect(await barriers(colours), `axe, ${state}, dark`).toEqual([]);
}

/** Waits for every colour that is on its way to another, even if that takes a frame only. */
async function putOn(page: Page, colorScheme: "light" | "dark"): Promise<void> {
  await page.emulateMedia({ colorScheme, reducedMotion: "reduce" });
  await expect(page.locator("html")).toHaveAttribute("data-theme", colorScheme);
  await atRest(page);
}

async function barriers(axe: AxeBuilder): Promise<string[]> {
  const { violations } = await axe.analyze();
  return violations.flatMap(({ id, help, nodes }) =>
    nodes.map(({ target }) => `${id}: ${help}: ${target.join(" ")}`),
  );
}
