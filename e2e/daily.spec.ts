// cspell:words Vorlagen öffnen Januar
import { expect, test } from "./fixtures.ts";

test("opens the maze of the day, the same for everyone, and stores the best run", async ({
  corridor,
  openWindow,
}) => {
  const { page } = corridor;
  await page.clock.setFixedTime("2026-01-05T12:00:00Z");
  await corridor.reload();
  const presets = page.getByRole("button", { name: "Presets", exact: true });
  const dialog = corridor.dialog("Presets");
  await presets.click();
  const daily = dialog.getByRole("region", { name: "Maze of the day" });
  await expect(daily).toContainText("Maze of January 5, 2026");
  await expect(daily).toContainText("You have not solved it yet.");
  await expect(daily.getByRole("button", { name: "Next day" })).toBeDisabled();
  await daily.getByRole("button", { name: "Previous day" }).click();
  await expect(daily).toContainText("Maze of January 4, 2026");
  await daily.getByRole("button", { name: "Next day" }).click();
  await daily.getByRole("button", { name: "Open this maze" }).click();
  await expect(corridor.mazeMenu).toHaveAccessibleName("Maze of January 5, 2026, Maze menu");
  const link = await corridor.shareLink({ withProgram: false });

  // Another user on the same day, with another language.
  const other = await openWindow({ locale: "de" });
  await other.page.clock.setFixedTime("2026-01-05T23:00:00Z");
  await other.page.goto("/");
  await other.page.getByRole("button", { name: "Vorlagen", exact: true }).click();
  await other.page.getByRole("button", { name: "Dieses Labyrinth öffnen" }).click();
  await expect(
    other.page.getByRole("button", { name: /^Labyrinth vom 5\. Januar 2026/ }),
  ).toBeVisible();
  expect(link).toContain("#");
});
