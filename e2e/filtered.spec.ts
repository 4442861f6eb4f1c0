/**
 * Scripts drive the robot in a page whose network lets no WebSocket through and keeps answers back.
 */
import { encodeLink } from "@corridor/link";
import { countOpenCells, generateTree } from "@corridor/maze";
import { expect, test } from "./fixtures.ts";
import { RelayProxy } from "./support/relay-proxy.ts";
import { exampleCommand, runScript } from "./support/script.ts";

test("the right-wall follower drives a page that only plain HTTPS reaches", async ({
  browser,
  relay,
}) => {
  test.setTimeout(120_000);
  const maze = generateTree({ columns: 7, rows: 7, seed: 3, name: "Tree" });
  const link = encodeLink({ maze });
  if (!link.ok) throw new Error(link.code);
  const door = await RelayProxy.start(relay);
  // Not a watched window: the browser complains of the WebSocket that does not open.
  const context = await browser.newContext({ permissions: ["clipboard-read", "clipboard-write"] });
  const page = await context.newPage();
  const lines: string[] = [];
  page.on("request", (request) => lines.push(new URL(request.url()).pathname));
  await page.goto(`${door.url}/#${link.text}`);
  await page.getByRole("combobox", { name: "Speed" }).selectOption("16");
  await page.getByRole("radio", { name: "Remote" }).click();
  await page.getByRole("button", { name: "Copy address with key" }).click();
  const address = await page.evaluate(() => navigator.clipboard.readText());
  expect(address).toContain(door.url);
  const cells = `${countOpenCells(maze)}`;
  const { code, output } = await runScript([
    ...exampleCommand("Python"),
    address,
    "--until-cells",
    cells,
  ]);
  expect(output).toContain(`${cells} cells visited`);
  expect(code).toBe(0);
  expect(lines.some((path) => path.endsWith("/line/messages"))).toBe(true);
  await context.close();
  await door.close();
});
