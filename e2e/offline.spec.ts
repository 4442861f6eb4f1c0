/** The page works without a network after one visit, and an update never discards edits. */
import type { Page } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import { CorridorPage } from "./pages/corridor-page.ts";
import { ClassTeacher } from "./support/class-teacher.ts";
import { RelayProxy, NEWER_BUILD } from "./support/relay-proxy.ts";
import { RelayProcess } from "../tests/support/relay-process.ts";

test.use({ serviceWorkers: "allow" });

const OFFLINE = "You are offline. Driving and programs still work, but Remote does not.";

/** The service worker downloads all files of the page, which took a slow machine more than 45 s. */
const CACHED_MS = 120_000;

/** Waits until the service worker controls the page, with every file cached. */
async function waitForServiceWorker(page: Page): Promise<void> {
  const isControlled = () => navigator.serviceWorker.controller !== null;
  await page.waitForFunction(isControlled, undefined, { timeout: CACHED_MS });
}

test("drives, programs, builds and shares offline after one visit", async ({ browser }) => {
  const relay = await RelayProcess.start();
  const context = await browser.newContext({ baseURL: relay.url, serviceWorkers: "allow" });
  const page = await context.newPage();
  const corridor = new CorridorPage(page);
  await corridor.open();
  await waitForServiceWorker(page);
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

test("says that a class needs the network, and opens it when the network is back", async ({
  browser,
  relay,
}) => {
  const teacher = await ClassTeacher.start(relay);
  const context = await browser.newContext({ baseURL: relay, serviceWorkers: "allow" });
  const page = await context.newPage();
  await page.goto("/teach");
  await waitForServiceWorker(page);
  await context.setOffline(true);
  await page.goto(teacher.address());
  await expect(page.getByRole("heading", { name: "Your class needs the network" })).toBeVisible();
  await page.getByRole("button", { name: "Try again" }).click();
  await expect(page.getByRole("heading", { name: "Your class needs the network" })).toBeVisible();
  await context.setOffline(false);
  await expect(page.getByRole("heading", { name: "Sensors" })).toBeVisible();
  await expect(page.getByRole("heading", { name: "Your class needs the network" })).toBeHidden();
  await context.close();
});

test("reconnects Remote automatically when the network is back", async ({ browser, relay }) => {
  const context = await browser.newContext({ baseURL: relay, serviceWorkers: "allow" });
  const page = await context.newPage();
  const corridor = new CorridorPage(page);
  await corridor.open();
  await waitForServiceWorker(page);
  await context.setOffline(true);
  await corridor.selectDriver("Remote");
  const remote = page.getByRole("region", { name: "Remote" });
  await expect(remote).toContainText(OFFLINE);
  await context.setOffline(false);
  await expect(remote).not.toContainText(OFFLINE);
  await expect(corridor.connectionStatus).toHaveText("Waiting for a script");
  await context.close();
});

test("offers an update, keeps the unsaved edit and the run, and applies the update on request", async ({
  browser,
  relay,
}) => {
  const proxy = await RelayProxy.start(relay);
  const context = await browser.newContext({ baseURL: proxy.url, serviceWorkers: "allow" });
  const page = await context.newPage();
  const corridor = new CorridorPage(page);
  await corridor.open();
  await waitForServiceWorker(page);
  await corridor.run.click();
  proxy.serveNewerBuild();
  await page.evaluate(async () => (await navigator.serviceWorker.ready).update());
  const offer = corridor.message("A new version of Corridor is ready.");
  await expect(offer).toBeVisible();
  // Nothing changes yet: the run continues, and a lazy-loaded part of the old build still opens.
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
  await proxy.close();
});

test("keeps running the old version in one tab while another applies the update", async ({
  browser,
  relay,
}) => {
  const proxy = await RelayProxy.start(relay);
  const context = await browser.newContext({ baseURL: proxy.url, serviceWorkers: "allow" });
  const first = new CorridorPage(await context.newPage());
  await first.open();
  await waitForServiceWorker(first.page);
  const second = new CorridorPage(await context.newPage());
  await second.open();
  await second.run.click();
  proxy.serveNewerBuild();
  await first.page.evaluate(async () => (await navigator.serviceWorker.ready).update());
  // The second tab takes part in updates once its update client has started.
  await expect(second.message("A new version of Corridor is ready.")).toBeVisible();
  await first.messages.getByRole("button", { name: "Reload" }).click();
  await expect(first.page.locator("html")).toHaveAttribute("data-build", NEWER_BUILD);
  await expect(second.message("A new version of Corridor is ready.")).toBeVisible();
  await expect(second.page.locator("html")).not.toHaveAttribute("data-build");
  // Once the robot has reached the goal, its card has such a button, too.
  await second.page.getByRole("banner").getByRole("button", { name: "Share" }).click();
  await expect(second.dialog("Share this maze")).toBeVisible();
  await context.close();
  await proxy.close();
});

test("leaves the relay's own addresses to the relay", async ({ browser, relay }) => {
  // Not an openWindow fixture: the browser logs an error for an unknown address, as expected.
  const context = await browser.newContext({ baseURL: relay, serviceWorkers: "allow" });
  const page = await context.newPage();
  await new CorridorPage(page).open();
  await waitForServiceWorker(page);
  for (const path of ["/healthz", "/openapi.json", "/api/v1/robots/none", "/r/none"]) {
    const response = await page.goto(path);
    expect(response?.fromServiceWorker(), path).toBe(false);
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
