/** Asks axe about a state of the page, in the light and in the dark theme. */
import { AxeBuilder } from "@axe-core/playwright";
import { expect, type Page } from "playwright/test";

/** @param state names the state in the report */
export async function expectNoBarriers(page: Page, state: string): Promise<void> {
  for (const colorScheme of ["light", "dark"] as const) {
    await page.emulateMedia({ colorScheme, reducedMotion: "reduce" });
    await expect(page.locator("html")).toHaveAttribute("data-theme", colorScheme);
    const { violations } = await new AxeBuilder({ page })
      .options({ rules: { "target-size": { enabled: true } } })
      .analyze();
    const found = violations.flatMap(({ id, help, nodes }) =>
      nodes.map(({ target }) => `${id}: ${help}: ${target.join(" ")}`),
    );
    expect(found, `axe, ${state}, ${colorScheme}`).toEqual([]);
  }
}
