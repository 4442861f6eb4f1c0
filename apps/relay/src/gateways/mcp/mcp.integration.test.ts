import type { Registration, ScriptList } from "@corridor/protocol";
import { snapshotOf } from "@corridor/protocol/testing";
import { describe, expect, it } from "vitest";
import { callMessage, callTool, connectAgent, eras, mcpUrl } from "../../testing/mcp-client.ts";
import { makeKey, reportedRobot } from "../../testing/reported-robot.ts";
import { startTestRelay, type TestRelay } from "../../testing/test-relay.ts";

const MOVE = { action: "move", distance: 100, key: "step-0001" };

async function withPage() {
  const { start, end, ...parts } = await reportedRobot();
  /** Runs the next command. */
  const run = async (): Promise<number> => {
    const seq = await start();
    end(seq);
    return seq;
  };
  return { ...parts, run, url: mcpUrl(parts.relay, parts.robot) };
}

async function post(
  url: string,
  key: string | null,
  message: unknown,
  headers: Record<string, string> = {},
): Promise<Response> {
  return fetch(url, {
    method: "POST",
    headers: {
      "Content-Type": "application/json",
      ...(key !== null && { Authorization: `Bearer ${key}` }),
      ...headers,
    },
    body: typeof message === "string" ? message : JSON.stringify(message),
  });
}

async function scripts(relay: TestRelay, robot: Registration): Promise<ScriptList["scripts"]> {
  const answer = await relay.ask(robot, "/scripts", { key: robot.ownerKey });
  return ((await answer.json()) as ScriptList).scripts;
}

describe.each(eras)("an agent of the era %s", (era) => {
  it("lists the tools, senses, looks and drives", async () => {
    const { robot, url, run } = await withPage();
    const agent = await connectAgent(url, robot.driverKey, era);
    const { tools } = await agent.listTools();
    const names = ["sense", "look", "wait", "act", "stop", "reset"];
    expect(tools.map(({ name }) => name)).toEqual(names);
    expect(agent.getInstructions()).toContain("You drive a robot through a maze.");
    expect((await callTool(agent, "sense")).text).toContain("front 250.5, right 50");
    expect((await callTool(agent, "look")).text).toContain("#");
    const acting = callTool(agent, "act", MOVE);
    expect(await run()).toBe(1);
    expect(await acting).toMatchObject({
      isError: false,
      structured: { record: { seq: 1, state: "completed" }, snapshot: { seq: 101 } },
    });
  });

  it("uses a key in the path, and with a watch key only reads", async () => {
    const { relay, robot, url } = await withPage();
    const { key } = await makeKey(relay, robot, "watch", "url");
    const agent = await connectAgent(`${url}/${key}`, null, era);
    const { tools } = await agent.listTools();
    expect(tools.map(({ name }) => name)).toEqual(["sense", "look", "wait"]);
    const { isError, text } = await callTool(agent, "act", MOVE);
    expect(isError).toBe(true);
    expect(text).toContain("A watch key permits only reading.");
  });

  it("waits for a condition", async () => {
    const { robot, url, page, epoch } = await withPage();
    const agent = await connectAgent(url, robot.driverKey, era);
    const waiting = callTool(agent, "wait", { until: [{ goal: true }] });
    page.send({ type: "snapshot", epoch, snapshot: snapshotOf({ seq: 2, goalReached: true }) });
    expect((await waiting).structured).toMatchObject({ condition: 0, snapshot: { seq: 2 } });
  });

  it("is in the owner's list as MCP, with the reason of the newest refused command", async () => {
    const { relay, robot, url } = await withPage();
    const agent = await connectAgent(url, robot.driverKey, era);
    const refused = await callTool(agent, "act", { action: "fly" });
    expect(refused.isError).toBe(true);
    expect(refused.text).toContain("action: found 'fly', expected one of forward");
    const listed = (await scripts(relay, robot)).filter(({ client }) => client === "MCP");
    expect(listed).toMatchObject([{ lastProblem: { detail: refused.text.slice(0, 250) } }]);
  });
});

describe("an agent that waits many times at once", () => {
  it("learns that it has reached the limit, and still drives", async () => {
    const { robot, url, run } = await withPage();
    const agent = await connectAgent(url, robot.driverKey, "2026-07-28");
    const waits = Array.from({ length: 6 }, () => callTool(agent, "wait", { seconds: 1 }));
    const acting = callTool(agent, "act", MOVE);
    await run();
    expect((await acting).isError).toBe(false);
    const refused = (await Promise.all(waits)).filter(({ isError }) => isError);
    expect(refused).toHaveLength(2);
    expect(refused[0]?.text).toContain("4 connections use this key, the maximum.");
  });
});

