import {
  keyListSchema,
  createdKeySchema,
  REVOKED_REASON,
  type CreatedKey,
  type Registration,
} from "@corridor/protocol";
import { snapshotOf } from "@corridor/protocol/testing";
import { describe, expect, it } from "vitest";
import { FakeClock } from "../../../platform/testing/fake-clock.ts";
import { startTestRelay, testFolder, type TestRelay } from "../../../testing/test-relay.ts";
import { TestSocket } from "../../../testing/test-socket.ts";

async function make(relay: TestRelay, robot: Registration, wanted: object): Promise<CreatedKey> {
  const request = { method: "POST", key: robot.ownerKey, body: wanted };
  const answer = await relay.ask(robot, "/keys", request);
  expect(answer.status).toBe(201);
  return createdKeySchema.parse(await answer.json());
}

async function revoke(relay: TestRelay, robot: Registration, id: string): Promise<number> {
  const request = { method: "DELETE", key: robot.ownerKey };
  return (await relay.ask(robot, `/keys/${id}`, request)).status;
}

/** Ids of the driver keys. */
async function driveKeys(relay: TestRelay, robot: Registration): Promise<string[]> {
  const answer = await relay.ask(robot, "/keys", { key: robot.ownerKey });
  const { keys } = keyListSchema.parse(await answer.json());
  return keys.flatMap(({ id, kind }) => (kind === "drive" ? [id] : []));
}

async function withRobot() {
  const relay = await startTestRelay();
  return { relay, robot: await relay.register() };
}

