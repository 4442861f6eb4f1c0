/**
 * Corridor in a frame of another site: what a visitor sees and can do there, what the site receives,
 * and that no other page can be framed.
 */
import { lessonOf, type ChallengeDocument } from "@corridor/challenge";
import { decodeLink, encodeLink, type LinkContent } from "@corridor/link";
import { mazePresets, type MazeDocument } from "@corridor/maze";
import { programPresets } from "@corridor/program";
import { shortLinkSchema } from "@corridor/protocol";
import { AxeBuilder } from "@axe-core/playwright";
import type { Page } from "playwright/test";
import { expect, test as base } from "./fixtures.ts";
import { CorridorPage } from "./pages/corridor-page.ts";
import { smallWindow } from "./support/window-sizes.ts";
import { heightOf, HostSite, messagesOf, sendTo } from "./support/host-site.ts";

const test = base.extend<{ site: HostSite }>({
  // oxlint-disable-next-line no-empty-pattern -- Playwright reads the fixture names from this pattern
  site: async ({}, use) => {
    const site = await HostSite.start();
    await use(site);
    site.close();
  },
});

test.use(smallWindow);

/** A page of another site with a frame, or of a visitor. */
interface Visit {
  page: Page;
  relay: string;
  site: HostSite;
}

const corridor: MazeDocument = {
  format: "corridor/maze",
  version: 1,
  name: "Straight on",
  blocks: ["#####", "#...#", "#####"],
  start: { column: 1, row: 1, heading: "east" },
  goals: [{ column: 3, row: 1 }],
};

const task: ChallengeDocument = {
  format: "corridor/challenge",
  version: 1,
  name: "Down the corridor",
  words: { task: "Drive to the goal without a bump.", short: "Reach the goal", hints: [] },
  mazes: [corridor],
  program: null,
  goal: { kind: "reach" },
  allowed: {
    drivers: ["program"],
    lines: 3,
    conditions: null,
    actions: null,
    edits: ["condition", "number", "action", "otherwise", "order", "lines"],
    maze: false,
  },
  checks: { bumps: 0, seconds: 60 },
  par: null,
};

const rightWall = programPresets.find(({ id }) => id === "right-wall")?.program;

function linkOf(content: LinkContent): string {
  const link = encodeLink(content);
  if (!link.ok) throw new Error(link.code);
  return link.text;
}

/** Everything that this origin has stored in the browser. */
async function storedAt(page: Page, relay: string) {
  await page.goto(`${relay}/robots.txt`);
  return page.evaluate(async () => ({
    local: Object.fromEntries(Object.entries(localStorage)),
    session: Object.fromEntries(Object.entries(sessionStorage)),
    databases: await indexedDB.databases(),
    caches: await caches.keys(),
    cookies: document.cookie,
  }));
}

