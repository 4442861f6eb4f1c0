/**
 * Watch links: a viewer sees the robot of another page and cannot drive it.
 */
import type { Browser, Locator, Page } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import type { CorridorPage } from "./pages/corridor-page.ts";
import { expectNoAxeViolations } from "./support/axe.ts";
import { chooseInLanguageMenu } from "./support/choose-language.ts";
import { smallWindow } from "./support/window-sizes.ts";
import { RelayProxy } from "./support/relay-proxy.ts";
import { openMoreSection } from "./support/remote-panel.ts";
import { languageTags, Texts } from "./support/texts.ts";
import { withMotion } from "./support/with-motion.ts";

test.use({ ...withMotion, ...smallWindow });

interface Addresses {
  drive: string;
  watch: string;
}

/** Selects Remote as the driver and copies both addresses through the clipboard. */
async function copyAddresses({ page }: CorridorPage): Promise<Addresses> {
  await page.getByRole("radio", { name: "Remote" }).click();
  const copied = () => page.evaluate(() => navigator.clipboard.readText());
  await page.getByRole("button", { name: "Copy address with key" }).click();
  await expect.poll(copied).toContain("#drv_");
  const drive = await copied();
  await openMoreSection(page);
  await page.getByRole("button", { name: "Make a watch link" }).click();
  await page.getByRole("button", { name: "Copy watch link" }).click();
  await expect.poll(copied).toContain("#wch_");
  return { drive, watch: await copied() };
}

/** Calls the robot's API with the key of a script or the owner. */
async function call(address: string, path: string, request: { key?: string; body?: unknown } = {}) {
  const { origin, pathname, hash } = new URL(address);
  const { key = hash.slice(1), body } = request;
  return fetch(`${origin}/api/v1/robots/${pathname.slice("/r/".length)}${path}`, {
    method: body === undefined ? "GET" : "POST",
    headers: { authorization: `Bearer ${key}`, "content-type": "application/json" },
    ...(body !== undefined && { body: JSON.stringify(body) }),
  });
}

async function ownerKey({ page }: CorridorPage): Promise<string> {
  const stored = await page.evaluate(() => sessionStorage.getItem("corridor.remote"));
  return (JSON.parse(stored ?? "{}") as { ownerKey: string }).ownerKey;
}

/** Locators of the viewer's page. */
function viewerPage(page: Page): {
  banner: Locator;
  maze: Locator;
  status: Locator;
  place: Locator;
} {
  return {
    banner: page.getByText("You are watching"),
    maze: page.getByRole("heading", { level: 2 }),
    status: page.getByRole("complementary").getByRole("status"),
    place: page.getByText(/^Robot at /),
  };
}

/** Expects the robot at the same place on both screens, to the centimetre. */
async function expectSamePlace(owner: CorridorPage, viewer: Page): Promise<void> {
  // The robot may still be moving, so each poll reads both.
  await expect
    .poll(async () => {
      const viewed = await viewerPage(viewer).place.textContent();
      const owned = await owner.robotPose.textContent();
      return viewed === owned ? "the same" : `${viewed}, but ${owned}`;
    })
    .toBe("the same");
}

/** A viewer whose network blocks WebSockets. */
async function openWithoutWebSockets(browser: Browser, relay: string, watch: string) {
  const proxy = await RelayProxy.start(relay);
  // Not an openWindow fixture: the browser logs an error for the WebSocket that does not open.
  const context = await browser.newContext(smallWindow);
  const page = await context.newPage();
  const paths: string[] = [];
  page.on("request", (request) => paths.push(new URL(request.url()).pathname));
  await page.goto(watch.replace(relay, proxy.url));
  await expect(viewerPage(page).place).toBeVisible({ timeout: 20_000 });
  const close = async () => {
    await context.close();
    await proxy.close();
  };
  return { page, paths, close };
}

async function driveByScript(drive: string): Promise<void> {
  const moved = await call(drive, "/commands", { body: { action: "move", distance: 150 } });
  const { seq } = (await moved.json()) as { seq: number };
  await call(drive, `/commands/${seq}?wait=25`);
}

/** The user drives, and the viewer's picture moves. */
async function followsTheUser(corridor: CorridorPage, page: Page): Promise<void> {
  const { maze, status } = viewerPage(page);
  const stage = page.getByRole("main");
  const before = await stage.screenshot();
  await corridor.selectDriver("Me");
  await expect(status).toContainText("A person drives the robot.");
  await corridor.page.keyboard.down("s");
  await expect.poll(() => corridor.robotX()).toBeLessThan(190);
  await corridor.page.keyboard.up("s");
  await expectSamePlace(corridor, page);
  expect((await stage.screenshot()).equals(before)).toBe(false);

  // The maze changes.
  await corridor.choosePreset("Two rooms");
  await expect(maze).toHaveText("Two rooms");
  await expectSamePlace(corridor, page);

  // The viewer has no controls, and keys do not affect the owner's robot.
  await page.keyboard.press("w");
  await expectSamePlace(corridor, page);
  await expect(page.getByRole("button", { name: "Run" })).toHaveCount(0);
  await corridor.selectDriver("Remote");
  await expect(status).toContainText("The robot waits for a script.");
}