describe("keys of a robot", () => {
  it("are created by the owner and include the address for a script", async () => {
    const { relay, robot } = await withRobot();
    const drive = await make(relay, robot, { kind: "drive" });
    expect(drive.key).toMatch(/^drv_[A-Za-z0-9_-]{22}$/);
    expect(drive.address).toBe(`${relay.origin}/r/${robot.id}#${drive.key}`);
    const watch = await make(relay, robot, { kind: "watch" });
    expect(watch.key).toMatch(/^wch_/);
    const list = await (await relay.ask(robot, "/keys", { key: robot.ownerKey })).json();
    const { keys } = list as { keys: { id: string; kind: string }[] };
    expect(keys.map(({ kind }) => kind).toSorted()).toEqual(["drive", "drive", "own", "watch"]);
    expect(keys.map(({ id }) => id)).toContain(watch.id);
    expect(JSON.stringify(list)).not.toContain(watch.key.slice(4));
  });

  it("for URLs are accepted nowhere else, listed, and revoked alone", async () => {
    const { relay, robot } = await withRobot();
    const made = await make(relay, robot, { kind: "drive", use: "url" });
    const mcp = `${relay.origin}/r/${robot.id}/mcp/${made.key}`;
    const ros = mcp.replace("http", "ws").replace("/mcp/", "/ros/");
    expect(made).toMatchObject({ kind: "drive", address: null, urls: { ros, mcp } });
    expect(made.key).toMatch(/^url_[A-Za-z0-9_-]{22}$/);
    const refused = await relay.ask(robot, "/sensors", { key: made.key });
    expect(refused.status).toBe(401);
    expect(await refused.json()).toMatchObject({
      type: "/problems/not-authorised",
      detail: expect.stringContaining("only in the path of the URL"),
    });
    const list = async () => {
      const answer = await relay.ask(robot, "/keys", { key: robot.ownerKey });
      return keyListSchema.parse(await answer.json()).keys.filter(({ use }) => use !== null);
    };
    expect(await list()).toMatchObject([
      { id: made.id, kind: "drive", use: "url", lastUsedAt: null },
    ]);
    const script = await make(relay, robot, { kind: "drive", replace: true });
    expect(script.urls).toBeNull();
    expect(await list()).toHaveLength(1);
    const next = await make(relay, robot, { kind: "drive", use: "url", replace: made.id });
    const wrong = { kind: "drive", use: "url", replace: script.id };
    const answer = await relay.ask(robot, "/keys", {
      method: "POST",
      key: robot.ownerKey,
      body: wrong,
    });
    expect(answer.status).toBe(409);
    expect(await revoke(relay, robot, next.id)).toBe(204);
    expect(await list()).toEqual([]);
    expect(await driveKeys(relay, robot)).toEqual([script.id]);
  });

  it("include when they were created and last used, without a write for each message", async () => {
    const clock = new FakeClock();
    const dataDir = testFolder();
    const relay = await startTestRelay({ clock, dataDir });
    const robot = await relay.register();
    const began = clock.now();
    const list = async (from = relay) => {
      const answer = await from.ask(robot, "/keys", { key: robot.ownerKey });
      const { keys } = keyListSchema.parse(await answer.json());
      return keys
        .filter(({ kind }) => kind !== "own")
        .map(({ id, createdAt, lastUsedAt }) => ({
          id,
          createdAt: (Date.parse(createdAt) - began) / 1_000,
          lastUsedAt: lastUsedAt && (Date.parse(lastUsedAt) - began) / 1_000,
        }));
    };
    await clock.pass(10_000);
    const made = await make(relay, robot, { kind: "watch" });
    const [drive] = (await list()).filter(({ id }) => id !== made.id);
    expect(drive).toMatchObject({ createdAt: 0, lastUsedAt: null });
    expect(await list()).toContainEqual({ id: made.id, createdAt: 10, lastUsedAt: null });
    await clock.pass(10_000);
    await relay.ask(robot, "/sensors", { key: made.key });
    await clock.pass(1_000);
    await relay.ask(robot, "/sensors", { key: made.key });
    expect(await list()).toContainEqual({ id: made.id, createdAt: 10, lastUsedAt: 21 });
    await relay.close();
    // The first use is stored within a second, the next one after a minute.
    const again = await startTestRelay({ clock, dataDir });
    expect(await list(again)).toContainEqual({ id: made.id, createdAt: 10, lastUsedAt: 20 });
    await clock.pass(60_000);
    await again.ask(robot, "/sensors", { key: made.key });
    await clock.pass(1_000);
    await again.close();
    const last = await startTestRelay({ clock, dataDir });
    expect(await list(last)).toContainEqual({ id: made.id, createdAt: 10, lastUsedAt: 81 });
  });

  it("remain valid after a restart of the relay, and revoked keys remain invalid", async () => {
    const dataDir = testFolder();
    const before = await startTestRelay({ dataDir });
    const robot = await before.register();
    const stored = await make(before, robot, { kind: "drive" });
    const gone = await make(before, robot, { kind: "drive" });
    expect(await revoke(before, robot, gone.id)).toBe(204);
    await before.close();
    const after = await startTestRelay({ dataDir });
    expect((await after.ask(robot, "/commands", { key: stored.key })).status).toBe(200);
    expect((await after.ask(robot, "/commands", { key: gone.key })).status).toBe(401);
  });

  it("are limited to a dozen, and the owner key cannot be revoked", async () => {
    const { relay, robot } = await withRobot();
    for (let count = 2; count < 12; count++) await make(relay, robot, { kind: "watch" });
    const request = { method: "POST", key: robot.ownerKey, body: { kind: "drive" } };
    const refused = await relay.ask(robot, "/keys", request);
    expect(refused.status).toBe(409);
    expect(await refused.json()).toMatchObject({ type: "/problems/too-many-keys" });
    const { keys } = (await (await relay.ask(robot, "/keys", { key: robot.ownerKey })).json()) as {
      keys: { id: string; kind: string }[];
    };
    const own = keys.find(({ kind }) => kind === "own")?.id ?? "";
    expect(await revoke(relay, robot, own)).toBe(403);
    expect(await revoke(relay, robot, "______")).toBe(404);
    // The limit does not prevent the replacement of an old key.
    await make(relay, robot, { kind: "drive", replace: true });
  });

  it("let a watcher read everything without being listed as a script", async () => {
    const { relay, robot } = await withRobot();
    const { socket: page, epoch } = await TestSocket.page(relay, robot);
    const { key } = await make(relay, robot, { kind: "watch" });
    const watcher = await TestSocket.open(relay, robot.id);
    watcher.send({ type: "hello", version: 1, role: "watch", key });
    await watcher.next("welcome");
    page.send({ type: "snapshot", epoch, snapshot: snapshotOf({ seq: 5 }) });
    expect(await watcher.next("snapshot")).toMatchObject({ snapshot: { seq: 5 } });
    await relay.ask(robot, "/commands", { method: "POST", body: { action: "left 90" } });
    expect(await watcher.next("state")).toMatchObject({ record: { seq: 1 } });
    const held = await relay.ask(robot, "", { key: robot.ownerKey });
    expect(await held.json()).toMatchObject({ drivers: { connected: 0 } });
  });

  it("close the connection of a watcher that sends commands", async () => {
    const { relay, robot } = await withRobot();
    const { key } = await make(relay, robot, { kind: "watch" });
    const watcher = await TestSocket.open(relay, robot.id);
    watcher.send({ type: "hello", version: 1, role: "watch", key });
    await watcher.next("welcome");
    watcher.send({ type: "command", command: { action: "left 90" } });
    expect((await watcher.closed).code).toBe(4403);
    expect(await (await relay.ask(robot, "/commands")).json()).toEqual({ commands: [] });
  });

  it("allow more watchers than scripts per key, and watchers do not block scripts", async () => {
    const { relay, robot } = await withRobot();
    const { key } = await make(relay, robot, { kind: "watch" });
    const look = async () => {
      const watcher = await TestSocket.open(relay, robot.id);
      watcher.send({ type: "hello", version: 1, role: "watch", key });
      return watcher;
    };
    const watchers = await Promise.all(Array.from({ length: 60 }, look));
    for (const watcher of watchers) await watcher.next("welcome");
    expect((await (await look()).closed).code).toBe(4429);
    await TestSocket.driver(relay, robot);
  });
});

