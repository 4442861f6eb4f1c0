/**
 * The robot in the page, as any robot host, and the gateways of its relay must pass the conformance
 * kit. The kit is the npm package that builders of robots install.
 */
import { encodeLink } from "@corridor/link";
import { join } from "node:path";
import { expect, test } from "./fixtures.ts";
import { EmptyFolder, userEnvironment } from "./support/installed-package.ts";
import { runScript } from "./support/script.ts";
import { smallWindow, tinyWindow } from "./support/window-sizes.ts";

const PACKAGE = join(import.meta.dirname, "../apps/cli/dist");

/** the pen of docs/conformance.md, with the goal in its far right corner */
const pen = encodeLink({
  maze: {
    format: "corridor/maze",
    version: 1,
    name: "Pen",
    blocks: ["####", "#..#", "#..#", "#..#", "#..#", "#..#", "####"],
    start: { column: 2, row: 5, heading: "north" },
    goals: [{ column: 2, row: 1 }],
  },
});

test("the robot in the page and its gateways pass every check of the conformance kit", async ({
  page,
}) => {
  test.setTimeout(500_000);
  await page.setViewportSize(smallWindow.viewport);
  if (!pen.ok) throw new Error(pen.code);
  await page.goto(`/#${pen.text}`);
  await page.getByRole("radio", { name: "Remote" }).click();
  await page.getByRole("button", { name: "Copy address with key" }).click();
  const address = await page.evaluate(() => navigator.clipboard.readText());
  // The checks need only the robot, and drawing takes most of the page's processor time.
  await page.setViewportSize(tinyWindow.viewport);
  const folder = await EmptyFolder.create();
  await folder.install(PACKAGE);
  const command = join(folder.path, "node_modules/.bin/corridor");
  const words = [command, "conformance", address, "--gateways"];
  const { code, output } = await runScript(words, "", userEnvironment);
  await folder.remove();
  expect(output).toContain("\nSOAP gateway\n");
  expect(output).toMatch(
    /\nCorridor conformance, .*: PASSED, \d+ passed, 0 failed, 0 not offered, 2 not testable here\n$/,
  );
  expect(code).toBe(0);
});
