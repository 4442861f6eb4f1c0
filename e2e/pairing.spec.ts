// cspell:words إيقاف مؤقّت
/** Pairing: a script with a typed code drives once the page's owner allows it. */
import type { Registration } from "@corridor/protocol";
import type { Locator, Page } from "playwright/test";
import { fileURLToPath } from "node:url";
import { expect, test } from "./fixtures.ts";
import { CorridorPage } from "./pages/corridor-page.ts";
import { expectNoAxeViolations } from "./support/axe.ts";
import { waitForAnimations } from "./support/wait-for-animations.ts";
import { boxOf, phone, smallestPhone, tab } from "./support/phone.ts";
import { commandRow, openMoreSection } from "./support/remote-panel.ts";
import { exampleCommand, runScript } from "./support/script.ts";
import { smallWindow } from "./support/window-sizes.ts";

test.use(smallWindow);

const library = fileURLToPath(new URL("../packages/client-python/src/", import.meta.url));

/** output of a script until the owner has answered */
const waitingLine = "Waiting for 'Yes, let it drive' on the robot's page.\n";

/** Runs a student's script, which needs only the page's address and the code on the screen. */
function runPaired(origin: string, code: string): ReturnType<typeof runScript> {
  const [python = ""] = exampleCommand("Python");
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

const codeText = /^[BCDFGHJKLMNPQRSTVWXZ]{4} [BCDFGHJKLMNPQRSTVWXZ]{4}$/;

async function showCode(page: Page): Promise<string> {
  await page.getByRole("button", { name: "Show a code to type" }).click();
  const code = page.getByText(codeText);
  await expect(code).toBeVisible();
  await expect(page.getByText(/Valid for 9:\d\d|Valid for 10:00/)).toBeVisible();
  return (await code.textContent()) ?? "";
}

/** Opens the part of Remote with the codes. */
async function openRemote(page: Page): Promise<void> {
  await page.goto("/");
  await page.getByRole("radio", { name: "Remote" }).click();
  await openMoreSection(page);
}

const question = "Right wall (Python script) wants to drive this robot.";
const yes = { name: "Yes, let it drive" };
const no = { name: "No", exact: true };

async function expectLargeEnough(page: Page): Promise<void> {
  for (const name of [yes, no]) {
    const { height, width } = await boxOf(page.getByRole("button", name).first());
    expect(Math.min(height, width)).toBeGreaterThanOrEqual(44);
  }
}

test("a script with a code drives once the owner allows it, until its key is revoked", async ({
  page,
}) => {
  await openRemote(page);

  await test.step("a cancelled code is rejected", async () => {
    const code = await showCode(page);
    await page.getByRole("button", { name: "Cancel code" }).click();
    await expect(page.getByRole("button", { name: "Show a code to type" })).toBeFocused();
    const { output } = await runPaired(new URL(page.url()).origin, code);
    expect(output.trim()).toBe("wrong-code");
  });

  await test.step("a script with the code drives once the owner allows it", async () => {
    const code = await showCode(page);
    await expectNoAxeViolations(page, "a pairing code is shown");
    const running = runPaired(new URL(page.url()).origin, code.toLowerCase());
    await expect(page.getByRole("status").filter({ hasText: question })).toBeVisible();
    await expectNoAxeViolations(page, "a script asks to drive");
    await expectLargeEnough(page);
    await page.getByRole("button", { name: "Yes, let it drive" }).focus();
    await page.keyboard.press("Enter");
    const { code: exit, output } = await running;
    expect([exit, output.trim()]).toEqual([0, `${waitingLine}completed`]);
    await expect(
      page.getByText("Right wall (Python script) can drive now. It has its own key."),
    ).toBeVisible();
    await expect(page.getByRole("button", { name: "Show a code to type" })).toBeFocused();
    await expect(commandRow(page, /right 90/)).toContainText("completed");
    const scripts = page.getByRole("region", { name: "Scripts" }).getByRole("listitem");
    await expect(scripts).toHaveText([/Right wall/]);
    // The paired key is listed, and revoking it does not affect the key in the address.
    const keys = page.getByRole("region", { name: "Keys" });
    await expect(keys.getByRole("listitem")).toHaveText([
      /Key of the address above.*made .*never used/,
      /Right wall.*Key to drive.*made this minute.*Revoke/,
    ]);
    await expectNoAxeViolations(page, "keys are listed");
    await keys.getByRole("button", { name: "Revoke" }).click();
    await expect(keys.getByRole("status")).toHaveText("The key was revoked.");
    await expect(keys.getByRole("listitem")).toHaveText([/Key of the address above/]);
    await expect(keys.getByRole("heading")).toBeFocused();
  });

  await test.step("a paired script continues when the address gets a new key", async () => {
    const code = await showCode(page);
    const { origin } = new URL(page.url());
    const body = JSON.stringify({ code, name: "Right wall" });
    const headers = { "content-type": "application/json", "user-agent": "python-requests/2.32" };
    const requested = await fetch(`${origin}/api/v1/pairing`, { method: "POST", headers, body });
    const { key } = (await requested.json()) as { key: string };
    await page.getByRole("button", { name: "Yes, let it drive" }).click();
    const keys = page.getByRole("region", { name: "Keys" });
    const paired = /Key to drive.*made this minute.*Revoke/;
    await expect(keys.getByRole("listitem")).toHaveText([/Key of the address above/, paired]);

    await page.getByRole("button", { name: "New key" }).click();
    const dialog = page.getByRole("dialog");
    await expect(dialog).toContainText("Scripts that use a code have their own keys");
    await expectNoAxeViolations(page, "a new key is asked for");
    await dialog.getByRole("button", { name: "New key" }).click();
    await expect(page.getByText("The new key is ready. Copy the address again.")).toBeVisible();
    const authorised = { ...headers, authorization: `Bearer ${key}` };
    const found = await fetch(`${origin}/api/v1/pairing`, { headers: authorised });
    const { address } = (await found.json()) as { address: string };
    const commands = `${origin}/api/v1/robots/${new URL(address).pathname.slice("/r/".length)}/commands`;
    const turn = JSON.stringify({ action: "left 90" });
    const sent = await fetch(commands, { method: "POST", headers: authorised, body: turn });
    expect(sent.status).toBe(202);
    await expect(commandRow(page, /left 90/)).toContainText("completed");
    // The newer key is the address's own.
    await expect(keys.getByRole("listitem")).toHaveText([
      /Key of the address above.*never used/,
      paired,
    ]);
    await keys.getByRole("button", { name: "Revoke" }).click();
    await expect(keys.getByRole("listitem")).toHaveText([/Key of the address above/]);
    expect((await fetch(commands, { headers: authorised })).status).toBe(401);
  });
});

test("asks the owner wherever they are on the page", async ({ page }) => {
  const corridor = new CorridorPage(page);
  await openRemote(page);

  await test.step("a question after a reload, which the owner answers with no", async () => {
    const code = await showCode(page);
    const running = runPaired(new URL(page.url()).origin, code);
    await expect(page.getByText(question)).toBeVisible();
    await page.reload();
    await expect(page.getByText(question)).toBeVisible();
    await page.getByRole("button", { name: "No", exact: true }).click();
    const { code: exit, output } = await running;
    expect([exit, output.trim()]).toEqual([1, `${waitingLine}pairing-refused`]);
    await expect(
      corridor.messages.getByText("Right wall (Python script) cannot drive: you said no."),
    ).toBeVisible();
  });

  await openMoreSection(page);
  await test.step("a modal dialog blocks the rest of the page", async () => {
    const code = await showCode(page);
    await corridor.share.click();
    const dialog = page.getByRole("dialog", { name: "Share" });
    const running = runPaired(new URL(page.url()).origin, code);
    await expect(dialog.getByRole("status").filter({ hasText: question })).toBeVisible();
    await expectNoAxeViolations(page, "a script asks while a dialog is open");
    await expectLargeEnough(page);
    await dialog.getByRole("button", no).click();
    await expect(dialog.getByText(question)).toHaveCount(0);
    const { output } = await running;
    expect(output.trim()).toBe(`${waitingLine}pairing-refused`);
    await page.keyboard.press("Escape");
    await expect(dialog).toBeHidden();
  });

  await test.step("another driver is selected", async () => {
    const code = await showCode(page);
    await corridor.selectDriver("Program");
    await expect(page.getByRole("button", { name: "Cancel code" })).toBeHidden();
    await corridor.speed.focus();
    const running = runPaired(new URL(page.url()).origin, code);
    await expect(corridor.messages.getByRole("status").filter({ hasText: question })).toBeVisible();
    await expect(corridor.speed).toBeFocused();
    await expectNoAxeViolations(page, "a script asks while the program drives");
    await expectLargeEnough(page);
    await page.getByRole("button", yes).focus();
    await page.keyboard.press("Enter");
    await expect(page.getByRole("button", yes)).toBeHidden();
    await expect(page.getByText(question)).toHaveCount(0);
    await expect(corridor.messages).toContainText(
      "Right wall (Python script) can drive now. It has its own key. Remote is not driving: choose Remote first.",
    );
    const { output } = await running;
    expect(output).toContain("cancelled");
  });

  await corridor.selectDriver("Remote");
  await openMoreSection(page);
  await test.step("the panel with the question is below the screen", async () => {
    await page.setViewportSize({ width: 760, height: 800 });
    const code = await showCode(page);
    await page.evaluate(() => scrollTo(0, 0));
    const running = runPaired(new URL(page.url()).origin, code);
    const { messages } = corridor;
    await expect(messages.getByText(question)).toBeVisible();
    // Once the panel is visible, the question is displayed only there.
    await page.getByRole("button", { name: "Yes" }).last().scrollIntoViewIfNeeded();
    await expect(messages.getByText(question)).toHaveCount(0);
    await page.getByRole("button", no).click();
    await running;
  });
});

/** Prepares a tab with a pending pairing request, as before a reload. */
async function preparePairingRequest(page: Page, origin: string, name: string): Promise<void> {
  // A document of the same origin, without scripts.
  await page.goto(`${origin}/robots.txt`);
  const json = { "content-type": "application/json" };
  const registered = await fetch(`${origin}/api/v1/robots`, { method: "POST" });
  const { id, ownerKey, driverKey, address } = (await registered.json()) as Registration;
  const headers = { ...json, authorization: `Bearer ${ownerKey}` };
  const created = await fetch(`${origin}/api/v1/robots/${id}/pairing`, { method: "POST", headers });
  const { code } = (await created.json()) as { code: string };
  const body = JSON.stringify({ code, name });
  await fetch(`${origin}/api/v1/pairing`, { method: "POST", headers: json, body });
  const session = JSON.stringify({ id, ownerKey, driverKey, address, lastApplied: 0 });
  await page.evaluate((text) => {
    sessionStorage.setItem("corridor.remote", text);
    sessionStorage.setItem("corridor.remote.driving", "yes");
  }, session);
}

function longQuestion(page: Page): Locator {
  return page.locator("section").filter({ hasText: "Right wall of a long corridor" });
}

/** Expects that a question covers neither the button that stops the robot nor the whole maze. */
async function expectStopButtonInReach(page: Page, pause: string): Promise<void> {
  const width = page.viewportSize()?.width ?? 0;
  const messages = longQuestion(page);
  const answers = messages.getByRole("button");
  await expect(answers).toHaveCount(2);
  const sheet = page.getByRole("complementary");
  const bar = page.getByRole("banner");
  for (const at of [1, 0]) {
    await page.getByRole("tab").nth(at).tap();
    await waitForAnimations(page);
    const questionBox = await boxOf(messages);
    const [above, below] = [await boxOf(bar), await boxOf(sheet)];
    expect(questionBox.x).toBeGreaterThanOrEqual(0);
    expect(questionBox.x + questionBox.width).toBeLessThanOrEqual(width);
    expect(questionBox.y).toBeGreaterThanOrEqual(above.y + above.height);
    expect(questionBox.y + questionBox.height).toBeLessThanOrEqual(below.y + 0.5);
    for (const box of [await boxOf(answers.first()), await boxOf(answers.last())]) {
      expect(Math.min(box.width, box.height)).toBeGreaterThanOrEqual(44);
    }
    // Nothing covers the touch targets.
    await page.getByRole("button", { name: pause }).tap({ trial: true });
    await bar.getByRole("button").last().tap({ trial: true });
    // A part of the maze is visible.
    expect(questionBox.y - above.y - above.height).toBeGreaterThanOrEqual(44);
    const scrolled = await page.evaluate(() => document.documentElement.scrollWidth);
    expect(scrolled).toBeLessThanOrEqual(width);
  }
}

test.describe("on a phone", () => {
  test.use(phone);

  test("a request appears on another tab, also after a reload, and does not cover the button that stops the robot", async ({
    page,
    relay,
  }) => {
    await test.step("a script's request appears on another tab, also after a reload of the page", async () => {
      await page.goto("/");
      await page.getByRole("button", { name: "More" }).tap();
      await page.getByRole("button", { name: "Remote" }).tap();
      const dialog = page.getByRole("dialog", { name: "Remote" });
      // `check` would expect the new state at once, but the worker reports it.
      const remote = dialog.getByRole("radio", { name: "Remote" });
      await remote.tap({ force: true });
      await expect(remote).toBeChecked();
      await openMoreSection(dialog);
      await dialog.getByRole("button", { name: "Show a code to type" }).tap();
      const code = await dialog.getByText(codeText).textContent();
      await dialog.getByRole("button", { name: "Close" }).tap();
      await tab(page, "Presets").tap();
      await page.reload();
      const running = runPaired(new URL(page.url()).origin, code ?? "");
      const messages = page.getByRole("region", { name: "Messages" });
      await expect(messages.getByText(question)).toBeVisible();
      await expectNoAxeViolations(page, "a script asks on a phone");
      await messages.getByRole("button", { name: "Yes, let it drive" }).tap();
      await expect(messages.getByText(question)).toHaveCount(0);
      const { code: exit, output } = await running;
      expect([exit, output.trim()]).toEqual([0, `${waitingLine}completed`]);
    });

    for (const { sizes, path, pause } of [
      { sizes: [phone, smallestPhone], path: "/", pause: "Pause" },
      { sizes: [smallestPhone], path: "/?lang=de", pause: "Pause" },
      { sizes: [smallestPhone], path: "/?lang=ar", pause: "إيقاف مؤقّت" },
    ]) {
      await test.step(path, async () => {
        await page.setViewportSize(sizes[0]?.viewport ?? phone.viewport);
        await preparePairingRequest(page, relay, "Right wall of a long corridor");
        await page.goto(path);
        for (const { viewport } of sizes) {
          await page.setViewportSize(viewport);
          await expectStopButtonInReach(page, pause);
          if (viewport === phone.viewport) {
            await expectNoAxeViolations(page, "a script asks while a phone drives");
          }
        }
        const answers = longQuestion(page).getByRole("button");
        await answers.last().tap();
        await expect(answers).toHaveCount(0);
      });
    }
  });
});
