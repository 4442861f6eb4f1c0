/**
 * A script drives the robot in a page over a network that delays, slices and cuts connections.
 * tests/integration/client/bad-network.test.ts does the same in Java, without a page.
 */
import { encodeLink } from "@corridor/link";
import type { Browser } from "playwright/test";
import { SeededRandom } from "../apps/relay/src/testing/faults/seeded-random.ts";
import { followedMaze, followWall } from "../tests/support/client/wall-follower.ts";
import { FaultProxy } from "./faults/net/fault-proxy.ts";
import { expect, test } from "./fixtures.ts";
import { copyAddress, setSpeed } from "./support/remote-robot.ts";
import { smallWindow } from "./support/window-sizes.ts";

async function follow(browser: Browser, network: FaultProxy, isBad: boolean) {
  // Not an openWindow fixture: the browser logs an error for each cut connection.
  const context = await browser.newContext({
    permissions: ["clipboard-read", "clipboard-write"],
    ...smallWindow,
  });
  const page = await context.newPage();
  const link = encodeLink({ maze: followedMaze });
  if (!link.ok) throw new Error(link.code);
  await page.goto(`${network.origin}/#${link.text}`);
  await setSpeed(page, "16");
  const followed = await followWall("Python", await copyAddress(page), { network, isBad });
  await context.close();
  return followed;
}

test("the Python follower drives every step correctly while the network cuts, delays and slices", async ({
  browser,
  relay,
}) => {
  test.setTimeout(300_000);
  const target = Number(new URL(relay).port);
  const network = await FaultProxy.start({ target: () => target, random: new SeededRandom(1) });
  const baseline = await follow(browser, network, false);
  expect(baseline).toMatchObject({ code: 0, bumps: 0, hasVisitedAll: true, cut: 0 });
  const bad = await follow(browser, network, true);
  expect(bad.cut).toBeGreaterThan(20);
  expect(bad).toEqual({ ...baseline, cut: bad.cut });
  await network.close();
});
