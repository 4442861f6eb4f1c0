import { snapshotOf } from "@corridor/protocol/testing";
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { commandRecordSchema, snapshotSchema } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { FakeClock } from "../../../platform/testing/fake-clock.ts";
import { completed } from "../../../platform/testing/messages.ts";
import { startTestRelay, testFolder } from "../../../testing/test-relay.ts";
import { TestSocket } from "../../../testing/test-socket.ts";

describe("the HTTP service", () => {
  it("registers a robot and returns its address for scripts", async () => {
    const relay = await startTestRelay();
    const robot = await relay.register();
    expect(robot.address).toBe(`${relay.origin}/r/${robot.id}#${robot.driverKey}`);
    expect(robot.ownerKey).toMatch(/^own_[A-Za-z0-9_-]{22}$/);
    expect(robot.driverKey).toMatch(/^drv_[A-Za-z0-9_-]{22}$/);
  });

  it("handles a command from acceptance to completion", async () => {
    const relay = await startTestRelay();
    const robot = await relay.register();
    const { socket: page, epoch } = await TestSocket.page(relay, robot);
    const answer = await relay.ask(robot, "/commands", {
      method: "POST",
      body: { action: "move", distance: 100 },
      headers: { "Idempotency-Key": "a-key-0001" },
    });
    expect(answer.status).toBe(202);
    expect(answer.headers.get("location")).toBe(`/api/v1/robots/${robot.id}/commands/1`);
    expect(commandRecordSchema.parse(await answer.json())).toMatchObject({
      seq: 1,
      key: "a-key-0001",
      state: "accepted",
    });
    expect(await page.next("command")).toMatchObject({ seq: 1, command: { distance: 100 } });
    const waiting = relay.ask(robot, "/commands/1?wait=25");
    page.send({ type: "started", epoch, seq: 1 });
    page.send({ type: "snapshot", epoch, snapshot: snapshotOf({ seq: 5 }) });
    page.send({ type: "ended", epoch, ...completed(1) });
    const record = commandRecordSchema.parse(await (await waiting).json());
    expect(record).toMatchObject({ state: "completed", distance: 100, pose: { x: 250 } });
    const sensors = await relay.ask(robot, "/sensors");
    expect(snapshotSchema.parse(await sensors.json())).toEqual(snapshotOf({ seq: 5 }));
  });

  it("returns the first record for a retry, and rejects the key for another command", async () => {
    const relay = await startTestRelay();
    const robot = await relay.register();
    const post = (body: object) =>
      relay.ask(robot, "/commands", {
        method: "POST",
        body,
        headers: { "Idempotency-Key": "a-key-0001" },
      });
    await post({ action: "move", distance: 100 });
    const retry = await post({ distance: 100, action: "move" });
    expect(retry.status).toBe(202);
    expect(await retry.json()).toMatchObject({ seq: 1, duplicate: true });
    expect((await post({ action: "move", distance: 101 })).status).toBe(409);
  });

  it("stops the robot and discards waiting commands", async () => {
    const relay = await startTestRelay();
    const robot = await relay.register();
    const post = () =>
      relay.ask(robot, "/commands", { method: "POST", body: { action: "left 90" } });
    await post();
    await post();
    const stop = await relay.ask(robot, "/commands", { method: "DELETE" });
    expect(await stop.json()).toMatchObject({ seq: 3, action: "stop" });
    const log = (await (await relay.ask(robot, "/commands?after=1")).json()) as {
      commands: { seq: number; state: string }[];
    };
    expect(log.commands.map(({ seq, state }) => [seq, state])).toEqual([
      [2, "cancelled"],
      [3, "accepted"],
    ]);
  });

  it("accepts a command with a ttl, and rejects a retry that arrives too late", async () => {
    const clock = new FakeClock();
    const relay = await startTestRelay({ clock });
    const robot = await relay.register();
    const post = (age: number, key: string) =>
      relay.ask(robot, "/commands", {
        method: "POST",
        body: { action: "move", distance: 100, ttl: 2_000, age },
        headers: { "Idempotency-Key": key },
      });
    expect((await post(1_500, "key-0001")).status).toBe(202);
    const late = await post(2_000, "key-0002");
    expect(late.status).toBe(422);
    expect(await late.json()).toMatchObject({ type: "/problems/too-late" });
    await clock.pass(500);
    const again = await post(2_000, "key-0001");
    expect(again.status).toBe(202);
    expect(await again.json()).toMatchObject({ seq: 1, state: "expired", duplicate: true });
  });

  it("cancels one command", async () => {
    const relay = await startTestRelay();
    const robot = await relay.register();
    const post = () =>
      relay.ask(robot, "/commands", { method: "POST", body: { action: "left 90" } });
    await post();
    await post();
    const answer = await relay.ask(robot, "/commands/1", { method: "DELETE" });
    expect(answer.status).toBe(202);
    expect(await answer.json()).toMatchObject({ seq: 1, state: "cancelled" });
    expect(await (await relay.ask(robot, "/commands/2")).json()).toMatchObject({
      state: "accepted",
    });
    expect((await relay.ask(robot, "/commands/3", { method: "DELETE" })).status).toBe(404);
  });

  it("waits for the first report of a robot, and reports if there is none", async () => {
    const relay = await startTestRelay();
    const robot = await relay.register();
    expect((await relay.ask(robot, "/sensors")).status).toBe(409);
    const waiting = relay.ask(robot, "/sensors?wait=25");
    const { socket: page, epoch } = await TestSocket.page(relay, robot);
    page.send({ type: "snapshot", epoch, snapshot: snapshotOf() });
    expect(await (await waiting).json()).toEqual(snapshotOf());
  });

  it("returns the last report of a robot until the robot is deleted", async () => {
    const clock = new FakeClock();
    const relay = await startTestRelay({ clock });
    const robot = await relay.register();
    const { socket: page, epoch } = await TestSocket.page(relay, robot);
    const waiting = relay.ask(robot, "/sensors?wait=25");
    page.send({ type: "snapshot", epoch, snapshot: snapshotOf() });
    await waiting;
    page.close();
    await page.closed;
    await clock.pass(60 * 60 * 1000);
    const sensors = await relay.ask(robot, "/sensors");
    expect(await sensors.json()).toEqual({ ...snapshotOf(), state: "gone" });
    await clock.pass(3 * 60 * 60 * 1000);
    expect((await relay.ask(robot, "/sensors")).status).toBe(404);
  });

  it("lists the gateways that its operator has not switched off", async () => {
    const relay = await startTestRelay({ config: { gateways: ["ros", "soap"] } });
    const robot = await relay.register();
    const stored = await relay.ask(robot, "", { key: robot.ownerKey });
    expect(await stored.json()).toMatchObject({ gateways: ["ros", "soap"] });
  });

  it("answers excess stops with the open one or with 429", async () => {
    const relay = await startTestRelay({ clock: new FakeClock() });
    const robot = await relay.register();
    const stop = () => relay.ask(robot, "/commands", { method: "DELETE" });
    for (let n = 0; n < 20; n++) expect((await stop()).status).toBe(202);
    expect(await (await stop()).json()).toMatchObject({ seq: 20, duplicate: true });
    await relay.ask(robot, "/commands", { method: "POST", body: { action: "left 90" } });
    const refused = await stop();
    expect(refused.status).toBe(429);
    expect(refused.headers.get("retry-after")).toBe("1");
  });

  it("streams snapshots and states as server-sent events", async () => {
    const relay = await startTestRelay();
    const robot = await relay.register();
    const { socket: page, epoch } = await TestSocket.page(relay, robot);
    const stop = new AbortController();
    const stream = await relay.ask(robot, "/events", { signal: stop.signal });
    expect(stream.headers.get("content-type")).toBe("text/event-stream");
    page.send({ type: "snapshot", epoch, snapshot: snapshotOf() });
    await relay.ask(robot, "/commands", { method: "POST", body: { action: "left 90" } });
    const events: string[] = [];
    let text = "";
    for await (const chunk of stream.body ?? []) {
      text += new TextDecoder().decode(chunk);
      events.push(...(text.match(/^event: \w+\ndata: .*\n\n/gm) ?? []));
      if (events.some((event) => event.includes('"state":"delivered"'))) break;
    }
    stop.abort();
    expect(events.some((event) => event.startsWith("event: snapshot\ndata: {"))).toBe(true);
  });

  it("shows the owner the stored state, and deletes it from the files immediately", async () => {
    const dataDir = testFolder();
    const relay = await startTestRelay({ dataDir });
    const robot = await relay.register();
    const { socket: page } = await TestSocket.page(relay, robot);
    const shown = await relay.ask(robot, "", { key: robot.ownerKey });
    expect(await shown.json()).toMatchObject({ id: robot.id, snapshot: null });
    const onDisk = (): string =>
      readdirSync(dataDir)
        .map((file) => readFileSync(join(dataDir, file), "latin1"))
        .join("");
    expect(onDisk()).toContain(robot.id);
    expect(onDisk()).not.toContain(robot.driverKey);
    const deleted = await relay.ask(robot, "", { method: "DELETE", key: robot.ownerKey });
    expect(deleted.status).toBe(204);
    expect((await page.closed).code).toBe(4410);
    expect((await relay.ask(robot, "/sensors")).status).toBe(404);
    expect(onDisk()).not.toContain(robot.id);
  });

  it("retains commands and keys across a restart", async () => {
    const dataDir = testFolder();
    const first = await startTestRelay({ dataDir });
    const robot = await first.register();
    await first.ask(robot, "/commands", { method: "POST", body: { action: "left 90" } });
    await first.close();
    const second = await startTestRelay({ dataDir });
    const { socket: page } = await TestSocket.page(second, robot);
    expect(await page.next("command")).toMatchObject({ seq: 1 });
  });

  it("allows requests from pages of other sites, without cookies", async () => {
    const relay = await startTestRelay();
    const robot = await relay.register();
    const preflight = await relay.ask(robot, "/commands", { method: "OPTIONS" });
    expect(preflight.status).toBe(204);
    expect(preflight.headers.get("access-control-allow-origin")).toBe("*");
    expect(preflight.headers.get("access-control-allow-headers")).toContain("Idempotency-Key");
    expect(preflight.headers.get("access-control-allow-credentials")).toBeNull();
    const page = await fetch(relay.origin);
    expect(page.headers.get("access-control-allow-origin")).toBeNull();
  });
});