describe("the owner of the robot", () => {
  it("pauses, blocks and revokes an agent while it waits", async () => {
    const { relay, robot, url, page } = await withPage();
    const { id, key } = await makeKey(relay, robot, "drive");
    const agent = await connectAgent(url, key, "2026-07-28");
    const own = { method: "PUT", key: robot.ownerKey };
    await relay.ask(robot, "/pause", own);
    const paused = await callTool(agent, "act", MOVE);
    expect(paused).toMatchObject({ isError: true, structured: { problem: { status: 409 } } });
    await relay.ask(robot, "/pause", { ...own, method: "DELETE" });

    const acting = callTool(agent, "act", MOVE);
    await page.next("command");
    const [script] = (await scripts(relay, robot)).filter(({ client }) => client === "MCP");
    const { driver, name, client } = script ?? {};
    const block = { method: "POST", key: robot.ownerKey, body: { driver, name, client } };
    const blocked = (await (await relay.ask(robot, "/blocked", block)).json()) as { id: string };
    expect(await acting).toMatchObject({
      isError: true,
      text: expect.stringContaining("The robot's owner has blocked this script."),
    });
    expect((await post(url, key, callMessage("sense"))).status).toBe(403);
    await relay.ask(robot, `/blocked/${blocked.id}`, { method: "DELETE", key: robot.ownerKey });

    const waiting = callTool(agent, "wait");
    // A second request, which arrives after the first one.
    await callTool(agent, "sense");
    await relay.ask(robot, `/keys/${id}`, { method: "DELETE", key: robot.ownerKey });
    expect((await waiting).isError).toBe(true);
    expect((await post(url, key, callMessage("sense"))).status).toBe(401);
  });
});

