/** AI agents drive the robot in the page by the Model Context Protocol. */
import { Client, StreamableHTTPClientTransport } from "@modelcontextprotocol/client";
import { expect, test } from "./fixtures.ts";
import { openMoreSection } from "./support/remote-panel.ts";
import { copyAddress, setSpeed } from "./support/remote-robot.ts";

interface Seen {
  goalReached: boolean;
  bumps: number;
  sensors: { front: number; right: number };
}

/** Connects an agent that has only the address of the robot. */
async function connect(address: string): Promise<Client> {
  const { origin, pathname, hash } = new URL(address);
  const headers = { Authorization: `Bearer ${hash.slice(1)}` };
  const url = new URL(`${origin}${pathname}/mcp`);
  const client = new Client({ name: "agent", version: "1.0.0" });
  await client.connect(new StreamableHTTPClientTransport(url, { requestInit: { headers } }));
  return client;
}

test("an agent that has only the address solves the maze in the page", async ({ page }) => {
  await page.goto("/");
  await setSpeed(page, "16");
  const agent = await connect(await copyAddress(page));
  const call = async (name: string, args: Record<string, unknown> = {}): Promise<Seen> => {
    const { isError, content, structuredContent } = await agent.callTool({ name, arguments: args });
    expect(isError ?? false, JSON.stringify(content)).toBe(false);
    return (structuredContent as { snapshot: Seen }).snapshot;
  };

  const { content } = await agent.callTool({ name: "look", arguments: { picture: true } });
  expect(content).toMatchObject([
    { type: "text", text: expect.stringContaining("G goal") },
    { type: "image", mimeType: "image/png" },
  ]);
  let seen = await call("sense");
  for (let step = 1; step <= 100 && !seen.goalReached; step++) {
    const key = `step-${String(step).padStart(4, "0")}`;
    const { front, right } = seen.sensors;
    if (right > 100) seen = await call("act", { action: "right 90", key: `${key}-turn` });
    else if (front <= 100) seen = await call("act", { action: "left 90", key: `${key}-turn` });
    if (seen.sensors.front > 100) {
      seen = await call("act", { action: "move", distance: 100, key: `${key}-move` });
    }
  }
  expect(seen).toMatchObject({ goalReached: true, bumps: 0 });

  const reset = await call("reset", { key: "reset-0001" });
  expect(reset).toMatchObject({ goalReached: false });
  await openMoreSection(page);
  const scripts = page.getByRole("region", { name: "Scripts", exact: true });
  await expect(scripts.getByText("MCP script")).toBeVisible();
  await agent.close();
});
