/**
 * Controls that a mission fixes are disabled: the maze tools, and the drive keys in missions
 * without manual driving.
 */
import type { BrowserContextOptions, Page } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import type { CorridorPage } from "./pages/corridor-page.ts";

type OpenWindow = (options?: BrowserContextOptions) => Promise<CorridorPage>;

async function openMission(openWindow: OpenWindow, width: number, id: string): Promise<Page> {
  const corridor = await openWindow({ viewport: { width, height: 860 } });
  await corridor.open(`/#mission/${id}`);
  return corridor.page;
}

test("disables the tools of a maze that a mission fixes with a reason, and keeps Measure enabled", async ({
  openWindow,
}) => {
  const page = await openMission(openWindow, 1440, "centimetres");
  for (const name of ["Blocks", "Start", "Goal"]) {
    const tool = page.getByRole("radio", { name });
    await expect(tool).toBeDisabled();
    await expect(tool).toHaveAccessibleDescription(/^You cannot change this maze/);
  }
  await expect(page.getByRole("radio", { name: "Measure" })).toBeEnabled();
});

test("has no drive keys on a phone where a mission excludes manual driving", async ({
  openWindow,
}) => {
  const page = await openMission(openWindow, 390, "centimetres");
  await expect(page.getByRole("tab", { name: "Program" })).toBeVisible();
  await expect(page.getByRole("tab", { name: "Drive" })).toBeHidden();
  await expect(page.getByRole("group", { name: "Hold to drive" })).toBeHidden();
});

test("shows the drive keys in a mission for manual driving", async ({ openWindow }) => {
  const page = await openMission(openWindow, 390, "make-it-move");
  await expect(page.getByRole("group", { name: "Hold to drive" })).toBeVisible();
});
