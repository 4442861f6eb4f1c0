import { snapshotOf } from "@corridor/protocol/testing";
import { describe, expect, it } from "vitest";
import { WebSocket } from "ws";
import { limits } from "../../platform/limits/limits.ts";
import { badCommands } from "../../testing/bad-commands.ts";
import { FakeClock } from "../../platform/testing/fake-clock.ts";
import { completed } from "../../platform/testing/messages.ts";
import { startTestRelay } from "../../testing/test-relay.ts";
import { TestSocket } from "../../testing/test-socket.ts";

/** The status of a rejected upgrade. */
function upgradeStatus(url: string, headers: Record<string, string> = {}): Promise<number> {
  const socket = new WebSocket(url, { headers });
  return new Promise((resolve, reject) => {
    socket.once("unexpected-response", (_request, response) => resolve(response.statusCode ?? 0));
    socket.once("open", () => reject(new Error("the socket was opened")));
    socket.once("error", () => undefined);
  });
}

describe("the WebSocket: admission", () => {
  const hello = { type: "hello", version: 1, role: "drive" };
  it.each([
    { name: "invalid JSON", frame: () => "hello", code: 4401 },
    { name: "null", frame: () => "null", code: 4401 },
    { name: "a message other than hello", frame: () => '{"type":"command"}', code: 4401 },
    {
      name: "another version",
      frame: (key: string) => JSON.stringify({ ...hello, version: 2, key }),
      code: 4401,
    },
    {
      name: "an unknown key",
      frame: () => JSON.stringify({ ...hello, key: "drv_nobody" }),
      code: 4401,
    },
    {
      name: "more than 1 KiB",
      frame: (key: string) => JSON.stringify({ ...hello, key }) + " ".repeat(1024),
      code: 4401,
    },
    {
      name: "a driver key for the page role",
      frame: (key: string) => JSON.stringify({ ...hello, role: "own", key }),
      code: 4403,
    },
    { name: "a binary message", frame: () => new Uint8Array([1, 2, 3]), code: 4400 },
    { name: "more than 16 KiB", frame: () => "x".repeat(17_000), code: 1009 },
  ])("is closed if the first message is $name", async ({ frame, code }) => {
    const relay = await startTestRelay();
    const robot = await relay.register();
    const socket = await TestSocket.open(relay, robot.id);
    socket.sendRaw(frame(robot.driverKey));
    const closed = await socket.closed;
    expect(closed.code).toBe(code);
    await TestSocket.driver(relay, robot);
  });

  it("is closed if the robot does not exist", async () => {
    const relay = await startTestRelay();
    const socket = await TestSocket.open(relay, "AAAAAAAAAAAAAAAAAAAAAA");
    socket.send({ ...hello, key: "drv_AAAAAAAAAAAAAAAAAAAAAA" });
    expect(await socket.closed).toMatchObject({
      code: 4404,
      reason: expect.stringContaining("no robot"),
    });
  });

  it("is closed if no message arrives within five seconds", async () => {
    const clock = new FakeClock();
    const relay = await startTestRelay({ clock });
    const robot = await relay.register();
    const socket = await TestSocket.open(relay, robot.id);
    await clock.pass(limits.helloMs);
    expect((await socket.closed).code).toBe(4401);
  });

  it("is rejected with an HTTP response for pages of other sites and at other paths", async () => {
    const relay = await startTestRelay();
    const robot = await relay.register();
    const base = relay.origin.replace("http", "ws");
    const url = `${base}/api/v1/robots/${robot.id}/socket`;
    expect(await upgradeStatus(url, { Origin: "https://evil.example" })).toBe(403);
    expect(await upgradeStatus(url, { Origin: "null" })).toBe(403);
    expect(await upgradeStatus(`${base}/api/v1/elsewhere`)).toBe(404);
    await TestSocket.open(relay, robot.id, { Origin: relay.origin });
  });

  it("allows four scripts per key and closes the fifth with a reason", async () => {
    const relay = await startTestRelay();
    const robot = await relay.register();
    for (let n = 0; n < 4; n++) await TestSocket.driver(relay, robot);
    const fifth = await TestSocket.open(relay, robot.id);
    fifth.send({ ...hello, key: robot.driverKey });
    expect((await fifth.closed).code).toBe(4429);
  });

  it("belongs to the page that connected last", async () => {
    const relay = await startTestRelay();
    const robot = await relay.register();
    const first = await TestSocket.page(relay, robot);
    const second = await TestSocket.page(relay, robot);
    expect((await first.socket.closed).code).toBe(4409);
    expect(second.epoch).toBe(first.epoch + 1);
  });

  it("is closed if the client does not answer pings, and stays open otherwise", async () => {
    const clock = new FakeClock();
    const relay = await startTestRelay({ clock });
    const robot = await relay.register();
    const alive = await TestSocket.driver(relay, robot);
    const dead = await TestSocket.open(relay, robot.id, {}, { autoPong: false });
    dead.send({ ...hello, key: robot.driverKey });
    await dead.next("welcome");
    for (let beat = 0; beat < 3; beat++) {
      await clock.pass(limits.heartbeatMs);
      await alive.next("heartbeat");
      // The relay has the pong after another round trip.
      alive.send({ type: "command", command: { action: "stop" } });
      await alive.next("ack");
    }
    expect((await dead.closed).code).toBe(1006);
    alive.send({ type: "command", command: { action: "stop" } });
    expect(await alive.next("ack")).toMatchObject({ record: { seq: 4 } });
  });

  it("is closed after 45 s without an answer, even if an answer arrives later", async () => {
    const clock = new FakeClock();
    const relay = await startTestRelay({ clock });
    const robot = await relay.register();
    const late = await TestSocket.open(relay, robot.id, {}, { autoPong: false });
    late.send({ ...hello, key: robot.driverKey });
    await late.next("welcome");
    await clock.pass(limits.silenceMs);
    expect((await late.closed).code).toBe(1006);
  });

  it("sends pings to idle clients only", async () => {
    const clock = new FakeClock();
    const relay = await startTestRelay({ clock });
    const script = await TestSocket.driver(relay, await relay.register());
    await clock.pass(limits.heartbeatMs - 1);
    script.send({ type: "command", command: { action: "stop" } });
    await script.next("ack");
    await clock.pass(1);
    await script.next("heartbeat");
    expect(script.pings).toBe(0);
    await clock.pass(limits.heartbeatMs);
    await script.next("heartbeat");
    expect(script.pings).toBe(1);
  });

  it("sends a ping at each heartbeat if the last message arrived shortly after the previous one", async () => {
    const clock = new FakeClock();
    const relay = await startTestRelay({ clock });
    const script = await TestSocket.driver(relay, await relay.register());
    for (let beat = 1; beat <= 3; beat++) {
      // As late as a pong over a slow connection.
      await clock.pass(200);
      script.send({ type: "command", command: { action: "stop" } });
      await script.next("ack");
      await clock.pass(limits.heartbeatMs - 200);
      await script.next("heartbeat");
      expect(script.pings).toBe(beat);
    }
  });
});

