/**
 * Scripts drive the robot of a page whose network blocks WebSockets and buffers responses.
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
  const maze = generateTree({ columns: 7, rows: 7, seed: 3, name: "Tree" });
  const link = encodeLink({ maze });
  if (!link.ok) throw new Error(link.code);
  const proxy = await RelayProxy.start(relay);
  // Not an openWindow fixture: the browser logs an error for the WebSocket that does not open.
  const context = await browser.newContext({ permissions: ["clipboard-read", "clipboard-write"] });
  const page = await context.newPage();
  const paths: string[] = [];
  page.on("request", (request) => paths.push(new URL(request.url()).pathname));
  await page.goto(`${proxy.url}/#${link.text}`);
  await page.getByRole("combobox", { name: "Speed" }).selectOption("16");
  await page.getByRole("radio", { name: "Remote" }).click();
  await page.getByRole("button", { name: "Copy address with key" }).click();
  const address = await page.evaluate(() => navigator.clipboard.readText());
  expect(address).toContain(proxy.url);
  const cells = `${countOpenCells(maze)}`;
  const { code, output } = await runScript([
    ...exampleCommand("Python"),
    address,
    "--until-cells",
    cells,
  ]);
  expect(output).toContain(`${cells} cells visited`);
  expect(code).toBe(0);
  expect(paths.some((path) => path.endsWith("/long-poll/messages"))).toBe(true);
  await context.close();
  await proxy.close();
});
