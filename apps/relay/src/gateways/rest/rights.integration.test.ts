/** Permissions: every endpoint and message type with every kind of key, and without a key. */
import { createdKeySchema, type Registration } from "@corridor/protocol";
import { snapshotOf } from "@corridor/protocol/testing";
import { describe, expect, it } from "vitest";
import { rights, type Verb } from "../../robots/access/callers.ts";
import { maze } from "../../platform/testing/sample-documents.ts";
import { RosClient, type RosConnectOptions } from "../../testing/ros-client.ts";
import { callSoap } from "../../testing/soap-client.ts";
import { startTestRelay, type TestRelay } from "../../testing/test-relay.ts";
import { TestSocket } from "../../testing/test-socket.ts";

const ACT = { action: "left 90" };

/** Endpoints by the permission that they require. */
const calls: { verb: Verb; method: string; path: string; body?: unknown }[] = [
  { verb: "read", method: "GET", path: "/sensors" },
  { verb: "look", method: "GET", path: "/maze" },
  { verb: "host", method: "PUT", path: "/maze", body: maze },
  { verb: "log", method: "GET", path: "/commands" },
  { verb: "log", method: "GET", path: "/commands/1" },
  { verb: "read", method: "GET", path: "/events?wait=0" },
  { verb: "read", method: "GET", path: "/events" },
  { verb: "command", method: "POST", path: "/commands", body: ACT },
  { verb: "command", method: "DELETE", path: "/commands" },
  { verb: "command", method: "DELETE", path: "/commands/1" },
  { verb: "grant", method: "POST", path: "/keys", body: { kind: "watch" } },
  { verb: "grant", method: "GET", path: "/keys" },
  { verb: "grant", method: "DELETE", path: "/keys/______" },
  { verb: "grant", method: "POST", path: "/pairing" },
  { verb: "grant", method: "GET", path: "/pairing" },
  { verb: "grant", method: "PUT", path: "/pairing", body: { id: "______", accept: true } },
  { verb: "grant", method: "DELETE", path: "/pairing" },
  { verb: "moderate", method: "GET", path: "/scripts" },
  { verb: "moderate", method: "PUT", path: "/pause" },
  { verb: "moderate", method: "DELETE", path: "/pause" },
  { verb: "moderate", method: "PUT", path: "/script-reset" },
  { verb: "moderate", method: "DELETE", path: "/script-reset" },
  {
    verb: "moderate",
    method: "POST",
    path: "/blocked",
    body: { driver: "______", name: null, client: "Python" },
  },
  { verb: "moderate", method: "DELETE", path: "/blocked/________" },
  { verb: "inspect", method: "GET", path: "" },
  { verb: "remove", method: "DELETE", path: "" },
];

const holders = [
  "none",
  "unknown",
  "of another robot",
  "revoked",
  "of a connection",
  "in a URL, to drive",
  "in a URL, to watch",
  "watch",
  "drive",
  "own",
] as const;
type Holder = (typeof holders)[number];

async function keysOf(relay: TestRelay, robot: Registration): Promise<Record<Holder, string>> {
  const make = async (kind: string, use?: string) => {
    const request = { method: "POST", key: robot.ownerKey, body: { kind, use } };
    return createdKeySchema.parse(await (await relay.ask(robot, "/keys", request)).json());
  };
  const gone = await make("drive");
  await relay.ask(robot, `/keys/${gone.id}`, { method: "DELETE", key: robot.ownerKey });
  const hello = { type: "hello", version: 1, role: "drive", key: robot.driverKey };
  const opened = await relay.ask(robot, "/long-poll", { method: "POST", body: hello });
  return {
    none: "",
    unknown: `drv_${"A".repeat(22)}`,
    "of another robot": (await relay.register()).ownerKey,
    revoked: gone.key,
    "of a connection": String(((await opened.json()) as { key: string }).key),
    "in a URL, to drive": (await make("drive", "url")).key,
    "in a URL, to watch": (await make("watch", "url")).key,
    watch: (await make("watch")).key,
    drive: robot.driverKey,
    own: robot.ownerKey,
  };
}

/** Expected outcome for each kind of key. */
function expectedFor(verb: Verb, answers: { yes: unknown; forbidden: unknown; stranger: unknown }) {
  const kinds: readonly string[] = rights[verb];
  const known = (kind: string) => (kinds.includes(kind) ? answers.yes : answers.forbidden);
  return Object.fromEntries(
    holders.map((holder) => {
      const isKey = holder === "own" || holder === "drive" || holder === "watch";
      return [holder, isKey ? known(holder) : answers.stranger];
    }),
  );
}