async function reportsRunsAndStoresNothing({ page, relay, site }: Visit): Promise<void> {
  const before = await storedAt(page, relay);
  const frame = await site.open(page, `${relay}/embed#${linkOf({ lesson: lessonOf(task) })}`);
  await expect(frame.getByText("Drive to the goal without a bump.")).toBeVisible();
  await expect(frame.getByRole("grid")).toBeVisible();
  for (const name of ["Run", "Step", "Reset"]) {
    await expect(frame.getByRole("button", { name, exact: true })).toBeVisible();
  }
  // Nothing of the visitor, no class and no scripts.
  await expect(frame.getByRole("banner")).toHaveCount(0);
  for (const name of [/Remote/, /Share/, /Presets/, /my maze/i, /class/i, /For teachers/]) {
    await expect(frame.getByRole("button", { name })).toHaveCount(0);
    await expect(frame.getByRole("radio", { name })).toHaveCount(0);
  }
  await expect(frame.getByRole("link", { name: "Open in Corridor" })).toHaveAttribute(
    "target",
    "_blank",
  );
  await frame.getByRole("combobox", { name: "action", exact: true }).selectOption("forward");
  await frame.getByRole("button", { name: "Run" }).click();
  await expect.poll(async () => (await messagesOf(page)).at(-1)?.type).toBe("met");
  const messages = await messagesOf(page);
  expect(messages.every((each) => each.corridor === 1)).toBe(true);
  expect(messages.map(({ type }) => type)).toEqual(["ready", "opened", "run", "met"]);
  expect(messages[1]).toMatchObject({ ok: true, name: "Down the corridor", tasks: 1 });
  const met = messages.at(-1);
  expect(met).toMatchObject({ task: 1, lines: 0, bumps: 0, attempts: 1 });
  expect(met?.["seconds"]).toBeGreaterThan(0.5);
  const code = decodeLink(String(met?.["code"]));
  expect(code).toMatchObject({ ok: true, value: { completion: { task: 0 } } });

  await frame.getByRole("button", { name: "Reset", exact: true }).click();
  await frame.getByRole("combobox", { name: "action", exact: true }).selectOption("reverse");
  await frame.getByRole("button", { name: "Run" }).click();
  await expect
    .poll(async () => (await messagesOf(page)).map(({ type }) => type))
    .toEqual(expect.arrayContaining(["bump", "failed"]));
  const failed = (await messagesOf(page)).find(({ type }) => type === "failed");
  expect(failed).toMatchObject({ task: 1, attempts: 2, code: "bump" });

  // A fresh browser has nothing, before and after.
  const after = await storedAt(page, relay);
  expect(after).toEqual(before);
  expect(after).toMatchObject({ local: {}, databases: [], caches: [], cookies: "" });
}

async function followsRequests({ page, relay, site }: Visit): Promise<void> {
  const program = rightWall;
  if (program === undefined) throw new Error("no program");
  const frame = await site.open(page, `${relay}/embed`);
  await expect(frame.getByText("There is no maze in this address yet.")).toBeVisible();
  const link = linkOf({ maze: corridor, program: { ...program, default: "forward" } });
  await sendTo(page, { corridor: 1, type: "open", link });
  await expect(frame.getByRole("heading", { name: "Straight on" })).toBeVisible();
  await sendTo(page, { corridor: 1, type: "run" });
  await expect.poll(async () => (await messagesOf(page)).map(({ type }) => type)).toContain("met");
  await sendTo(page, { corridor: 1, type: "stop" });
  await expect(frame.getByRole("button", { name: "Run" })).toBeVisible();
  await sendTo(page, { corridor: 1, type: "reset" });
  await expect(frame.getByText("Robot at 150, 150")).toBeAttached();

  const before = (await messagesOf(page)).length;
  await page.evaluate(() => {
    const target = document.querySelector("iframe")?.contentWindow;
    const odd: unknown[] = [
      null,
      0,
      "run",
      "{}",
      [],
      {},
      { corridor: 1 },
      { corridor: 2 },
      new Date(),
    ];
    for (const type of [null, {}, [], "drive", "constructor", "open", 7]) {
      odd.push({ corridor: 1, type }, { corridor: 1, type: "open", link: type, id: type });
    }
    odd.push({ corridor: 1, type: "open", link: "x".repeat(1_000_000) });
    odd.push({ type: "run" }, new Uint8Array(1_000), new Map([["corridor", 1]]));
    for (const data of odd) target?.postMessage(data, "*");
  });
  // A link that cannot be opened is a request, and is answered.
  await sendTo(page, { corridor: 1, type: "open", link: "1%" });
  await expect(frame.getByText("This link does not work.")).toBeVisible();
  const after = (await messagesOf(page)).slice(before);
  expect(after.at(-1)).toEqual({ corridor: 1, type: "opened", ok: false, problem: "broken" });
  expect(after.filter(({ type }) => type === "opened" || type === "run").length).toBeLessThan(5);
  await sendTo(page, { corridor: 1, type: "open", link });
  await expect(frame.getByRole("heading", { name: "Straight on" })).toBeVisible();

  // The frame becomes higher and lower.
  const wide = mazePresets.find(({ id }) => id === "spiral")?.maze;
  if (wide === undefined) throw new Error("no maze");
  await sendTo(page, { corridor: 1, type: "open", link: linkOf({ maze: wide }) });
  await expect(frame.getByRole("heading", { name: "Spiral" })).toBeVisible();
  const heightOfFrame = async () => page.locator("iframe").evaluate((each) => each.clientHeight);
  await expect.poll(async () => heightOf(page)).toBeGreaterThan(350);
  await expect.poll(async () => (await heightOfFrame()) - (await heightOf(page))).toBe(0);
  const low = await heightOfFrame();
  for (let lines = 0; lines < 4; lines++) {
    await frame.getByRole("button", { name: "Add line" }).click();
  }
  await expect.poll(heightOfFrame).toBeGreaterThan(low);
  const high = await heightOfFrame();
  await sendTo(page, { corridor: 1, type: "open", link: linkOf({ maze: corridor }) });
  await expect(frame.getByRole("heading", { name: "Straight on" })).toBeVisible();
  await expect.poll(heightOfFrame).toBeLessThan(high);
  await sendTo(page, { corridor: 1, type: "open", link: "1%" });
  await expect.poll(heightOfFrame).toBeLessThan(200);
}

