import { createHash } from "node:crypto";
import { createdKeySchema } from "@corridor/protocol";
import { pino } from "pino";
import { describe, expect, it } from "vitest";
import { WebSocket } from "ws";
import { RosClient } from "../../testing/ros-client.ts";
import { envelopeXml, operationXml } from "../../testing/soap-client.ts";
import { startTestRelay } from "../../testing/test-relay.ts";
import { TestSocket } from "../../testing/test-socket.ts";

/** Starts a relay and collects everything that it logs at a level. */
async function withLog(level: string) {
  const lines: string[] = [];
  const log = pino({ level }, { write: (line: string) => void lines.push(line) });
  return { lines, relay: await startTestRelay({ log }) };
}

describe("the log", () => {
  it("contains no key and no IP address, even if a client puts its key in the wrong place", async () => {
    const { lines, relay } = await withLog("debug");
    const robot = await relay.register();
    const { driverKey, ownerKey, id } = robot;
    const page = await TestSocket.page(relay, robot);
    const script = await TestSocket.driver(relay, robot);
    script.send({ type: "command", command: { action: "left 90" }, key: "a-key-0001" });
    await page.socket.next("command");
    script.sendRaw(driverKey);
    await script.next("problem");
    const wanted = { method: "POST", key: ownerKey, body: { kind: "drive", use: "url" } };
    const { key: urlKey } = createdKeySchema.parse(
      await (await relay.ask(robot, "/keys", wanted)).json(),
    );
    const post = { method: "POST", body: { action: "left 90" } };
    const mcp = {
      method: "POST",
      headers: { "Content-Type": "application/json" },
      body: JSON.stringify({ jsonrpc: "2.0", id: 1, method: driverKey }),
    };
    const soap = (message: string, headers: Record<string, string> = {}): Promise<Response> =>
      fetch(`${relay.origin}/soap`, {
        method: "POST",
        headers: { "Content-Type": "text/xml", ...headers },
        body: message,
      });
    const sense = envelopeXml(operationXml("Sense", { robot: robot.address, after: driverKey }));
    const statuses = [
      await relay.ask(robot, "/commands", post),
      await relay.ask(robot, "/commands", { ...post, key: ownerKey }),
      await relay.ask(robot, "/commands", { ...post, body: driverKey }),
      await relay.ask(robot, `/commands?key=${driverKey}`, { key: `${driverKey}x` }),
      await relay.ask(robot, `/${driverKey}`, { headers: { "User-Agent": driverKey } }),
      await fetch(`${relay.origin}/r/${id}?key=${ownerKey}`),
      await fetch(`${relay.origin}/r/${driverKey}%E0%A4%A`),
      await relay.ask(robot, "/commands", { ...post, key: urlKey }),
      await relay.ask(robot, `/${urlKey}`, { key: urlKey }),
      await fetch(`${relay.origin}/r/${id}/ros/${urlKey}`),
      await fetch(`${relay.origin}/r/${id}/mcp/${urlKey}`, mcp),
      await fetch(`${relay.origin}/r/${id}/mcp/${driverKey}`, mcp),
      await fetch(`${relay.origin}/r/${id}/mcp/${urlKey}?key=${driverKey}`),
      await soap(sense),
      await soap(sense, { Authorization: `Bearer ${driverKey}`, SOAPAction: driverKey }),
      await soap(`<${driverKey}>`),
      await fetch(`${relay.origin}/soap?${driverKey}`),
    ].map(({ status }) => status);
    expect(statuses).toEqual([
      202, 403, 400, 401, 404, 503, 404, 401, 404, 400, 200, 401, 405, 500, 500, 500, 400,
    ]);
    const base = relay.origin.replace("http", "ws");
    const lost = new WebSocket(`${base}/api/v1/robots/${driverKey}/socket?key=${ownerKey}`);
    await new Promise((resolve) => lost.once("open", resolve));
    lost.send("x".repeat(20_000));
    await new Promise((resolve) => lost.once("close", resolve));
    await RosClient.refusedWith(relay, robot, { pathKey: driverKey });
    const ros = await RosClient.connect(relay, robot, { pathKey: urlKey });
    await ros.call(driverKey, { [urlKey]: ownerKey });
    ros.sendText(`"${driverKey}`);
    await (await RosClient.connect(relay, robot)).call("/rosapi/nodes");
    await relay.close();

    const text = lines.join("");
    for (const key of [driverKey, ownerKey, urlKey]) {
      const hash = createHash("sha256").update(key).digest("base64url");
      expect(text).not.toContain(key.slice(4));
      expect(text).toContain(`"key":"${hash.slice(0, 6)}"`);
      expect(text).not.toContain(hash.slice(0, 7));
    }
    expect(text).not.toContain("127.0.0.1");
    expect(text).toContain("WebSocket error");
  });

  it("has one line for each request and socket at level info, and none for health checks", async () => {
    const { lines, relay } = await withLog("info");
    const robot = await relay.register();
    await (await relay.ask(robot, "/commands/7")).text();
    await (await fetch(`${relay.origin}/healthz`)).text();
    const script = await TestSocket.driver(relay, robot);
    script.close();
    await script.closed;
    await relay.close();
    expect(lines.map((line) => JSON.parse(line) as unknown)).toMatchObject([
      { method: "POST", route: "/robots", status: 201, key: null, msg: "request completed" },
      { method: "GET", route: "/robots/:id/commands/:seq", status: 404, msg: "request completed" },
      { role: "drive", client: "Python", msg: "WebSocket client authenticated" },
      { code: 1005, msg: "WebSocket closed" },
    ]);
  });

  it("contains no requests at the default level", async () => {
    const { lines, relay } = await withLog("warn");
    await relay.register();
    await relay.close();
    expect(lines).toEqual([]);
  });
});