describe("the WebSocket: messages", () => {
  it("carries commands, states and snapshots between a script and the page", async () => {
    const relay = await startTestRelay();
    const robot = await relay.register();
    const { socket: page, epoch } = await TestSocket.page(relay, robot);
    const driver = await TestSocket.driver(relay, robot);
    driver.send({ type: "command", key: "a-key-0001", command: { action: "left 90" } });
    expect(await driver.next("ack")).toMatchObject({ record: { seq: 1, state: "accepted" } });
    expect(await driver.next("state")).toMatchObject({ record: { seq: 1, state: "delivered" } });
    const command = await page.next("command");
    expect(command).toMatchObject({ seq: 1, key: "a-key-0001", command: { action: "left 90" } });
    page.send({ type: "started", epoch, seq: 1 });
    expect(await driver.next("state")).toMatchObject({ record: { state: "started" } });
    page.send({ type: "snapshot", epoch, snapshot: snapshotOf({ seq: 9 }) });
    expect(await driver.next("snapshot")).toMatchObject({ snapshot: { seq: 9 } });
    page.send({ type: "ended", epoch, ...completed(1) });
    expect(await driver.next("state")).toMatchObject({ record: { state: "completed" } });
    expect(await page.next("stored")).toEqual({ type: "stored", seq: 1 });
  });

  it("reports the connected scripts to the page", async () => {
    const relay = await startTestRelay();
    const robot = await relay.register();
    const { socket: page } = await TestSocket.page(relay, robot);
    await TestSocket.driver(relay, robot);
    const seen = [
      await page.next("drivers"),
      await page.next("drivers"),
      await page.next("drivers"),
    ];
    expect(seen.at(-1)).toMatchObject({ connected: 1, client: "Python" });
  });

  it.each(badCommands.filter(({ body }) => body !== ""))(
    "answers a wrong command with a problem and goes on: $name",
    async ({ body }) => {
      const relay = await startTestRelay();
      const robot = await relay.register();
      const driver = await TestSocket.driver(relay, robot);
      driver.sendRaw(`{"type":"command","key":"a-key-0001","command":${body}}`);
      expect(await driver.next("problem")).toMatchObject({ problem: { status: 400 } });
      driver.send({ type: "command", command: { action: "stop" } });
      expect(await driver.next("ack")).toMatchObject({ record: { seq: 1 } });
    },
  );

  it("closes a script that sends only invalid messages", async () => {
    const relay = await startTestRelay();
    const robot = await relay.register();
    const driver = await TestSocket.driver(relay, robot);
    for (let n = 0; n < limits.badFrames; n++) driver.sendRaw("nonsense");
    expect((await driver.closed).code).toBe(4400);
  });

  it.each([
    { name: "null", frame: "null" },
    {
      name: "a command, which pages may not send",
      frame: { type: "command", command: { action: "stop" } },
    },
    {
      name: "a second resume",
      frame: { type: "resume", lastApplied: 0, fresh: false, endings: [] },
    },
    {
      name: "a snapshot without sensors",
      frame: { type: "snapshot", epoch: 1, snapshot: { seq: 1 } },
    },
    {
      name: "a position outside of every maze",
      frame: {
        type: "snapshot",
        epoch: 1,
        snapshot: snapshotOf({ pose: { x: 1e9, y: 0, heading: 0 } }),
      },
    },
    {
      name: "a heading of 360",
      frame: {
        type: "snapshot",
        epoch: 1,
        snapshot: snapshotOf({ pose: { x: 0, y: 0, heading: 360 } }),
      },
    },
    {
      name: "an unknown final state",
      frame: { type: "ended", epoch: 1, ...completed(1), state: "delivered" },
    },
    { name: "a command number of 0", frame: { type: "started", epoch: 1, seq: 0 } },
    { name: "a huge command number", frame: { type: "started", epoch: 1, seq: 1e300 } },
  ])("closes a page that sends $name, and lets it reconnect", async ({ frame }) => {
    const relay = await startTestRelay();
    const robot = await relay.register();
    const { socket } = await TestSocket.page(relay, robot);
    socket.send(frame);
    expect((await socket.closed).code).toBe(4400);
    await TestSocket.page(relay, robot);
  });

  it("ignores reports about commands that the page never received", async () => {
    const relay = await startTestRelay();
    const robot = await relay.register();
    const { socket, epoch } = await TestSocket.page(relay, robot);
    socket.send({ type: "started", epoch, seq: 77 });
    socket.send({ type: "ended", epoch, ...completed(77) });
    expect(await socket.next("stored")).toEqual({ type: "stored", seq: 77 });
    expect((await relay.ask(robot, "/commands/77")).status).toBe(404);
  });

  it("is closed with 1012 when the relay shuts down", async () => {
    const relay = await startTestRelay();
    const robot = await relay.register();
    const { socket } = await TestSocket.page(relay, robot);
    await relay.close();
    expect((await socket.closed).code).toBe(1012);
  });
});