async function readsNothingOfVisitor({ page, relay, site }: Visit): Promise<void> {
  const visitor = new CorridorPage(page);
  await visitor.open(relay);
  await visitor.maze.click({ column: 2, row: 6 });
  await expect(visitor.saveState).toHaveText("Saved on this device");
  await page.evaluate(() => {
    localStorage.setItem("corridor.language", "de");
    localStorage.setItem("corridor.theme", "dark");
  });
  const before = await storedAt(page, relay);
  expect(Object.keys(before.local).length).toBeGreaterThan(2);

  const frame = await site.open(page, `${relay}/embed#${linkOf({ lesson: lessonOf(task) })}`);
  // Not the language and theme that the visitor has chosen in Corridor.
  await expect(frame.locator("html")).toHaveAttribute("lang", "en");
  await expect(frame.locator("html")).toHaveAttribute("data-theme", "light");
  await frame.getByRole("combobox", { name: "action", exact: true }).selectOption("forward");
  await frame.getByRole("button", { name: "Run" }).click();
  await expect.poll(async () => (await messagesOf(page)).map(({ type }) => type)).toContain("met");
  expect(await storedAt(page, relay)).toEqual(before);
}

async function worksWithoutStorage({ page, relay, site }: Visit): Promise<void> {
  await page.addInitScript(() => {
    if (window === window.parent) return;
    for (const name of ["localStorage", "sessionStorage", "indexedDB", "caches"]) {
      Object.defineProperty(window, name, {
        configurable: true,
        get: () => {
          throw new DOMException("blocked", "SecurityError");
        },
      });
    }
  });
  const frame = await site.open(page, `${relay}/embed#${linkOf({ lesson: lessonOf(task) })}`);
  await frame.getByRole("combobox", { name: "action", exact: true }).selectOption("forward");
  await frame.getByRole("button", { name: "Run" }).click();
  await expect.poll(async () => (await messagesOf(page)).map(({ type }) => type)).toContain("met");
}

async function showsShortLink({ page, relay, site }: Visit): Promise<void> {
  const stored = await fetch(`${relay}/api/v1/mazes`, {
    method: "POST",
    headers: { "content-type": "application/json" },
    body: JSON.stringify(task),
  });
  const { address, id } = shortLinkSchema.parse(await stored.json());
  const { headers } = await fetch(address);
  const [, described = ""] = /<([^>]+)>; rel="alternate"/.exec(headers.get("link") ?? "") ?? [];
  const { html } = (await (await fetch(described)).json()) as { html: string };
  const frame = await site.openHtml(page, html);
  await expect(page.getByTitle("Down the corridor")).toBeVisible();
  await expect(frame.getByText("Drive to the goal without a bump.")).toBeVisible();
  await expect(frame.getByRole("link", { name: "Open in Corridor" })).toHaveAttribute(
    "href",
    `/m/${id}`,
  );
}

