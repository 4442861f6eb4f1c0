/** A script is let in by a code that somebody types, once the page's owner says yes. */
import type { Page } from "playwright/test";
import { fileURLToPath } from "node:url";
import { expect, test } from "./fixtures.ts";
import { expectNoBarriers } from "./support/axe.ts";
import { exampleOf, runScript } from "./support/script.ts";

const library = fileURLToPath(new URL("../packages/client-python/src/", import.meta.url));

/** A student's script: it has the page's address and what stands on the screen. */
function runPaired(origin: string, code: string): ReturnType<typeof runScript> {
  const [python = ""] = exampleOf("Python");
  const script = `
import sys
sys.path.insert(0, ${JSON.stringify(library)})
from corridor import PairingError, Robot
try:
    robot = Robot.pair(${JSON.stringify(origin)}, ${JSON.stringify(code)}, name="Right wall")
except PairingError as error:
    sys.exit(error.code)
print(robot.right().state)
`;
  return runScript([python, "-"], script);
}

async function showCode(page: Page): Promise<string> {
  await page.goto("/");
  await page.getByRole("radio", { name: "Remote" }).click();
  await page.getByRole("button", { name: "Show a code to type" }).click();
  const code = page.getByText(/^[BCDFGHJKLMNPQRSTVWXZ]{4} [BCDFGHJKLMNPQRSTVWXZ]{4}$/);
  await expect(code).toBeVisible();
  await expect(page.getByText(/Counts for 9:\d\d|Counts for 10:00/)).toBeVisible();
  return (await code.textContent()) ?? "";
}

const question = "Right wall (Python script) wants to drive this robot.";

test("a script that types the code drives once the page says yes", async ({ page }) => {
  const code = await showCode(page);
  await expectNoBarriers(page, "a pairing code is shown");
  const running = runPaired(new URL(page.url()).origin, code.toLowerCase());
  await expect(page.getByRole("status").filter({ hasText: question })).toBeVisible();
  await expectNoBarriers(page, "a script asks to drive");
  for (const name of ["Yes, let it drive", "No"]) {
    const box = await page.getByRole("button", { name, exact: true }).boundingBox();
    expect(box?.height).toBeGreaterThanOrEqual(44);
    expect(box?.width).toBeGreaterThanOrEqual(44);
  }
  await page.getByRole("button", { name: "Yes, let it drive" }).focus();
  await page.keyboard.press("Enter");
  const { code: exit, output } = await running;
  expect([exit, output.trim()]).toEqual([0, "completed"]);
  await expect(
    page.getByText("Right wall (Python script) may drive now, with a key of its own."),
  ).toBeVisible();
  await expect(page.getByRole("button", { name: "Show a code to type" })).toBeFocused();
  await expect(page.getByRole("row", { name: /right 90/ })).toContainText("completed");
  const scripts = page.getByRole("region", { name: "Scripts" }).getByRole("listitem");
  await expect(scripts).toHaveText([/Right wall/]);
  // Its key is listed, and can be taken back without harm to the one in the address.
  const keys = page.getByRole("region", { name: "Keys" });
  await expect(keys.getByRole("listitem")).toHaveText([
    /Key of the address above.*made .*never used/,
    /Right wall.*Key to drive.*made this minute.*Revoke/,
  ]);
  await expectNoBarriers(page, "keys are listed");
  await keys.getByRole("button", { name: "Revoke" }).click();
  await expect(keys.getByRole("status")).toHaveText("The key was revoked.");
  await expect(keys.getByRole("listitem")).toHaveText([/Key of the address above/]);
  await expect(keys.getByRole("heading")).toBeFocused();
});

test("a script that the page says no to is told so, also after a reload of the page", async ({
  page,
}) => {
  const code = await showCode(page);
  const running = runPaired(new URL(page.url()).origin, code);
  await expect(page.getByText(question)).toBeVisible();
  await page.reload();
  await expect(page.getByText(question)).toBeVisible();
  await page.getByRole("button", { name: "No", exact: true }).click();
  const { code: exit, output } = await running;
  expect([exit, output.trim()]).toEqual([1, "pairing-refused"]);
  await expect(page.getByText("Right wall (Python script) was told no.")).toBeVisible();
});

test("a code that was taken back counts no more", async ({ page }) => {
  const code = await showCode(page);
  await page.getByRole("button", { name: "Take back" }).click();
  await expect(page.getByRole("button", { name: "Show a code to type" })).toBeFocused();
  const { output } = await runPaired(new URL(page.url()).origin, code);
  expect(output.trim()).toBe("wrong-code");
});