async function withRobot() {
  const relay = await startTestRelay();
  const robot = await relay.register();
  const { socket: page, epoch } = await TestSocket.page(relay, robot);
  page.send({ type: "snapshot", epoch, snapshot: snapshotOf() });
  await relay.ask(robot, "/sensors?wait=5");
  await relay.ask(robot, "/commands", { method: "POST", body: ACT });
  return { relay, robot, keys: await keysOf(relay, robot) };
}

describe("permissions", () => {
  it.each(calls)("$method $path", async ({ verb, method, path, body }) => {
    const { relay, robot, keys } = await withRobot();
    const found: Partial<Record<Holder, unknown>> = {};
    for (const holder of holders) {
      const stop = new AbortController();
      const { signal } = stop;
      const { status } = await relay.ask(robot, path, { method, key: keys[holder], body, signal });
      // With permission, the response is that there is nothing to revoke, answer or block.
      found[holder] = status < 300 || status === 404 || status === 409 ? "yes" : status;
      stop.abort();
    }
    expect(found).toEqual(expectedFor(verb, { yes: "yes", forbidden: 403, stranger: 401 }));
  });

  it("an agent's message, with the key in the header and in the path", async () => {
    const { relay, robot, keys } = await withRobot();
    const url = `${relay.origin}/r/${robot.id}/mcp`;
    const inHeader: Partial<Record<Holder, unknown>> = {};
    const inPath: Partial<Record<Holder, unknown>> = {};
    const statusOf = async (to: string, headers: Record<string, string>): Promise<unknown> => {
      const body = JSON.stringify({ jsonrpc: "2.0", id: 1, method: "tools/list" });
      const json = { "Content-Type": "application/json" };
      const answer = await fetch(to, { method: "POST", headers: { ...json, ...headers }, body });
      return answer.ok ? "yes" : answer.status;
    };
    for (const holder of holders) {
      const key = keys[holder];
      inHeader[holder] = await statusOf(url, { Authorization: `Bearer ${key}` });
      inPath[holder] = await statusOf(`${url}/${key}`, {});
    }
    const outcomes = { yes: "yes", forbidden: 403, stranger: 401 };
    expect(inHeader).toEqual(expectedFor("read", outcomes));
    const strangers = Object.fromEntries(holders.map((holder) => [holder, 401]));
    const permitted = { "in a URL, to drive": "yes", "in a URL, to watch": "yes" };
    expect(inPath).toEqual({ ...strangers, ...permitted });
  });

  it.each([
    { verb: "read", name: "Sense", fields: {} },
    { verb: "command", name: "Command", fields: ACT },
    { verb: "log", name: "GetCommand", fields: { seq: 1 } },
    { verb: "log", name: "GetCommands", fields: {} },
    { verb: "command", name: "CancelCommand", fields: { seq: 1 } },
    { verb: "command", name: "Stop", fields: {} },
  ] as const)(
    "the SOAP operation $name, with the key in the header and in the address",
    async (each) => {
      const { relay, robot, keys } = await withRobot();
      const inHeader: Partial<Record<Holder, unknown>> = {};
      const inAddress: Partial<Record<Holder, unknown>> = {};
      const outcomeOf = async (key: string, headers: Record<string, string>): Promise<unknown> => {
        const address = `${robot.address.replace(/#.*/, "")}${key === "" ? "" : `#${key}`}`;
        const request = { robot: address, ...each.fields };
        const { fields } = await callSoap(relay.origin, each.name, request, { headers });
        return fields["detail.RobotFault.code"] ?? "yes";
      };
      for (const holder of holders) {
        inHeader[holder] = await outcomeOf("", { Authorization: `Bearer ${keys[holder]}` });
        inAddress[holder] = await outcomeOf(keys[holder], {});
      }
      const outcomes = { yes: "yes", forbidden: "forbidden", stranger: "not-authorised" };
      expect(inHeader).toEqual(expectedFor(each.verb, outcomes));
      expect(inAddress).toEqual(expectedFor(each.verb, outcomes));
    },
  );

  it("a ROS client, with the key in the header, in its first message and in the path", async () => {
    const { relay, robot, keys } = await withRobot();
    const inHeader: Partial<Record<Holder, unknown>> = {};
    const inAuth: Partial<Record<Holder, unknown>> = {};
    const inPath: Partial<Record<Holder, unknown>> = {};
    const outcomeOf = async (options: RosConnectOptions, mac?: string): Promise<unknown> => {
      const client = await RosClient.connect(relay, robot, options).catch(String);
      if (typeof client === "string") return Number(/\d{3}$/.exec(client)?.[0]);
      if (mac !== undefined) client.send({ op: "auth", mac });
      const answer = await client.call("/rosapi/nodes").catch(() => null);
      client.close();
      return answer === null ? (await client.closed).code : "yes";
    };
    for (const holder of holders) {
      const key = keys[holder] ?? "";
      inHeader[holder] = await outcomeOf({ key });
      inAuth[holder] = await outcomeOf({ key: null }, key);
      if (key !== "") inPath[holder] = await outcomeOf({ pathKey: key });
    }
    const outcomes = { yes: "yes", forbidden: 403, stranger: 401 };
    // Without a key, the connection waits for the first message.
    expect(inHeader).toEqual({ ...expectedFor("read", outcomes), none: 4401 });
    const closings = { yes: "yes", forbidden: 4403, stranger: 4401 };
    expect(inAuth).toEqual(expectedFor("read", closings));
    const { none: _, ...strangers } = Object.fromEntries(holders.map((holder) => [holder, 401]));
    const permitted = { "in a URL, to drive": "yes", "in a URL, to watch": "yes" };
    expect(inPath).toEqual({ ...strangers, ...permitted });
  });

  it("limits pairing answers to the robot's own keys, while requests need no key", async () => {
    const { relay, robot, keys } = await withRobot();
    const own = { method: "POST", key: robot.ownerKey };
    const { code } = (await (await relay.ask(robot, "/pairing", own)).json()) as { code: string };
    const asked = await fetch(`${relay.origin}/api/v1/pairing`, {
      method: "POST",
      headers: { "Content-Type": "application/json" },
      body: JSON.stringify({ code }),
    });
    const { key: waiting } = (await asked.json()) as { key: string };
    const statuses: Record<string, number> = {};
    for (const [holder, key] of Object.entries({ ...keys, code, waiting })) {
      const headers = { Authorization: `Bearer ${key}` };
      statuses[holder] = (await fetch(`${relay.origin}/api/v1/pairing`, { headers })).status;
    }
    const others = Object.fromEntries(holders.map((holder) => [holder, 404]));
    expect(statuses).toEqual({ ...others, none: 401, code: 401, waiting: 200 });
    // The key is valid for no robot until the owner accepts.
    expect((await relay.ask(robot, "/commands", { key: waiting })).status).toBe(401);
  });

  it("let the owner read the command log without being listed as a script", async () => {
    const relay = await startTestRelay();
    const robot = await relay.register();
    const own = { key: robot.ownerKey };
    const drivers = async () => {
      const held = (await (await relay.ask(robot, "", own)).json()) as { drivers: unknown };
      return held.drivers;
    };
    const nobody = await drivers();
    const log = await relay.ask(robot, "/commands", own);
    expect(log.status).toBe(200);
    expect(await log.json()).toEqual({ commands: [] });
    expect(await drivers()).toEqual(nobody);
    await relay.ask(robot, "/commands", { method: "POST", body: ACT });
    expect(await (await relay.ask(robot, "/commands/1", own)).json()).toMatchObject({ seq: 1 });
  });

  it.each([
    { role: "own", verb: "host" },
    { role: "drive", verb: "command" },
    { role: "watch", verb: "read" },
  ] as const)("a hello as $role", async ({ role, verb }) => {
    const { relay, robot, keys } = await withRobot();
    const bySocket: Partial<Record<Holder, unknown>> = {};
    const byLongPoll: Partial<Record<Holder, unknown>> = {};
    for (const holder of holders) {
      const hello = { type: "hello", version: 1, role, key: keys[holder] };
      const socket = await TestSocket.open(relay, robot.id);
      socket.send(hello);
      socket.send({ type: "resume", lastApplied: 0, fresh: true, endings: [] });
      const welcome = socket.next("welcome").then(
        () => "yes",
        async () => (await socket.closed).code,
      );
      bySocket[holder] = await welcome;
      socket.close();
      await socket.closed;
      const opened = await relay.ask(robot, "/long-poll", { method: "POST", body: hello });
      byLongPoll[holder] = opened.ok ? "yes" : opened.status;
      if (!opened.ok) continue;
      const { key } = (await opened.json()) as { key: string };
      await relay.ask(robot, "/long-poll", { method: "DELETE", key });
    }
    expect(bySocket).toEqual(expectedFor(verb, { yes: "yes", forbidden: 4403, stranger: 4401 }));
    // A hello without a key is invalid.
    const expected = expectedFor(verb, { yes: "yes", forbidden: 403, stranger: 401 });
    expect(byLongPoll).toEqual({ ...expected, none: 400 });
  });
});