test("cannot be framed anywhere else", async ({ browser, relay, site }) => {
  // Not an openWindow fixture: the browser logs an error for each refused frame, as expected.
  const context = await browser.newContext({ serviceWorkers: "block" });
  const page = await context.newPage();
  const others = [
    "/",
    "/m/BCDF",
    "/r/AAAAAAAAAAAAAAAAAAAAAA",
    "/teach",
    "/join",
    "/docs",
    "/check",
  ];
  for (const path of [...others, "/embed/other"]) {
    const refused = page.waitForEvent("console", {
      predicate: (message) => /frame/i.test(message.text()),
    });
    const frame = await site.open(page, relay + path);
    await refused;
    await expect(frame.getByText(/Corridor/), path).toHaveCount(0);
  }
  const frame = await site.open(page, `${relay}/embed#${linkOf({ maze: corridor })}`);
  await expect(frame.getByRole("heading", { name: "Straight on" })).toBeVisible();
  await context.close();
});

async function copiesCodeOfFrame({ page, relay, site }: Visit): Promise<void> {
  const start = new CorridorPage(page);
  await start.open(relay);
  await start.choosePreset("Spiral");
  await start.share.click();
  const dialog = start.dialog("Share this maze");
  const part = dialog.getByRole("region", { name: "Embed in a page" });
  await part.getByRole("radio", { name: "Large" }).check();
  await part.getByRole("button", { name: "Copy" }).click();
  await expect(part.getByText("Code copied")).toBeAttached();
  const html = await page.evaluate(() => navigator.clipboard.readText());
  expect(html).toContain('width="1080"');
  const frame = await site.openHtml(page, html);
  await expect(frame.getByRole("heading", { name: "Spiral" })).toBeVisible();
}

async function hasNoViolations({ page, relay, site }: Visit): Promise<void> {
  const frame = await site.open(page, `${relay}/embed#${linkOf({ lesson: lessonOf(task) })}`, 320);
  await expect(frame.getByRole("button", { name: "Run" })).toBeVisible();
  for (const width of [320, 390, 720, 1080]) {
    await page
      .locator("iframe")
      .evaluate((each, value) => each.setAttribute("width", value), `${width}`);
    await expect.poll(() => frame.locator("html").evaluate(() => innerWidth)).toBe(width);
    for (const colorScheme of ["light", "dark"] as const) {
      await page.emulateMedia({ colorScheme, reducedMotion: "reduce" });
      await expect(frame.locator("html")).toHaveAttribute("data-theme", colorScheme);
      // The colours are the same at every width.
      if (colorScheme === "dark" && width !== 320 && width !== 1080) continue;
      const axe = new AxeBuilder({ page }).include(["iframe"]);
      // The themes differ only in their colours.
      if (colorScheme === "dark") axe.withRules(["color-contrast"]);
      const { violations } = await axe.analyze();
      expect(
        violations.map(({ id, nodes }) => [id, nodes.map(({ target }) => target)]),
        `${width} px, ${colorScheme}`,
      ).toEqual([]);
    }
    const overflow = await frame
      .locator("html")
      .evaluate((html) => html.scrollWidth - html.clientWidth);
    expect(overflow, `${width} px`).toBe(0);
  }
}

// One browser for all frames: another one compiles everything again.
test("shows, reports and stores in a frame of another site what it should", async ({
  page,
  relay,
  site,
}) => {
  test.slow();
  const visit = { page, relay, site };
  await test.step("shows a task in a frame of another site, reports its runs to the site, and stores nothing", () =>
    reportsRunsAndStoresNothing(visit));
  await test.step("shows a short link with the code that oEmbed gives to the site", () =>
    showsShortLink(visit));
  await test.step("follows the requests of the site, ignores everything else, and has the height of its content", () =>
    followsRequests(visit));
  await test.step("has no accessibility violations and no sideways scrolling at any width", () =>
    hasNoViolations(visit));
  await page.emulateMedia({ colorScheme: "light", reducedMotion: null });
  await test.step("copies the code of a frame from the share dialog, in three sizes", () =>
    copiesCodeOfFrame(visit));
  await test.step("reads and stores nothing of the visitor, who has projects and settings", () =>
    readsNothingOfVisitor(visit));
  await test.step("works where the browser blocks storage in frames", async () =>
    worksWithoutStorage({ ...visit, page: await page.context().newPage() }));
});
