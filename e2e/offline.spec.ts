/** After one visit the page needs no network, and a newer version never takes anything away. */
import type { Page } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import { CorridorPage } from "./pages/corridor-page.ts";
import { RelayProxy, NEWER_BUILD } from "./support/relay-proxy.ts";
import { RelayProcess } from "./support/relay-process.ts";

test.use({ serviceWorkers: "allow" });
test.setTimeout(120_000);

const OFFLINE = "You are offline. Driving and programs still work, but Remote does not.";

/** All files of the page are fetched once more; a busy machine took more than 15 s for that. */
const KEPT_MS = 45_000;

/** Waits until the device has every file of the page. */
async function isKept(page: Page): Promise<void> {
  const isThere = () => navigator.serviceWorker.controller !== null;
  await page.waitForFunction(isThere, undefined, { timeout: KEPT_MS });
}

test("visits once, loses the network, and drives, programs, builds and shares all the same", async ({
  browser,
}) => {
  const relay = await RelayProcess.start();
  const context = await browser.newContext({ baseURL: relay.url, serviceWorkers: "allow" });
  const page = await context.newPage();
  const corridor = new CorridorPage(page);
  await corridor.open();
  await isKept(page);
  await relay.stop();
  await context.setOffline(true);
  await corridor.reload();

  await corridor.speed.selectOption("max");
  await corridor.run.click();
  await expect(corridor.runNote).toContainText("Goal reached after 39.6 s");

  await corridor.selectDriver("Me");
  await corridor.reset.click();
  await expect(corridor.robotPose).toHaveText(/^Robot at 50, 650/);
  await page.keyboard.down("w");
  await expect.poll(() => corridor.robotX()).toBeGreaterThan(100);
  await page.keyboard.up("w");

  await corridor.selectDriver("Program");
  await corridor.program.number(1).fill("75");
  await corridor.choosePreset("Spiral");
  await corridor.dismissMessages();
  await corridor.maze.button("Resize").click();
  await expect(corridor.dialog("Resize the maze")).toBeVisible();
  await page.keyboard.press("Escape");
  await page.keyboard.press("?");
  await expect(corridor.dialog("Keyboard shortcuts")).toBeVisible();
  await page.keyboard.press("Escape");

  const link = await corridor.shareLink({ withProgram: true });
  await corridor.mazeMenu.click();
  await corridor
    .dialog("Maze menu")
    .getByRole("button", { name: /^New empty maze/ })
    .click();
  await expect(corridor.mazeMenu).toHaveAccessibleName("New maze, Maze menu");
  await page.goto(link);
  await expect(corridor.mazeMenu).toHaveAccessibleName("Spiral, Maze menu");
  await expect(corridor.program.number(1)).toHaveValue("75");

  await corridor.selectDriver("Remote");
  await expect(page.getByRole("region", { name: "Remote" })).toContainText(OFFLINE);
  await context.close();
});

test("goes on with Remote by itself when the network is back", async ({ browser, relay }) => {
  const context = await browser.newContext({ baseURL: relay, serviceWorkers: "allow" });
  const page = await context.newPage();
  const corridor = new CorridorPage(page);
  await corridor.open();
  await isKept(page);
  await context.setOffline(true);
  await corridor.selectDriver("Remote");
  const remote = page.getByRole("region", { name: "Remote" });
  await expect(remote).toContainText(OFFLINE);
  await context.setOffline(false);
  await expect(remote).not.toContainText(OFFLINE);
  await expect(corridor.connectionStatus).toHaveText("Waiting for a script");
  await context.close();
});

test("is offered a newer version, keeps the unsaved edit and the run, and takes it when ready", async ({
  browser,
  relay,
}) => {
  const door = await RelayProxy.start(relay);
  const context = await browser.newContext({ baseURL: door.url, serviceWorkers: "allow" });
  const page = await context.newPage();
  const corridor = new CorridorPage(page);
  await corridor.open();
  await isKept(page);
  await corridor.run.click();
  door.serveNewerBuild();
  await page.evaluate(async () => (await navigator.serviceWorker.ready).update());
  const offer = corridor.message("A new version of Corridor is ready.");
  await expect(offer).toBeVisible();
  // Nothing has changed yet: the run goes on, and a part that was never opened opens.
  const before = await corridor.clock.textContent();
  await expect(corridor.clock).not.toHaveText(before ?? "");
  await corridor.mazeMenu.click();
  await expect(corridor.dialog("Maze menu")).toContainText("New empty maze");
  await page.keyboard.press("Escape");
  await expect(page.locator("html")).not.toHaveAttribute("data-build");

  await corridor.pause.click();
  await corridor.program.name.fill("Edited a moment ago");
  await Promise.all([
    page.waitForEvent("load"),
    corridor.messages.getByRole("button", { name: "Reload" }).click(),
  ]);
  await corridor.waitUntilReady();
  await expect(page.locator("html")).toHaveAttribute("data-build", NEWER_BUILD);
  await expect(corridor.program.name).toHaveValue("Edited a moment ago");
  await expect(offer).toBeHidden();
  await context.close();
  await door.close();
});

test("goes on in one tab while another takes the newer version", async ({ browser, relay }) => {
  const door = await RelayProxy.start(relay);
  const context = await browser.newContext({ baseURL: door.url, serviceWorkers: "allow" });
  const one = new CorridorPage(await context.newPage());
  await one.open();
  await isKept(one.page);
  const two = new CorridorPage(await context.newPage());
  await two.open();
  await two.run.click();
  door.serveNewerBuild();
  await one.page.evaluate(async () => (await navigator.serviceWorker.ready).update());
  // Two takes part in updates once it has had the time to start its own end of them.
  await expect(two.message("A new version of Corridor is ready.")).toBeVisible();
  await one.messages.getByRole("button", { name: "Reload" }).click();
  await expect(one.page.locator("html")).toHaveAttribute("data-build", NEWER_BUILD);
  await expect(two.message("A new version of Corridor is ready.")).toBeVisible();
  await expect(two.page.locator("html")).not.toHaveAttribute("data-build");
  await two.share.click();
  await expect(two.dialog("Share this maze")).toBeVisible();
  await context.close();
  await door.close();
});

test("leaves the relay's own addresses to the relay", async ({ browser, relay }) => {
  // Not a watched window: an unknown address is an error, and is wanted here.
  const context = await browser.newContext({ baseURL: relay, serviceWorkers: "allow" });
  const page = await context.newPage();
  await new CorridorPage(page).open();
  await isKept(page);
  for (const path of ["/healthz", "/openapi.json", "/api/v1/robots/none", "/r/none"]) {
    const answer = await page.goto(path);
    expect(answer?.fromServiceWorker(), path).toBe(false);
  }
  expect((await page.goto("/"))?.fromServiceWorker()).toBe(true);
  await context.close();
});

test("can be installed: a manifest with its icons", async ({ page, relay }) => {
  await page.goto("/");
  const address = await page.locator("link[rel=manifest]").getAttribute("href");
  const manifest = (await (await page.request.get(relay + address)).json()) as {
    start_url: string;
    icons: { src: string; type: string; sizes: string; purpose?: string }[];
  };
  expect(manifest.start_url).toBe("/");
  expect(manifest.icons.map(({ sizes }) => sizes)).toEqual(
    expect.arrayContaining(["192x192", "512x512"]),
  );
  expect(manifest.icons.some(({ purpose }) => purpose === "maskable")).toBe(true);
  for (const { src, type } of manifest.icons) {
    const icon = await page.request.get(relay + src);
    expect(icon.status(), src).toBe(200);
    expect(icon.headers()["content-type"], src).toContain(type);
  }
});