async function staysDarkAfterReload(page: Page): Promise<void> {
  await page.getByRole("button", { name: "Theme" }).click();
  await page.getByRole("radio", { name: "Dark" }).check({ force: true });
  await expect(page.locator("html")).toHaveAttribute("data-theme", "dark");
  await page.reload();
  await expect(viewerPage(page).place).toBeVisible();
  await expect(page.locator("html")).toHaveAttribute("data-theme", "dark");
  // axe needs both themes.
  await page.getByRole("button", { name: "Theme" }).click();
  await page.getByRole("radio", { name: "System" }).check({ force: true });
  await page.keyboard.press("Escape");
}

/** Shows an address on a small phone in every language, and ends in English. */
async function fitsInEveryLanguage(page: Page, address: string): Promise<void> {
  const expectFits = async (tag: string) => {
    await expect(page.locator("html")).toHaveAttribute("lang", tag);
    await expect(page.getByRole("heading", { level: 2 })).toBeVisible();
    const width = await page.evaluate(() => document.documentElement.scrollWidth);
    expect(width, tag).toBe(320);
  };
  await page.goto("about:blank");
  await page.goto(address.replace("#", "?lang=ar#"));
  await expectFits("ar");
  let shown = "ar";
  const others = languageTags().filter((tag) => tag !== "ar" && tag !== "en");
  for (const tag of [...others, "en"]) {
    await chooseInLanguageMenu(page, Texts.load(shown), tag);
    await expectFits(tag);
    shown = tag;
  }
}

/** What is wrong with a link, and the way to the start page. */
async function explainsBrokenLinks(page: Page): Promise<void> {
  const id = "A".repeat(22);
  for (const [end, message] of [
    [id, "A part of this link is missing"],
    [`${id}#wch_AAAA`, "A part of this link is missing"],
    [`${id}#wch_${id}`, "This robot was deleted"],
  ] as const) {
    await page.goto("about:blank");
    await page.goto(`/r/${end}`);
    await expect(page.getByRole("alert"), end).toContainText(message);
  }
  await page.getByRole("link", { name: "Open Corridor" }).click();
  await expect(page).toHaveURL(/\/$/);
}

// One robot and one viewer, because each page costs more than a step.
test("shows the robot with any driver, and what happens to its page and to the link", async ({
  corridor,
  openWindow,
  browser,
  relay,
}) => {
  test.slow();
  const { drive, watch } = await copyAddresses(corridor);
  const { page } = await openWindow({ ...smallWindow, colorScheme: "light" });
  const requested: string[] = [];
  page.on("request", (request) => requested.push(request.url()));
  await page.goto(watch);
  const { banner, maze, status, place } = viewerPage(page);
  await expect(banner).toBeVisible();
  await expect(maze).toHaveText("Long way round");
  await expect(status).toContainText("The robot waits for a script.");
  await expectSamePlace(corridor, page);

  await test.step("a script drives, also for a viewer whose network blocks WebSockets", async () => {
    const blocked = await openWithoutWebSockets(browser, relay, watch);
    await driveByScript(drive);
    await expect(status).toContainText("A script drives.");
    await expectSamePlace(corridor, page);
    await expectSamePlace(corridor, blocked.page);
    expect(blocked.paths.some((path) => path.endsWith("/long-poll/messages"))).toBe(true);
    await blocked.close();
  });
  await test.step("the user drives", () => followsTheUser(corridor, page));
  await test.step("the key is not in the address, and the theme stays after a reload", async () => {
    expect(page.url()).toBe(watch.replace(/#.*/, ""));
    await staysDarkAfterReload(page);
    expect(requested.filter((url) => url.replace(watch, "").includes("wch_"))).toEqual([]);
    // The viewer's page starts no robot: its only worker paints.
    expect(page.workers()).toHaveLength(1);
  });
  await test.step("the page of the robot disconnects and reconnects", async () => {
    await corridor.page.goto("about:blank");
    await expect(status).toContainText("The robot’s page is closed or offline.");
    await expectNoAxeViolations(page, "a viewer whose robot is disconnected");
    await corridor.page.goBack();
    await expect(status).toContainText("The robot waits for a script.");
  });
  await test.step("the page fits a small phone in every language", async () => {
    await page.setViewportSize({ width: 320, height: 640 });
    await expectNoAxeViolations(page, "a viewer on a small phone");
    await fitsInEveryLanguage(page, drive);
    await fitsInEveryLanguage(page, watch);
    await page.setViewportSize(smallWindow.viewport);
    await expect(place).toBeVisible();
  });
  await test.step("a revoked link ends at once, and a new one opens in the same tab", async () => {
    const key = await ownerKey(corridor);
    const created = await call(watch, "/keys", { key, body: { kind: "watch", replace: true } });
    const { address } = (await created.json()) as { address: string };
    const end = page.getByRole("alert");
    await expect(end).toContainText("This watch link has ended");
    await expect(banner).toHaveCount(0);
    await expectNoAxeViolations(page, "a watch link that has ended");
    await page.goto(address);
    await expect(place).toBeVisible();
  });
  await test.step("the address of a script is explained, without its key and a robot", async () => {
    await page.goto("about:blank");
    await page.goto(drive);
    await expect(page.getByRole("alert")).toContainText("This address is for a script");
    expect(page.url()).not.toContain("drv_");
    expect(page.workers()).toHaveLength(0);
    await expectNoAxeViolations(page, "a script's address in a browser");
    await page.getByRole("link", { name: "How to write a script" }).click();
    await expect(page).toHaveURL(/\/docs/);
  });
  await test.step("what is wrong with a link is explained", () => explainsBrokenLinks(page));
});
