/** Agents of real clients drive a robot through a real relay. */
import { describe, expect, it } from "vitest";
import { callTool, connectAgent, eras } from "../../../../apps/relay/src/testing/mcp-client.ts";
import { mazePresets } from "@corridor/maze";
import { corridor, corridorHost } from "../../../support/mcp/corridor-host.ts";
import { solve } from "../../../support/mcp/solve.ts";
import { startCluster } from "../../../support/client/cluster.ts";
import { sharedRelayProcess } from "../../../support/test-relay-process.ts";

const sharedRelay = sharedRelayProcess();

describe.each(eras)("an agent of the era %s at a real relay", (era) => {
  it("solves a corridor with sense and act alone", async () => {
    const { registration, url } = await corridorHost(await sharedRelay());
    const agent = await connectAgent(url, registration.driverKey, era);
    const seen = await solve((name, args) => callTool(agent, name, args));
    expect(seen).toMatchObject({ goalReached: true, bumps: 0 });
  });
});

describe("an agent", () => {
  it("moves the robot once, although the answer is lost and the call is repeated", async () => {
    const { registration, page, url } = await corridorHost(await sharedRelay());
    page.endsCommands = false;
    const act = { action: "move", distance: 100, key: "step-0001" };
    const lost = new AbortController();
    const message = {
      jsonrpc: "2.0",
      id: 1,
      method: "tools/call",
      params: { name: "act", arguments: act },
    };
    const post = fetch(url, {
      method: "POST",
      headers: {
        Authorization: `Bearer ${registration.driverKey}`,
        "Content-Type": "application/json",
      },
      body: JSON.stringify(message),
      signal: lost.signal,
    });
    await expect.poll(() => page.started).toBe(1);
    lost.abort();
    await expect(post).rejects.toThrow("aborted");
    const agent = await connectAgent(url, registration.driverKey, "2026-07-28");
    const again = callTool(agent, "act", act);
    page.endAll("completed");
    expect((await again).text).toContain("the robot did not move again");
    expect(page.started).toBe(1);
  });

  it("solves a maze that ships with the page", async () => {
    const preset = mazePresets.find(({ id }) => id === "tree")?.maze ?? corridor;
    const { registration, url } = await corridorHost(await sharedRelay(), preset);
    const agent = await connectAgent(url, registration.driverKey, "2026-07-28");
    const seen = await solve((name, args) => callTool(agent, name, args));
    expect(seen).toMatchObject({ goalReached: true, bumps: 0 });
  });

  it("is served by any relay: each call by another one than the last", async () => {
    const cluster = await startCluster();
    const relays = [await cluster.startRelay(), await cluster.startRelay()] as const;
    const [atPage, other] = relays;
    cluster.sendTo(atPage);
    const { registration, url } = await corridorHost({ url: cluster.origin }, corridor, atPage.url);
    const direct = [atPage, other].map(({ url: origin }) => url.replace(cluster.origin, origin));
    const agents = await Promise.all(
      direct.map((each) => connectAgent(each, registration.driverKey, "2025")),
    );
    let calls = 0;
    const seen = await solve((name, args) => {
      const agent = agents[(calls += 1) % 2];
      if (agent === undefined) throw new Error("no agent");
      return callTool(agent, name, args);
    });
    expect(seen).toMatchObject({ goalReached: true, bumps: 0 });
  });
});