describe("a new driver key", () => {
  it("closes all connections and waiting requests of the old key immediately", async () => {
    const { relay, robot } = await withRobot();
    const { socket: page, epoch } = await TestSocket.page(relay, robot);
    page.send({ type: "snapshot", epoch, snapshot: snapshotOf({ seq: 5 }) });
    const script = await TestSocket.driver(relay, robot);
    const hello = { type: "hello", version: 1, role: "drive", key: robot.driverKey };
    const opened = await relay.ask(robot, "/long-poll", { method: "POST", body: hello });
    const { key } = (await opened.json()) as { key: string };
    const stream = await relay.ask(robot, "/events");
    const streamed = stream.text();
    const sensors = relay.ask(robot, "/sensors?after=99&wait=25");
    const states = relay.ask(robot, "/events?since=AAAAAAAA-0&wait=25");
    await states;
    // Started before the key is replaced.
    await relay.ask(robot, "/sensors");
    const made = await make(relay, robot, { kind: "drive", replace: true });

    const { code, reason } = await script.closed;
    expect(code).toBe(4401);
    expect(reason).toContain("was revoked");
    expect((await sensors).status).toBe(401);
    expect(await streamed).toContain("event: snapshot");
    const fetched = await relay.ask(robot, "/long-poll/messages?after=1", { key });
    expect(await fetched.json()).toMatchObject({ closed: { code: 4401 } });
    expect((await relay.ask(robot, "/commands")).status).toBe(401);
    expect((await relay.ask(robot, "/commands", { key: made.key })).status).toBe(200);
    // The page is not affected.
    await relay.ask(robot, "/commands", {
      method: "POST",
      key: made.key,
      body: { action: "left 90" },
    });
    expect(await page.next("command")).toMatchObject({ seq: 1 });
  });

  it("replaces one key, while scripts with other keys continue", async () => {
    const { relay, robot } = await withRobot();
    const [first] = await driveKeys(relay, robot);
    const paired = await make(relay, robot, { kind: "drive" });
    const replaced = await TestSocket.driver(relay, robot);
    const stored = await TestSocket.driver(relay, { ...robot, driverKey: paired.key });
    const made = await make(relay, robot, { kind: "drive", replace: first });
    expect((await replaced.closed).code).toBe(4401);
    expect((await driveKeys(relay, robot)).toSorted()).toEqual([made.id, paired.id].toSorted());
    expect((await relay.ask(robot, "/commands")).status).toBe(401);
    stored.send({ type: "command", command: { action: "left 90" } });
    expect(await stored.next("ack")).toMatchObject({ record: { seq: 1 } });
  });

  it.each([
    { what: "the id of no key", replace: async () => "______" },
    {
      what: "the id of a key of another kind",
      replace: async (relay: TestRelay, robot: Registration) =>
        (await make(relay, robot, { kind: "watch" })).id,
    },
  ])("is not created in place of $what", async ({ replace }) => {
    const { relay, robot } = await withRobot();
    const wanted = { kind: "drive", replace: await replace(relay, robot) };
    const request = { method: "POST", key: robot.ownerKey, body: wanted };
    const refused = await relay.ask(robot, "/keys", request);
    expect(refused.status).toBe(409);
    expect(await refused.json()).toMatchObject({ type: "/problems/nothing-to-replace" });
    expect(await driveKeys(relay, robot)).toHaveLength(1);
  });

  it.each([
    { replace: 7, expected: "true, false or the 6 characters of a key's id" },
    { replace: "all of them", expected: "the 6 characters of a key's id" },
  ])(
    "rejects an invalid `replace` with an explanation: $replace",
    async ({ replace, expected }) => {
      const { relay, robot } = await withRobot();
      const request = { method: "POST", key: robot.ownerKey, body: { kind: "drive", replace } };
      const refused = await relay.ask(robot, "/keys", request);
      expect(refused.status).toBe(400);
      const errors = [{ path: "replace", found: JSON.stringify(replace), expected }];
      expect(await refused.json()).toMatchObject({ errors });
    },
  );

  it("ends the open commands of the old key", async () => {
    const { relay, robot } = await withRobot();
    const { socket: page, epoch } = await TestSocket.page(relay, robot);
    const other = await make(relay, robot, { kind: "drive" });
    for (let count = 0; count < 10; count++) {
      await relay.ask(robot, "/commands", { method: "POST", body: { action: "left 90" } });
    }
    page.send({ type: "started", epoch, seq: 1 });
    const stop = { method: "POST", key: other.key, body: { action: "right 90" } };
    await relay.ask(robot, "/commands", stop);
    const { keys } = (await (await relay.ask(robot, "/keys", { key: robot.ownerKey })).json()) as {
      keys: { id: string; kind: string }[];
    };
    const mine = keys.find(({ id, kind }) => kind === "drive" && id !== other.id)?.id ?? "";
    expect(await revoke(relay, robot, mine)).toBe(204);
    // The robot ends the commands that it has received.
    expect(await page.next("cancel")).toMatchObject({ seq: 1 });
    const waited = await relay.ask(robot, "/commands/10?wait=5", { key: other.key });
    expect(await waited.json()).toMatchObject({
      state: "cancelled",
      reason: REVOKED_REASON,
    });
    const stored = await relay.ask(robot, "/commands/11", { key: other.key });
    expect((await stored.json()) as object).not.toMatchObject({ state: "cancelled" });
  });
});
