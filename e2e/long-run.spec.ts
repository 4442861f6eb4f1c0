/**
 * A link to a run that takes half a minute to open does not block the page, and can be declined.
 */
import { expect, test } from "./fixtures.ts";

/** A run of a day, as a link. */
const day = "/#1t8_qs-ABgEHmkpSgHdK01g6AAAAABLpOsHcRhNFjPlXm-AkaH5";

test("opens the link of a day-long run in the background, and cancels it", async ({
  openWindow,
}) => {
  const corridor = await openWindow();
  await corridor.open(day);
  const message = corridor.message(/^The run is opening\./);
  await expect(message).toBeVisible();
  await expect(corridor.messages.getByRole("progressbar")).toBeVisible();
  // A reload starts opening the link again, so the link stays in the address.
  expect(new URL(corridor.page.url()).hash).not.toBe("");
  await corridor.run.click();
  await expect(corridor.clock).not.toHaveText("Time 0:00.0");
  await corridor.messages.getByRole("button", { name: "Don’t open it" }).click();
  await expect(message).toBeHidden();
  await expect.poll(() => new URL(corridor.page.url()).hash).toBe("");
  await expect(corridor.pause).toBeVisible();
  await expect(corridor.mazeMenu).toHaveAccessibleName("Long way round, Maze menu");
});

test("displays the page when the simulator cannot be loaded", async ({
  openWindow,
  pageErrors,
}) => {
  const corridor = await openWindow();
  await corridor.page.route(/simulator\.worker/, (route) => route.abort());
  await corridor.page.goto(day);
  await expect(corridor.run).toBeVisible();
  await expect(corridor.page.getByRole("alert").first()).toContainText("simulator");
  // The browser logs an error for the missing file.
  pageErrors.messages.splice(0);
});
