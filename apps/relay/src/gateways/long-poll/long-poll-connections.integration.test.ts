import { once } from "node:events";
import { request, type IncomingMessage } from "node:http";
import type { Registration } from "@corridor/protocol";
import { snapshotOf } from "@corridor/protocol/testing";
import { describe, expect, it } from "vitest";
import { limits } from "../../platform/limits/limits.ts";
import { FakeClock } from "../../platform/testing/fake-clock.ts";
import { completed } from "../../platform/testing/messages.ts";
import { startTestRelay } from "../../testing/test-relay.ts";
import { TestConnection } from "../../testing/test-connection.ts";
import { TestSocket } from "../../testing/test-socket.ts";

const RESUME = { type: "resume", lastApplied: 0, fresh: false, endings: [] };

async function withRobot(clock?: FakeClock) {
  const relay = await startTestRelay(clock === undefined ? {} : { clock });
  return { relay, robot: await relay.register() };
}

describe("a long-poll connection", () => {
  it("carries a page and a script without WebSockets", async () => {
    const { relay, robot } = await withRobot();
    const page = await TestConnection.open(relay, robot, { role: "own", key: robot.ownerKey });
    await page.send(RESUME);
    const { epoch } = await page.next("welcome");
    const script = await TestConnection.open(relay, robot, { role: "drive", key: robot.driverKey });
    await script.next("welcome");
    await script.send({ type: "command", key: "a-key-0001", command: { action: "left 90" } });
    expect(await script.next("ack")).toMatchObject({ record: { seq: 1 } });
    expect(await page.next("command")).toMatchObject({ seq: 1, key: "a-key-0001" });
    await page.send(
      { type: "started", epoch, seq: 1 },
      { type: "snapshot", epoch, snapshot: snapshotOf({ seq: 7 }) },
      { type: "ended", epoch, ...completed(1) },
    );
    expect(await script.next("snapshot")).toMatchObject({ snapshot: { seq: 7 } });
    const states = [await script.next("state"), await script.next("state")];
    expect(states).toMatchObject([
      { record: { state: "started" } },
      { record: { state: "completed" } },
    ]);
    expect(await page.next("stored")).toEqual({ type: "stored", seq: 1 });
  });

  it("processes a repeated message once, and reports missing ones", async () => {
    const { relay, robot } = await withRobot();
    const script = await TestConnection.open(relay, robot, { role: "drive", key: robot.driverKey });
    const stop = { type: "command", command: { action: "stop" } };
    expect(await script.post({ first: 1, messages: [stop, stop] })).toEqual({ taken: 2 });
    expect(await script.post({ first: 1, messages: [stop, stop] })).toEqual({ taken: 2 });
    expect(await script.post({ first: 2, messages: [stop, stop] })).toEqual({ taken: 3 });
    expect(await script.post({ first: 9, messages: [stop] })).toEqual({ taken: 3 });
    for (const seq of [1, 2, 3])
      expect(await script.next("ack")).toMatchObject({ record: { seq } });
    const log = (await (await relay.ask(robot, "/commands")).json()) as { commands: unknown[] };
    expect(log.commands).toHaveLength(3);
  });

  it("numbers commands that a page receives in one response separately", async () => {
    const { relay, robot } = await withRobot();
    for (let n = 0; n < 3; n++) {
      await relay.ask(robot, "/commands", { method: "POST", body: { action: "left 90" } });
    }
    const page = await TestConnection.open(relay, robot, { role: "own", key: robot.ownerKey });
    await page.send(RESUME);
    expect(await page.next("command")).toMatchObject({ seq: 1 });
    const rest = await page.fetch();
    expect(rest.messages).toMatchObject([
      { type: "command", seq: 2 },
      { type: "command", seq: 3 },
    ]);
    expect(await page.next("command")).toMatchObject({ seq: 2 });
    expect(await page.fetch()).toMatchObject({ first: rest.first + 1, messages: [{ seq: 3 }] });
    expect(await page.next("command")).toMatchObject({ seq: 3 });
    expect(await page.fetch(0)).toEqual({ first: rest.first + 2, messages: [], closed: null });
  });

  it("returns messages again until a request acknowledges them", async () => {
    const { relay, robot } = await withRobot();
    const script = await TestConnection.open(relay, robot, { role: "drive", key: robot.driverKey });
    const first = await script.fetch();
    expect(first.messages.map(({ type }) => type)).toEqual(["welcome"]);
    expect(await script.fetch()).toEqual(first);
    await script.next("welcome");
    expect(await script.fetch(0)).toEqual({ first: 2, messages: [], closed: null });
  });

  it("closes with a reason when another page takes over the robot", async () => {
    const { relay, robot } = await withRobot();
    const page = await TestConnection.open(relay, robot, { role: "own", key: robot.ownerKey });
    await page.send(RESUME);
    await page.next("drivers");
    await TestSocket.page(relay, robot);
    const { closed } = await page.fetch();
    expect(closed).toMatchObject({ code: 4409 });
    const sensors = await relay.ask(robot, "", { key: robot.ownerKey });
    expect(await sensors.json()).toMatchObject({ snapshot: null });
  });

  it("closes after a time without requests, and then the robot is deleted", async () => {
    const clock = new FakeClock();
    const { relay, robot } = await withRobot(clock);
    const page = await TestConnection.open(relay, robot, { role: "own", key: robot.ownerKey });
    await page.send(RESUME);
    const { epoch } = await page.next("welcome");
    await page.send({ type: "snapshot", epoch, snapshot: snapshotOf() });
    await clock.pass(limits.longPollSilenceMs);
    expect(await page.status()).toBe(404);
    const sensors = await relay.ask(robot, "/sensors");
    expect(await sensors.json()).toMatchObject({ state: "gone" });
  });

  it("closes a script that sends only invalid messages, as a WebSocket does", async () => {
    const { relay, robot } = await withRobot();
    const script = await TestConnection.open(relay, robot, { role: "drive", key: robot.driverKey });
    const nonsense = Array.from({ length: limits.badFrames }, () => ({ type: "nonsense" }));
    await script.send(...nonsense);
    await expect(script.next("heartbeat")).rejects.toThrow("4400");
  });

  it("ends with its robot and with the relay", async () => {
    const { relay, robot } = await withRobot();
    const script = await TestConnection.open(relay, robot, { role: "drive", key: robot.driverKey });
    await script.next("welcome");
    const waiting = script.fetch();
    await relay.ask(robot, "", { method: "DELETE", key: robot.ownerKey });
    expect((await waiting).closed).toMatchObject({ code: 4410 });
    const other = await relay.register();
    const connection = await TestConnection.open(relay, other, {
      role: "drive",
      key: other.driverKey,
    });
    await connection.next("welcome");
    const open = connection.fetch();
    await relay.ask(other, "/commands");
    await relay.close();
    expect((await open).closed).toMatchObject({ code: 1012 });
  });

  it("buffers snapshots for a script that does not fetch them", async () => {
    const { relay, robot } = await withRobot();
    const { socket: page, epoch } = await TestSocket.page(relay, robot);
    const script = await TestConnection.open(relay, robot, { role: "drive", key: robot.driverKey });
    await script.next("welcome");
    for (let seq = 1; seq <= 300; seq++) {
      page.send({ type: "snapshot", epoch, snapshot: snapshotOf({ seq, tick: seq }) });
      if (seq % 10 === 0) await relay.ask(robot, "/sensors");
    }
    const { messages } = await script.fetch();
    expect(messages.length).toBeLessThanOrEqual(limits.snapshotCredit);
  });

  it.each([
    { name: "a wrong key", body: { role: "drive", key: "drv_wrong" }, status: 401 },
    { name: "a script's key as a page", body: { role: "own" }, status: 403 },
    { name: "a message that is not a hello", body: { type: "resume" }, status: 400 },
    { name: "another version", body: { role: "drive", version: 2 }, status: 400 },
    {
      name: "an oversized hello",
      body: { role: "drive", more: "x".repeat(16 * 1024) },
      status: 413,
    },
  ])("is not opened with $name", async ({ body, status }) => {
    const { relay, robot } = await withRobot();
    const hello = { type: "hello", version: 1, key: robot.driverKey, ...body };
    const answer = await relay.ask(robot, "/long-poll", { method: "POST", body: hello });
    expect(answer.status).toBe(status);
  });

  it.each([
    { name: "the key of a robot", key: (robot: Registration) => robot.driverKey },
    { name: "an unknown connection key", key: () => "con_AAAAAAAAAAAAAAAAAAAAAA" },
  ])("is not reached with $name", async ({ key }) => {
    const { relay, robot } = await withRobot();
    await TestConnection.open(relay, robot, { role: "drive", key: robot.driverKey });
    const answer = await relay.ask(robot, "/long-poll/messages", { key: key(robot) });
    expect(await answer.json()).toMatchObject({ type: "/problems/no-connection", status: 404 });
  });

  it("requires its key before it reads the body", async () => {
    const { relay, robot } = await withRobot();
    const body = " ".repeat(17 * 1024);
    const sent = async (key: string) =>
      (await relay.ask(robot, "/long-poll/messages", { method: "POST", key, body })).status;
    expect(await sent("con_cut_off")).toBe(401);
    expect(await sent("con_AAAAAAAAAAAAAAAAAAAAAA")).toBe(404);
    const { key } = (await (
      await relay.ask(robot, "/long-poll", {
        method: "POST",
        body: { type: "hello", version: 1, role: "drive", key: robot.driverKey },
      })
    ).json()) as { key: string };
    expect(await sent(key)).toBe(413);
  });

  it("does not exist for a request whose body arrives after it was closed", async () => {
    const { relay, robot } = await withRobot();
    const { key } = await TestConnection.open(relay, robot, {
      role: "drive",
      key: robot.driverKey,
    });
    const body = JSON.stringify({ first: 1, messages: [{ type: "seen", seq: 1 }] });
    const sending = request(`${relay.origin}/api/v1/robots/${robot.id}/long-poll/messages`, {
      method: "POST",
      headers: {
        Authorization: `Bearer ${key}`,
        "Content-Type": "application/json",
        "Content-Length": body.length,
        Expect: "100-continue",
      },
    });
    // The relay reads the headers now, and waits for the body.
    await once(sending, "continue");
    await relay.ask(robot, "/long-poll", { method: "DELETE", key });
    sending.end(body);
    const [answer] = (await once(sending, "response")) as [IncomingMessage];
    answer.resume();
    expect(answer.statusCode).toBe(404);
  });

  it("is not accessible under another robot, and does not exist after it was closed", async () => {
    const { relay, robot } = await withRobot();
    const other = await relay.register();
    const connection = await TestConnection.open(relay, robot, {
      role: "drive",
      key: robot.driverKey,
    });
    const elsewhere = await relay.ask(other, "/long-poll/messages", { key: connection.key });
    expect(elsewhere.status).toBe(404);
    const left = await relay.ask(robot, "/long-poll", { method: "DELETE", key: connection.key });
    expect(left.status).toBe(204);
    expect(await connection.status()).toBe(404);
  });

  it.each([
    { first: 0, messages: [] },
    { first: 1, messages: [1] },
    { first: 1, messages: [null] },
    { first: 1, messages: [[]] },
    { first: 1, messages: Array.from({ length: 65 }, () => ({ type: "seen", seq: 1 })) },
    { first: 1e300, messages: [] },
    null,
    [],
  ])("explains invalid messages: %j", async (body) => {
    const { relay, robot } = await withRobot();
    const connection = await TestConnection.open(relay, robot, {
      role: "drive",
      key: robot.driverKey,
    });
    expect(await connection.post(body)).toMatchObject({
      status: 400,
      type: "/problems/bad-request",
    });
    expect(await connection.status()).toBe(200);
  });
});