describe("the page", () => {
  function builtWeb(): string {
    const webRoot = testFolder();
    mkdirSync(join(webRoot, "dist", "assets"), { recursive: true });
    writeFileSync(join(webRoot, "dist", "index.html"), "<title>Corridor</title>");
    writeFileSync(join(webRoot, "dist", "assets", "page-1a2b.js"), "1;");
    return webRoot;
  }

  it("is served at /, at each robot's address and at each short link, under a strict policy", async () => {
    const relay = await startTestRelay({ webRoot: builtWeb() });
    for (const path of ["/", "/r/AAAAAAAAAAAAAAAAAAAAAA", "/m/AAAAAAAAAAAA", "/teach"]) {
      const answer = await fetch(relay.origin + path);
      expect(await answer.text()).toContain("Corridor");
      const policy = answer.headers.get("content-security-policy") ?? "";
      expect(policy).toContain("default-src 'self'");
      expect(policy).toContain("frame-ancestors 'none'");
      expect(policy).not.toMatch(/unsafe/);
      expect(policy).toContain("require-trusted-types-for 'script'");
      expect(policy).toMatch(/trusted-types default(?:;|$)/);
      expect(answer.headers.get("referrer-policy")).toBe("no-referrer");
    }
  });

  it("has cacheable files, and serves nothing else", async () => {
    const relay = await startTestRelay({ webRoot: builtWeb() });
    const file = await fetch(`${relay.origin}/assets/page-1a2b.js`);
    expect(file.headers.get("cache-control")).toContain("immutable");
    for (const path of ["/etc/passwd", "/../package.json", "/assets/none.js", "/unknown"]) {
      expect((await fetch(relay.origin + path)).status).toBe(404);
    }
  });

  it("explains how to build it if it has not been built", async () => {
    const relay = await startTestRelay();
    const answer = await fetch(relay.origin);
    expect(answer.status).toBe(503);
    expect(await answer.text()).toContain("npm run build");
  });
});
