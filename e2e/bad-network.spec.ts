/** Scripts drive the robot in a page while the network between everybody is as bad as it gets. */
import { encodeLink } from "@corridor/link";
import { countOpenCells, generateTree } from "@corridor/maze";
import { commandRecordSchema } from "@corridor/protocol";
import type { Browser } from "playwright/test";
import { inPath } from "../scripts/programs.ts";
import { Dice } from "../apps/relay/src/testing/faults/dice.ts";
import { FaultProxy } from "./faults/net/fault-proxy.ts";
import { expect, test } from "./fixtures.ts";
import { exampleCommand, runScript, type ExampleLanguage } from "./support/script.ts";

const maze = generateTree({ columns: 9, rows: 9, seed: 3, name: "Tree" });
const cells = `${countOpenCells(maze)}`;
const DELAY_MS = { least: 0, most: 30 };
/** Shorter than many an exchange takes in that weather, longer than coming back does. */
const CUT_EVERY_MS = 450;

/** Lets a follower drive a page through a proxy. @returns what it said, and what the robot did */
async function follow(
  browser: Browser,
  language: ExampleLanguage,
  network: FaultProxy,
  isBad: boolean,
) {
  // Not a watched window: the browser complains of the connections that are cut.
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
  const way = commandRecordSchema
    .array()
    .parse(log.commands)
    .map(({ action, state, pose }) => ({ action, state, pose }));
  return { code, output, way, bumps, cut };
}

for (const language of ["Python", "Java"] as const) {
  test(`the ${language} follower takes no wrong step where the network cuts, delays and slices`, async ({
    browser,
    relay,
  }) => {
    const isMissing = language === "Java" && inPath("java").length === 0;
    if (isMissing)
      process.stderr.write("bad-network.spec.ts: skipped Java, there is no java here\n");
    test.skip(isMissing, "there is no java here");
    test.setTimeout(240_000);
    const target = Number(new URL(relay).port);
    const network = await FaultProxy.start({ target: () => target, dice: new Dice(1) });
    const calm = await follow(browser, language, network, false);
    expect(calm).toMatchObject({ code: 0, bumps: 0, cut: 0 });
    expect(calm.output).toContain(`${cells} cells visited`);
    const bad = await follow(browser, language, network, true);
    expect(bad.cut).toBeGreaterThan(20);
    expect(bad).toEqual({ ...calm, cut: bad.cut });
    await network.close();
  });
}
