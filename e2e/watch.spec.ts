/**
 * A friend's phone, a teacher's projector: who opens a watch link sees the robot of another page,
 * and drives nothing.
 */
import type { Locator, Page } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import type { CorridorPage } from "./pages/corridor-page.ts";
import { expectNoAxeViolations } from "./support/axe.ts";
import { RelayProxy } from "./support/relay-proxy.ts";
import { openMoreSection } from "./support/remote-panel.ts";

interface Addresses {
  drive: string;
  watch: string;
}

/** Lets Remote drive, and takes both addresses as the user does: from the clipboard. */
async function takeAddresses({ page }: CorridorPage): Promise<Addresses> {
  await page.getByRole("radio", { name: "Remote" }).click();
  const copied = () => page.evaluate(() => navigator.clipboard.readText());
  await page.getByRole("button", { name: "Copy address with key" }).click();
  await expect.poll(copied).toContain("#drv_");
  const drive = await copied();
  await openMoreSection(page);
  await page.getByRole("button", { name: "Make a watch address" }).click();
  await page.getByRole("button", { name: "Copy address to watch" }).click();
  await expect.poll(copied).toContain("#wch_");
  return { drive, watch: await copied() };
}

/** A call of the robot's script or owner. */
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
  const kept = await page.evaluate(() => sessionStorage.getItem("corridor.remote"));
  return (JSON.parse(kept ?? "{}") as { ownerKey: string }).ownerKey;
}

/** What an onlooker finds on the screen. */
function seen(page: Page): { banner: Locator; maze: Locator; news: Locator; place: Locator } {
  return {
    banner: page.getByText("You are watching"),
    maze: page.getByRole("heading", { level: 2 }),
    news: page.getByRole("complementary").getByRole("status"),
    place: page.getByText(/^Robot at /),
  };
}

/** The robot stands at the same place on both screens, to the centimetre. */
async function expectSamePlace(owner: CorridorPage, onlooker: Page): Promise<void> {
  // It may roll on for a moment: both are read anew each time.
  await expect
    .poll(async () => {
      const here = await seen(onlooker).place.textContent();
      const there = await owner.robotPose.textContent();
      return here === there ? "the same" : `${here}, but ${there}`;
    })
    .toBe("the same");
}

test("shows the robot where it is, whoever drives it, and its maze as it changes", async ({
  corridor,
  openWindow,
}) => {
  const { drive, watch } = await takeAddresses(corridor);
  const { page } = await openWindow();
  await page.goto(watch);
  const { banner, maze, news } = seen(page);
  await expect(banner).toBeVisible();
  await expect(maze).toHaveText("Long way round");
  await expect(news).toContainText("The robot waits for a script.");
  await expectSamePlace(corridor, page);

  // A script.
  const moved = await call(drive, "/commands", { body: { action: "move", distance: 150 } });
  const { seq } = (await moved.json()) as { seq: number };
  await call(drive, `/commands/${seq}?wait=25`);
  await expect(news).toContainText("A script drives.");
  await expectSamePlace(corridor, page);

  // The hand: the picture moves with it.
  const stage = page.getByRole("main");
  const before = await stage.screenshot();
  await corridor.selectDriver("Me");
  await expect(news).toContainText("A person drives the robot.");
  await corridor.page.keyboard.down("s");
  await expect.poll(() => corridor.robotX()).toBeLessThan(190);
  await corridor.page.keyboard.up("s");
  await expectSamePlace(corridor, page);
  expect((await stage.screenshot()).equals(before)).toBe(false);

  // Another maze.
  await corridor.choosePreset("Two rooms");
  await expect(maze).toHaveText("Two rooms");
  await expectSamePlace(corridor, page);

  // There is nothing to drive with, and the owner's robot is not disturbed by keys here.
  await page.keyboard.press("w");
  await expectSamePlace(corridor, page);
  await expect(page.getByRole("button", { name: "Run" })).toHaveCount(0);
});