describe("the URL", () => {
  it("requires a key, and names the scheme without metadata of a login", async () => {
    const { relay, robot, url } = await withPage();
    for (const key of [null, `drv_${"A".repeat(22)}`]) {
      const answer = await post(url, key, callMessage("sense"));
      expect(answer.status).toBe(401);
      expect(answer.headers.get("www-authenticate")).toBe("Bearer");
    }
    for (const path of [
      "/.well-known/oauth-protected-resource",
      `/.well-known/oauth-protected-resource/r/${robot.id}/mcp`,
      "/.well-known/oauth-authorization-server",
    ]) {
      expect((await fetch(`${relay.origin}${path}`)).status).toBe(404);
    }
    await expect(connectAgent(url, null, "2025")).rejects.toThrow("Send the robot's key");
  });

  it("accepts each kind of key only where it belongs", async () => {
    const { relay, robot, url } = await withPage();
    const inUrl = (await makeKey(relay, robot, "drive", "url")).key;
    const other = await relay.register();
    const message = callMessage("sense");
    const status = async (path: string, key: string | null) =>
      (await post(path, key, message)).status;
    expect(await status(url, inUrl)).toBe(401);
    expect(await status(`${url}/${robot.driverKey}`, null)).toBe(401);
    expect(await status(`${url}/${inUrl}`, null)).toBe(200);
    expect(await status(url, robot.driverKey)).toBe(200);
    // The header takes precedence.
    expect(await status(`${url}/${inUrl}`, other.driverKey)).toBe(401);
    expect(await status(`${url}/nonsense`, robot.driverKey)).toBe(200);
    expect(await status(url, robot.ownerKey)).toBe(403);
    expect(await status(mcpUrl(relay, other), robot.driverKey)).toBe(401);
    expect(await status(mcpUrl(relay, { ...other, id: "A".repeat(22) }), robot.driverKey)).toBe(
      404,
    );
    expect(await status(`${mcpUrl(relay, other)}/${inUrl}`, null)).toBe(401);
  });

  it.each(["GET", "DELETE", "PUT", "HEAD"])("answers %s with 405", async (method) => {
    const { robot, url } = await withPage();
    const headers = { Authorization: `Bearer ${robot.driverKey}`, Accept: "text/event-stream" };
    const answer = await fetch(url, { method, headers });
    expect(answer.status).toBe(405);
    expect(answer.headers.get("allow")).toBe("POST");
  });

  it.each([
    { origin: "https://example.org", status: 403 },
    { origin: "null", status: 403 },
    { origin: "http://localhost.example.org", status: 403 },
    { origin: "http://localhost:6274", status: 200 },
    { origin: "http://127.0.0.1:9", status: 200 },
    { origin: "http://[::1]:9", status: 200 },
  ])("answers a page of $origin with $status", async ({ origin, status }) => {
    const { robot, url } = await withPage();
    const answer = await post(url, robot.driverKey, callMessage("sense"), { Origin: origin });
    expect(answer.status).toBe(status);
    const allowed = status === 200 ? origin : null;
    expect(answer.headers.get("access-control-allow-origin")).toBe(allowed);
    const preflight = await fetch(url, { method: "OPTIONS", headers: { Origin: origin } });
    expect(preflight.status).toBe(status === 200 ? 204 : 403);
  });

  it("answers a page of this service", async () => {
    const { relay, robot, url } = await withPage();
    const headers = { Origin: relay.origin };
    expect((await post(url, robot.driverKey, callMessage("sense"), headers)).status).toBe(200);
  });

  it("answers in JSON, whatever a client accepts, and without a session", async () => {
    const { robot, url } = await withPage();
    for (const accept of ["application/json", "text/event-stream", "*/*"]) {
      const answer = await post(url, robot.driverKey, callMessage("sense"), { Accept: accept });
      expect(answer.headers.get("content-type")).toMatch(/^application\/json/);
      expect(answer.headers.get("mcp-session-id")).toBeNull();
      expect(await answer.json()).toMatchObject({ jsonrpc: "2.0", id: 1 });
    }
    // A session of another server does no harm.
    const session = { "Mcp-Session-Id": "a-session" };
    expect((await post(url, robot.driverKey, callMessage("sense"), session)).status).toBe(200);
  });

  it("confirms notifications", async () => {
    const { robot, url } = await withPage();
    const message = { jsonrpc: "2.0", method: "notifications/initialized" };
    const answer = await post(url, robot.driverKey, message);
    expect([answer.status, await answer.text()]).toEqual([202, ""]);
  });

  it("refuses streams of changes, because tools never change", async () => {
    const { robot, url } = await withPage();
    const meta = {
      "io.modelcontextprotocol/protocolVersion": "2026-07-28",
      "io.modelcontextprotocol/clientCapabilities": {},
    };
    const params = { notifications: { toolsListChanged: true }, _meta: meta };
    const method = "subscriptions/listen";
    const headers = { "MCP-Protocol-Version": "2026-07-28", "Mcp-Method": method };
    const message = { jsonrpc: "2.0", id: 1, method, params };
    const answer = await post(url, robot.driverKey, message, headers);
    expect(answer.headers.get("content-type")).toMatch(/^application\/json/);
    expect(await answer.json()).toMatchObject({ error: { code: -32603 } });
  });

  it.each([
    { what: "an unknown method", method: "tools/fly", status: 404, code: -32601 },
    { what: "an unknown version", version: "2027-01-01", status: 400, code: -32022 },
    { what: "a call without a tool", params: { name: 7 }, status: 200, code: -32602 },
    { what: "an unknown tool", params: { name: "fly" }, status: 200, code: -32602 },
  ])("answers $what as the protocol requires", async (wrong) => {
    const { robot, url } = await withPage();
    const { method = "tools/call", version = "2026-07-28" } = wrong;
    const _meta = {
      "io.modelcontextprotocol/protocolVersion": version,
      "io.modelcontextprotocol/clientCapabilities": {},
    };
    const params = { name: "sense", arguments: {}, ...wrong.params, _meta };
    const headers = {
      "MCP-Protocol-Version": version,
      "Mcp-Method": method,
      "Mcp-Name": String(params.name),
    };
    const message = { jsonrpc: "2.0", id: 1, method, params };
    const answer = await post(url, robot.driverKey, message, headers);
    const { error } = (await answer.json()) as { error: { code: number; message: string } };
    expect({ status: answer.status, code: error.code }).toEqual({
      status: wrong.status,
      code: wrong.code,
    });
    expect(JSON.stringify(error)).not.toMatch(/node_modules|\.ts:\d|at /);
  });

  it("is answered with a sentence if the operator has switched the gateway off", async () => {
    const relay = await startTestRelay({ config: { gateways: ["ros"] } });
    const robot = await relay.register();
    const url = mcpUrl(relay, robot);
    for (const path of [url, `${url}/url_${"A".repeat(22)}`]) {
      const answer = await post(path, robot.driverKey, callMessage("sense"));
      expect(answer.status).toBe(404);
      expect(await answer.json()).toMatchObject({
        type: "/problems/gateway-disabled",
        detail: expect.stringContaining("GATEWAYS"),
      });
    }
    const wanted = { method: "POST", key: robot.ownerKey, body: { kind: "drive", use: "url" } };
    const made = await (await relay.ask(robot, "/keys", wanted)).json();
    expect(made).toMatchObject({ urls: { mcp: null } });
  });
});
