/**
 * A hidden page keeps driving. Playwright keeps pages visible, so the test drives Chromium
 * directly.
 */
import { expect, test } from "./fixtures.ts";
import { RawChromium } from "./support/devtools.ts";

/**
 * Browsers throttle a hidden tab's timers immediately. Ten seconds show that the robot's are not.
 */
const HIDDEN_MS = 10_000;

test("a remotely driven robot keeps moving while its page is hidden", async ({ relay }) => {
  const browser = await RawChromium.start();
  try {
    const page = await browser.open(`${relay}/`);
    await page.waitFor(`document.querySelector('input[value="remote"]') !== null`);
    await page.evaluate(`document.querySelector('input[value="remote"]').click()`);
    const text = await page.waitFor(`sessionStorage.getItem("corridor.remote")`);
    const { id, driverKey } = JSON.parse(String(text));
    const robot = `${relay}/api/v1/robots/${id}`;
    const headers = { authorization: `Bearer ${driverKey}`, "content-type": "application/json" };
    const call = async (path: string, body?: unknown) =>
      (
        await fetch(robot + path, {
          method: body === undefined ? "GET" : "POST",
          headers,
          ...(body === undefined ? {} : { body: JSON.stringify(body) }),
        })
      ).json();

    await browser.open("about:blank");
    await page.waitFor(`document.visibilityState === "hidden"`);
    const hiddenAt = performance.now();
    const before = await call("/sensors?wait=10");
    // Back and forth, so that the robot has space for any duration.
    let seq = 0;
    while (performance.now() - hiddenAt < HIDDEN_MS) {
      for (const distance of [100, -100]) {
        const posted = await call("/commands", { action: "move", distance });
        seq = posted.seq;
        const record = await call(`/commands/${seq}?wait=20`);
        expect(record).toMatchObject({ state: "completed" });
        expect(record.distance).toBeCloseTo(100, 6);
      }
    }
    expect(await page.evaluate("document.visibilityState")).toBe("hidden");
    const after = await call("/sensors");
    const seconds = (performance.now() - hiddenAt) / 1000;
    // Real-time pace: throttled page timers would run one tick or one burst a second.
    expect((after.tick - before.tick) / 60 / seconds).toBeGreaterThan(0.8);
    expect(seq).toBeGreaterThan(4);
  } finally {
    await browser.close();
  }
});

test("a page that was hidden while the robot drove displays its current place once visible", async ({
  relay,
}) => {
  const browser = await RawChromium.start();
  try {
    const page = await browser.open(`${relay}/`);
    const pose = `[...document.querySelectorAll("span")].find((each) => /^Robot at/.test(each.textContent))?.textContent`;
    await page.waitFor(pose);
    await page.waitFor("document.querySelector('canvas') !== null");
    await page.evaluate(
      `[...document.querySelectorAll("button")].find((each) => each.textContent.trim() === "Run").click()`,
    );
    await browser.open("about:blank");
    await page.waitFor(`document.visibilityState === "hidden"`);
    const from = await page.evaluate(pose);
    await page.waitFor(`${pose} !== ${JSON.stringify(from)}`);
    await page.evaluate(
      `[...document.querySelectorAll("button")].find((each) => each.textContent.trim() === "Pause").click()`,
    );
    await page.bringToFront();
    await page.waitFor(`document.visibilityState === "visible"`);
    await page.evaluate("new Promise((done) => setTimeout(done, 500))");
    const box = await page.evaluate(
      "(({ x, y, width, height }) => ({ x, y, width, height }))(document.querySelector('canvas').getBoundingClientRect())",
    );
    const before = await page.screenshot(box);
    // A theme change repaints every layer of the same tick.
    await page.evaluate(`document.documentElement.dataset.theme = "dark"`);
    await page.evaluate("new Promise((done) => setTimeout(done, 300))");
    await page.evaluate(`document.documentElement.dataset.theme = "light"`);
    await page.evaluate("new Promise((done) => setTimeout(done, 500))");
    expect((await page.screenshot(box)) === before).toBe(true);
  } finally {
    await browser.close();
  }
});