test("takes the key out of the address and goes on after a reload", async ({
  corridor,
  openWindow,
}) => {
  const { watch } = await takeAddresses(corridor);
  const { page } = await openWindow();
  const asked: string[] = [];
  page.on("request", (request) => asked.push(request.url()));
  await page.goto(watch);
  await expect(seen(page).place).toBeVisible();
  expect(page.url()).toBe(watch.replace(/#.*/, ""));
  await page.reload();
  await expect(seen(page).place).toBeVisible();
  expect(asked.filter((url) => url.replace(watch, "").includes("wch_"))).toEqual([]);
  // No robot of its own is started: the one worker is the onlooker's.
  expect(page.workers()).toHaveLength(1);
  await page.getByRole("link", { name: "Open Corridor" }).click();
  await expect(page).toHaveURL(/\/$/);
});

test("is looked at in the colours that the onlooker likes", async ({ corridor, openWindow }) => {
  const { watch } = await takeAddresses(corridor);
  const { page } = await openWindow({ colorScheme: "light" });
  await page.goto(watch);
  await expect(seen(page).place).toBeVisible();
  await page.getByRole("button", { name: "Theme" }).click();
  await page.getByRole("radio", { name: "Dark" }).check({ force: true });
  await expect(page.locator("html")).toHaveAttribute("data-theme", "dark");
  await page.reload();
  await expect(seen(page).place).toBeVisible();
  await expect(page.locator("html")).toHaveAttribute("data-theme", "dark");
});

test("is told when the robot's page leaves and when it comes back", async ({
  corridor,
  openWindow,
}) => {
  const { watch } = await takeAddresses(corridor);
  const { page } = await openWindow();
  await page.goto(watch);
  const { news, place } = seen(page);
  await expect(place).toBeVisible();
  await corridor.page.goto("about:blank");
  await expect(news).toContainText("The robot’s page is closed or offline.");
  await expectNoAxeViolations(page, "an onlooker whose robot is gone");
  await corridor.page.goBack();
  await expect(news).toContainText("The robot waits for a script.", { timeout: 15_000 });
});

test("is told at once when the link was taken back, and can open the new one in the same tab", async ({
  corridor,
  openWindow,
}) => {
  const { watch } = await takeAddresses(corridor);
  const { page } = await openWindow();
  await page.goto(watch);
  await expect(seen(page).place).toBeVisible();
  const key = await ownerKey(corridor);
  const made = await call(watch, "/keys", { key, body: { kind: "watch", replace: true } });
  const { address } = (await made.json()) as { address: string };
  const end = page.getByRole("alert");
  await expect(end).toContainText("This watch link has ended");
  await expect(seen(page).banner).toHaveCount(0);
  await expectNoAxeViolations(page, "a watch link that has ended");
  await page.goto(address);
  await expect(seen(page).place).toBeVisible();
});

test("says what a script's address is for, hides its key and starts no robot", async ({
  corridor,
  openWindow,
}) => {
  const { drive } = await takeAddresses(corridor);
  const { page } = await openWindow();
  await page.goto(drive);
  const says = page.getByRole("alert");
  await expect(says).toContainText("This address is for a script");
  expect(page.url()).not.toContain("drv_");
  expect(page.workers()).toHaveLength(0);
  await expectNoAxeViolations(page, "a script's address in a browser");
  await page.getByRole("link", { name: "How to write a script" }).click();
  await expect(page).toHaveURL(/\/docs/);
});

for (const { name, end, says } of [
  {
    name: "of a robot that is gone",
    end: `${"A".repeat(22)}#wch_${"A".repeat(22)}`,
    says: "This robot was deleted",
  },
  { name: "without a key", end: "A".repeat(22), says: "A part of this link is missing" },
  {
    name: "that is cut off",
    end: `${"A".repeat(22)}#wch_AAAA`,
    says: "A part of this link is missing",
  },
]) {
  test(`says in words what is wrong with a link ${name}, and shows a way on`, async ({ page }) => {
    await page.goto(`/r/${end}`);
    await expect(page.getByRole("alert")).toContainText(says);
    await page.getByRole("link", { name: "Open Corridor" }).click();
    await expect(page).toHaveURL(/\/$/);
  });
}

test("shows the robot where no WebSocket passes", async ({ corridor, browser, relay }) => {
  const { drive, watch } = await takeAddresses(corridor);
  const door = await RelayProxy.start(relay);
  // Not a watched window: the browser complains of the WebSocket that does not open.
  const context = await browser.newContext();
  const page = await context.newPage();
  const lines: string[] = [];
  page.on("request", (request) => lines.push(new URL(request.url()).pathname));
  await page.goto(watch.replace(relay, door.url));
  await expect(seen(page).place).toBeVisible({ timeout: 20_000 });
  await call(drive, "/commands", { body: { action: "move", distance: 50 } });
  await expect.poll(() => corridor.robotX()).toBeGreaterThan(90);
  await expectSamePlace(corridor, page);
  expect(lines.some((path) => path.endsWith("/line/messages"))).toBe(true);
  await context.close();
  await door.close();
});

test("has room and no barriers on a small phone, in every language", async ({
  corridor,
  openWindow,
}) => {
  const { watch, drive } = await takeAddresses(corridor);
  const { page } = await openWindow({ viewport: { width: 320, height: 640 } });
  await page.goto(watch);
  await expect(seen(page).place).toBeVisible();
  await expectNoAxeViolations(page, "an onlooker on a small phone");
  for (const language of ["en", "ar", "de", "es", "fr", "ja", "pt", "zh-Hans"]) {
    for (const address of [watch, drive]) {
      await page.goto("about:blank");
      await page.goto(address.replace("#", `?lang=${language}#`));
      await expect(page.locator("html")).toHaveAttribute("lang", language);
      await expect(page.getByRole("heading", { level: 2 })).toBeVisible();
      const width = await page.evaluate(() => document.documentElement.scrollWidth);
      expect(width, language).toBe(320);
    }
  }
});
