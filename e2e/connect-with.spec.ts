/** "Connect with" in the Remote panel, with a real relay and clients of several kinds. */
import { Client, StreamableHTTPClientTransport } from "@modelcontextprotocol/client";
import type { Page } from "playwright/test";
import { RelayProcess } from "../tests/support/relay-process.ts";
import { expect, test } from "./fixtures.ts";
import { openMoreSection } from "./support/remote-panel.ts";
import { api, copyAddress } from "./support/remote-robot.ts";
import { smallWindow } from "./support/window-sizes.ts";

test.use(smallWindow);

function connect(page: Page) {
  const section = page.getByRole("region", { name: "Connect with" });
  const kind = section.getByRole("combobox", { name: "Connect with" });
  return {
    kind,
    text: section.getByRole("textbox", { name: "Script" }),
    mark: section.getByText("First message arrived"),
    copy: async (name: string): Promise<string> => {
      await kind.selectOption({ label: name });
      await page.evaluate(() => navigator.clipboard.writeText("nothing"));
      await section.getByRole("button", { name: "Copy", exact: true }).click();
      // A key for URLs is created first.
      const read = () => page.evaluate(() => navigator.clipboard.readText());
      await expect.poll(read).not.toBe("nothing");
      return read();
    },
  };
}

/** Sends one ROS message. */
async function callRos(url: string): Promise<void> {
  const socket = new WebSocket(url);
  await new Promise((resolve, reject) => {
    socket.addEventListener("open", () => {
      socket.send(JSON.stringify({ op: "call_service", service: "/rosapi/topics", id: "1" }));
    });
    socket.addEventListener("message", resolve);
    socket.addEventListener("error", reject);
  });
  socket.close();
}

test("offers only what a service without gateways serves, in the page and in the documentation", async ({
  page,
}) => {
  const relay = await RelayProcess.start({ environment: { GATEWAYS: "none" } });
  try {
    await page.goto(relay.url);
    await copyAddress(page);
    const options = connect(page).kind.getByRole("option");
    await expect(options.filter({ hasText: "Micromouse program" })).toHaveCount(1);
    await expect(options.filter({ hasText: /ROS|MCP|SOAP/ })).toHaveCount(0);
    await page.goto(`${relay.url}/docs#connect`);
    await expect(page.getByRole("heading", { name: "Connect" })).toBeInViewport();
    const tabs = page.getByRole("group", { name: "Connect with" }).getByRole("radio");
    await expect(tabs.last()).toHaveAccessibleName("ASU VIPLE");
    await expect(tabs).toHaveCount(10);
  } finally {
    await relay.stop();
  }
});

async function connectsByUrl(page: Page, address: string): Promise<void> {
  const panel = connect(page);
  const url = await panel.copy("Any rosbridge tool");
  expect(url).toMatch(/^ws:\/\/\S+\/ros\/url_[\w-]+$/);
  await expect(panel.text).toHaveValue(/\/ros\/•••• •••• \S{4}$/);
  await expect(panel.mark).toBeHidden();
  await callRos(url);
  await expect(panel.mark).toBeVisible();
  await page.reload();
  await expect(panel.kind).toBeVisible();
  expect(await panel.copy("Any rosbridge tool ✓")).toBe(url);
  await openMoreSection(page);
  const keys = page.getByRole("region", { name: "Keys" }).getByRole("listitem");
  const urlKey = keys.filter({ hasText: "in a URL" });
  await expect(urlKey).toHaveCount(1);
  await urlKey.getByRole("button", { name: "Revoke" }).click();
  await expect(urlKey).toHaveCount(0);
  const next = await panel.copy("Any rosbridge tool ✓");
  expect(next).not.toBe(url);
  await callRos(next);
  expect((await api(address, "/sensors")).status).toBe(200);
}

async function marksFirstMessages(page: Page, address: string): Promise<void> {
  const panel = connect(page);
  const settings = JSON.parse(await panel.copy("VS Code (MCP)")) as {
    servers: { corridor: { url: string; headers: Record<string, string> } };
  };
  await expect(panel.mark).toBeHidden();
  const { url, headers } = settings.servers.corridor;
  const agent = new Client({ name: "agent", version: "1.0.0" });
  await agent.connect(
    new StreamableHTTPClientTransport(new URL(url), { requestInit: { headers } }),
  );
  await agent.callTool({ name: "sense", arguments: {} });
  await agent.close();
  await expect(panel.mark).toBeVisible();
  await panel.kind.selectOption("curl");
  await expect(panel.mark).toBeHidden();
  await api(address, "/sensors");
  await panel.kind.selectOption("javascript");
  await expect(panel.mark).toBeVisible();
}

async function showsTextsOfDocumentation(page: Page, address: string): Promise<void> {
  const { origin, pathname, hash } = new URL(address);
  const panel = connect(page);
  await expect(panel.kind.getByRole("option")).toHaveCount(19);
  const names = await panel.kind.getByRole("option").allTextContents();
  const copied: string[] = [];
  for (const name of names) copied.push((await panel.copy(name)).trim());
  const opened = page.waitForEvent("popup");
  await page.getByRole("link", { name: "How to write a script" }).click();
  const docs = await opened;
  const tabs = docs.getByRole("group", { name: "Connect with" }).getByRole("radio");
  // The documentation opens at the tool that the page shows.
  await expect(tabs.last()).toBeChecked();
  await expect(docs.getByRole("group", { name: names.at(-1) ?? "" })).toBeInViewport();
  // A build file may be below the text.
  const blocks = await docs.locator(".panel pre:first-of-type").allTextContents();
  const [id, key] = [pathname.slice("/r/".length), hash.slice(1)];
  const urlKey = /url_[\w-]+/.exec(copied.join("\n"))?.[0] ?? "";
  const own = (text: string): string =>
    text
      .trim()
      .replaceAll("http://HOST", origin)
      .replaceAll("ws://HOST", origin.replace("http", "ws"))
      .replaceAll(/\bID\b/g, id)
      .replaceAll("url_KEY", urlKey)
      .replaceAll(/\bKEY\b/g, key);
  expect(blocks.map(own)).toEqual(copied);
}

test("connects tools of several kinds with the robot of one page", async ({ page }) => {
  await page.goto("/");
  const address = await copyAddress(page);
  await test.step("marks each kind at its first message", () => marksFirstMessages(page, address));
  await test.step("a tool that has only the URL connects, by one key that a reload keeps, until it is revoked", () =>
    connectsByUrl(page, address));
  await test.step("shows the same texts in the documentation", () =>
    showsTextsOfDocumentation(page, address));
});
