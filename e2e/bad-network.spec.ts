/** Scripts drive the robot in a page over a network that delays, slices and cuts connections. */
import { encodeLink } from "@corridor/link";
import { countOpenCells, generateTree } from "@corridor/maze";
import { commandRecordSchema } from "@corridor/protocol";
import type { Browser } from "playwright/test";
import { inPath } from "../scripts/programs.ts";
import { SeededRandom } from "../apps/relay/src/testing/faults/seeded-random.ts";
import { FaultProxy } from "./faults/net/fault-proxy.ts";
import { expect, test } from "./fixtures.ts";
import { exampleCommand, runScript, type ExampleLanguage } from "./support/script.ts";

const maze = generateTree({ columns: 9, rows: 9, seed: 3, name: "Tree" });
const cells = `${countOpenCells(maze)}`;
const DELAY_MS = { least: 0, most: 30 };
/** shorter than many exchanges take under this delay, longer than a reconnection takes */
const CUT_EVERY_MS = 450;

/**
 * Runs a wall follower that drives a page through a proxy. @returns its output and the robot's
 * commands
 */
async function follow(
  browser: Browser,
  language: ExampleLanguage,
  network: FaultProxy,
  isBad: boolean,
) {
  // Not an openWindow fixture: the browser logs an error for each cut connection.
  const context = await browser.newContext({ permissions: ["clipboard-read", "clipboard-write"] });
  const page = await context.newPage();
  const link = encodeLink({ maze });
  if (!link.ok) throw new Error(link.code);
  await page.goto(`${network.origin}/#${link.text}`);
  await page.getByRole("combobox", { name: "Speed" }).selectOption("16");
  await page.getByRole("radio", { name: "Remote" }).click();
  await page.getByRole("button", { name: "Copy address with key" }).click();
  const address = await page.evaluate(() => navigator.clipboard.readText());
  let cut = 0;
  const cuts = setInterval(() => (cut += isBad ? network.cut() : 0), CUT_EVERY_MS);
  if (isBad) Object.assign(network, { delay: DELAY_MS, isSlicing: true });
  const { code, output } = await runScript([
    ...exampleCommand(language),
    address,
    "--until-cells",
    cells,
  ]);
  clearInterval(cuts);
  Object.assign(network, { delay: { least: 0, most: 0 }, isSlicing: false });
  const { origin, pathname, hash } = new URL(address);
  const robot = `${origin}/api/v1/robots/${pathname.slice("/r/".length)}`;
  const headers = { authorization: `Bearer ${hash.slice(1)}` };
  const log = await (await fetch(`${robot}/commands`, { headers })).json();
  const { bumps } = await (await fetch(`${robot}/sensors`, { headers })).json();
  await context.close();
  const commands = commandRecordSchema
    .array()
    .parse(log.commands)
    .map(({ action, state, pose }) => ({ action, state, pose }));
  return { code, output, commands, bumps, cut };
}

for (const language of ["Python", "Java"] as const) {
  test(`the ${language} follower drives every step correctly while the network cuts, delays and slices`, async ({
    browser,
    relay,
  }) => {
    const isMissing = language === "Java" && inPath("java").length === 0;
    if (isMissing)
      process.stderr.write("bad-network.spec.ts: skipped Java, java is not installed\n");
    test.skip(isMissing, "java is not installed");
    test.setTimeout(240_000);
    const target = Number(new URL(relay).port);
    const network = await FaultProxy.start({ target: () => target, random: new SeededRandom(1) });
    const baseline = await follow(browser, language, network, false);
    expect(baseline).toMatchObject({ code: 0, bumps: 0, cut: 0 });
    expect(baseline.output).toContain(`${cells} cells visited`);
    const bad = await follow(browser, language, network, true);
    expect(bad.cut).toBeGreaterThan(20);
    expect(bad).toEqual({ ...baseline, cut: bad.cut });
    await network.close();
  });
}
