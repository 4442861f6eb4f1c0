/** The page works without a network after one visit, and an update never discards edits. */
import { encodeLink } from "@corridor/link";
import type { Page } from "playwright/test";
import {
  linkOf,
  programOf,
  sampleLesson,
} from "../apps/web/src/features/teach/testing/sample-lesson.ts";
import { expect, test } from "./fixtures.ts";
import { CorridorPage } from "./pages/corridor-page.ts";
import { TeachPage } from "./pages/teach-page.ts";
import { ClassTeacher } from "./support/class-teacher.ts";
import { RelayProxy, NEWER_BUILD } from "./support/relay-proxy.ts";
import { smallWindow } from "./support/window-sizes.ts";
import { RelayProcess } from "../tests/support/relay-process.ts";

test.use({ serviceWorkers: "allow" });

const OFFLINE = "You are offline. Driving and programs still work, but Remote does not.";

const lesson = encodeLink({ lesson: sampleLesson });

/** The service worker downloads all files of the page, which took a slow machine more than 45 s. */
const CACHED_MS = 120_000;

/** Waits until the service worker controls the page, with every file cached. */
async function waitForServiceWorker(page: Page): Promise<void> {
  const isControlled = () => navigator.serviceWorker.controller !== null;
  await page.waitForFunction(isControlled, undefined, { timeout: CACHED_MS });
}

// Each context downloads all files of the page, so that tests of one network share a context. Not
// openWindow fixtures: the browser logs an error for each failed request, as expected.

test("checks hand-ins, drives, programs, builds and shares offline after one visit, and connects when the network is back", async ({
  browser,
}) => {
  const relay = await RelayProcess.start();
  const options = { baseURL: relay.url, serviceWorkers: "allow" } as const;
  const context = await browser.newContext(options);
  const page = await context.newPage();
  const corridor = new CorridorPage(page);

  await test.step("a teacher checks hand-ins offline", async () => {
    const teach = new TeachPage(page);
    await teach.openHandIns(lesson.ok ? lesson.text : "");
    await waitForServiceWorker(page);
    await context.setOffline(true);
    await page.reload();
    await teach.checkLines([linkOf(programOf("right-wall", "Juniper"))]);
    await expect(teach.rows.first()).toContainText("passes");
    await context.setOffline(false);
  });

  await test.step("a class says that it needs the network, and opens when the network is back", async () => {
    const teacher = await ClassTeacher.start(relay.url);
    await context.setOffline(true);
    await page.goto(teacher.address());
    const needsNetwork = page.getByRole("heading", { name: "Your class needs the network" });
    await expect(needsNetwork).toBeVisible();
    await page.getByRole("button", { name: "Try again" }).click();
    await expect(needsNetwork).toBeVisible();
    await context.setOffline(false);
    await expect(page.getByRole("heading", { name: "Sensors" })).toBeVisible();
    await expect(needsNetwork).toBeHidden();
  });

  await test.step("the relay's own addresses are left to the relay", async () => {
    for (const path of ["/healthz", "/openapi.json", "/api/v1/robots/none", "/r/none"]) {
      const response = await page.goto(path);
      expect(response?.fromServiceWorker(), path).toBe(false);
    }
    expect((await page.goto("/"))?.fromServiceWorker()).toBe(true);
  });

  await test.step("can be installed: a manifest with its icons", async () => {
    const address = await page.locator("link[rel=manifest]").getAttribute("href");
    const manifest = (await (await page.request.get(relay.url + address)).json()) as {
      start_url: string;
      icons: { src: string; type: string; sizes: string; purpose?: string }[];
    };
    expect(manifest.start_url).toBe("/");
    expect(manifest.icons.map(({ sizes }) => sizes)).toEqual(
      expect.arrayContaining(["192x192", "512x512"]),
    );
    expect(manifest.icons.some(({ purpose }) => purpose === "maskable")).toBe(true);
    for (const { src, type } of manifest.icons) {
      const icon = await page.request.get(relay.url + src);
      expect(icon.status(), src).toBe(200);
      expect(icon.headers()["content-type"], src).toContain(type);
    }
  });

  await relay.kill();
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
  const remote = page.getByRole("region", { name: "Remote" });
  await expect(remote).toContainText(OFFLINE);
  await relay.restart();
  await context.setOffline(false);
  await expect(remote).not.toContainText(OFFLINE);
  await expect(corridor.connectionStatus).toHaveText("Waiting for a script");
  await context.close();
  await relay.stop();
});

test("offers an update in each tab, and applies it on request to one tab, with its unsaved edit", async ({
  browser,
  relay,
}) => {
  const proxy = await RelayProxy.start(relay);
  const options = { ...smallWindow, baseURL: proxy.url, serviceWorkers: "allow" } as const;
  const context = await browser.newContext(options);
  const corridor = new CorridorPage(await context.newPage());
  const { page } = corridor;
  await corridor.open();
  await waitForServiceWorker(page);
  const other = new CorridorPage(await context.newPage());
  await other.open();
  await other.run.click();
  // Slow, so that the run lasts until the offer appears on any machine.
  await corridor.speed.selectOption("0.25×");
  await corridor.run.click();
  proxy.serveNewerBuild();
  await page.evaluate(async () => (await navigator.serviceWorker.ready).update());
  const text = "A new version of Corridor is ready.";
  const offer = corridor.message(text);
  await expect(offer).toBeVisible();
  // Nothing changes yet: the run continues, and a lazy-loaded part of the old build still opens.
  const before = await corridor.clock.textContent();
  await expect(corridor.clock).not.toHaveText(before ?? "");
  await corridor.mazeMenu.click();
  await expect(corridor.dialog("Maze menu")).toContainText("New empty maze");
  await page.keyboard.press("Escape");
  await expect(page.locator("html")).not.toHaveAttribute("data-build");
  // The other tab takes part in updates once its update client has started.
  await expect(other.message(text)).toBeVisible();

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

  // The other tab keeps running the old version.
  await expect(other.message(text)).toBeVisible();
  await expect(other.page.locator("html")).not.toHaveAttribute("data-build");
  // Once the robot has reached the goal, its card has such a button, too.
  await other.page.getByRole("banner").getByRole("button", { name: "Share" }).click();
  await expect(other.dialog("Share this maze")).toBeVisible();
  await context.close();
  await proxy.close();
});
