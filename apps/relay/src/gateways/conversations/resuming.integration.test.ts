/**
 * Readers that reconnect, on each transport and across a restart, and one whose socket is not read.
 */
import { eventPageSchema, type EventPage, type Registration } from "@corridor/protocol";
import { snapshotOf } from "@corridor/protocol/testing";
import { once } from "node:events";
import { connect } from "node:net";
import { describe, expect, it, onTestFinished } from "vitest";
import { FakeClock } from "../../platform/testing/fake-clock.ts";
import { limits } from "../../platform/limits/limits.ts";
import { completed } from "../../platform/testing/messages.ts";
import { startTestRelay, testFolder, type TestRelay } from "../../testing/test-relay.ts";
import { TestSocket, type Message } from "../../testing/test-socket.ts";

const LEFT = { action: "left 90" };

async function send(relay: TestRelay, robot: Registration, times = 1): Promise<void> {
  for (let n = 0; n < times; n++) {
    const answer = await relay.ask(robot, "/commands", { method: "POST", body: LEFT });
    expect(answer.status).toBe(202);
  }
}

async function reconnect(relay: TestRelay, robot: Registration, since: string) {
  const socket = await TestSocket.open(relay, robot.id);
  socket.send({ type: "hello", version: 1, role: "drive", key: robot.driverKey, since });
  return { socket, welcome: await socket.next("welcome") };
}

function sinceOf(welcome: Message, n: unknown = welcome["n"]): string {
  return `${String(welcome["stream"])}-${String(n)}`;
}

describe("a script that reconnects by WebSocket", () => {
  it("receives the events of the time while it was disconnected", async () => {
    const relay = await startTestRelay();
    const robot = await relay.register();
    const { socket: page, epoch } = await TestSocket.page(relay, robot);
    const first = await TestSocket.open(relay, robot.id);
    first.send({ type: "hello", version: 1, role: "drive", key: robot.driverKey });
    const welcome = await first.next("welcome");
    await send(relay, robot);
    const state = await first.next("state");
    first.close();
    await first.closed;
    page.send({ type: "started", epoch, seq: 1 });
    page.send({ type: "ended", epoch, ...completed(1) });
    await page.next("stored");
    const { socket } = await reconnect(relay, robot, sinceOf(welcome, state["n"]));
    expect(await socket.next("state")).toMatchObject({ n: 2, record: { state: "started" } });
    expect(await socket.next("state")).toMatchObject({ n: 3, record: { state: "completed" } });
  });

  it("receives a gap with the open commands after a restart of the relay", async () => {
    const dataDir = testFolder();
    const first = await startTestRelay({ dataDir });
    const robot = await first.register();
    await send(first, robot, 2);
    const before = await reconnect(first, robot, "00000000-0");
    await first.close();
    const relay = await startTestRelay({ dataDir });
    const { socket, welcome } = await reconnect(relay, robot, sinceOf(before.welcome, 0));
    expect(welcome["n"]).toBeNull();
    expect(await socket.next("gap")).toEqual({
      type: "gap",
      n: 0,
      open: [
        { seq: 1, state: "accepted" },
        { seq: 2, state: "accepted" },
      ],
    });
    await TestSocket.page(relay, robot);
    expect(await socket.next("state")).toMatchObject({ n: 1, record: { state: "delivered" } });
  });
});

describe("a script that reads events by long polling", () => {
  async function poll(relay: TestRelay, robot: Registration, query: string): Promise<EventPage> {
    const answer = await relay.ask(robot, `/events?wait=25${query}`);
    expect(answer.status).toBe(200);
    return eventPageSchema.parse(await answer.json());
  }

  it("misses no event between two responses, and waits if there is none", async () => {
    const relay = await startTestRelay();
    const robot = await relay.register();
    const { socket: page, epoch } = await TestSocket.page(relay, robot);
    const start = await poll(relay, robot, "");
    expect(start).toMatchObject({ gap: null, states: [], snapshot: null });
    const waiting = poll(relay, robot, `&since=${start.since}`);
    await send(relay, robot);
    const delivered = await waiting;
    expect(delivered.states.map(({ record }) => record.state)).toEqual(["delivered"]);
    page.send({ type: "started", epoch, seq: 1 });
    page.send({ type: "snapshot", epoch, snapshot: snapshotOf({ seq: 4 }) });
    page.send({ type: "ended", epoch, ...completed(1) });
    await page.next("stored");
    const ended = await poll(relay, robot, `&since=${delivered.since}`);
    expect(ended.states.map(({ n, record }) => `${n} ${record.state}`)).toEqual([
      "2 started",
      "3 completed",
    ]);
    expect(ended.snapshot).toMatchObject({ seq: 4 });
    const newer = poll(relay, robot, `&since=${ended.since}&after=4`);
    page.send({ type: "snapshot", epoch, snapshot: snapshotOf({ seq: 5 }) });
    expect(await newer).toMatchObject({ states: [], snapshot: { seq: 5 } });
  });

  it("receives a gap if it resumes with a position of another relay", async () => {
    const relay = await startTestRelay();
    const robot = await relay.register();
    await send(relay, robot);
    const page = await poll(relay, robot, "&since=00000000-7");
    expect(page.gap).toEqual({ n: 0, open: [{ seq: 1, state: "accepted" }] });
    expect(page.states).toEqual([]);
  });

  it.each(["since=7", "since=abc", "wait=26", "wait=1&after=-1"])(
    "receives an error that explains %s",
    async (query) => {
      const relay = await startTestRelay();
      const robot = await relay.register();
      const answer = await relay.ask(robot, `/events?${query}`);
      expect(answer.status).toBe(400);
      expect(await answer.json()).toMatchObject({ errors: [{ expected: expect.any(String) }] });
    },
  );
});

describe("a script that reads server-sent events", () => {
  /** Reads the stream until it contains `until`. */
  async function read(answer: Response, until: string): Promise<string> {
    let text = "";
    const decoder = new TextDecoder();
    for await (const part of answer.body ?? []) {
      text += decoder.decode(part as Uint8Array, { stream: true });
      if (text.includes(until)) break;
    }
    return text;
  }

  it("resumes after its Last-Event-ID, as browsers do automatically", async () => {
    const relay = await startTestRelay();
    const robot = await relay.register();
    await TestSocket.page(relay, robot);
    const first = await relay.ask(robot, "/events");
    const head = await read(first, "id: ");
    const id = /id: (\S+)/.exec(head)?.[1] ?? "";
    await send(relay, robot, 2);
    const again = await relay.ask(robot, "/events", { headers: { "Last-Event-ID": id } });
    const stream = id.split("-")[0];
    const text = await read(again, `${stream}-2`);
    expect(text).toContain(`id: ${stream}-1\nevent: state\n`);
    const lost = await relay.ask(robot, "/events", { headers: { "Last-Event-ID": "zzzzzzzz-1" } });
    expect(await read(lost, "event: gap")).toContain(`id: ${stream}-2\nevent: gap`);
  });
});

describe("a script that does not read its socket for a while", () => {
  it(
    "finds at most 64 KiB buffered, and then the newest snapshot",
    { timeout: 120_000 },
    async () => {
      const clock = new FakeClock();
      const relay = await startTestRelay({ clock });
      const robot = await relay.register();
      const { socket: page, epoch } = await TestSocket.page(relay, robot);
      let bytes = 0;
      let text = "";
      const raw = connect(Number(new URL(relay.origin).port), "127.0.0.1");
      onTestFinished(() => void raw.destroy());
      raw.on("data", (data: Buffer) => {
        bytes += data.length;
        text += data.toString("latin1");
      });
      raw.write(
        `GET /api/v1/robots/${robot.id}/socket HTTP/1.1\r\nHost: relay\r\nConnection: Upgrade\r\n` +
          "Upgrade: websocket\r\nSec-WebSocket-Version: 13\r\nSec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\n\r\n",
      );
      const hello = { type: "hello", version: 1, role: "drive", key: robot.driverKey };
      // With a mask of zero, the payload of a frame equals its text.
      const payload = Buffer.from(JSON.stringify(hello));
      raw.write(Buffer.concat([Buffer.from([0x81, 0x80 | payload.length, 0, 0, 0, 0]), payload]));
      while (!text.includes("welcome")) await once(raw, "data");
      raw.pause();
      bytes = 0;
      for (let seq = 1; seq <= 1_200; seq++) {
        page.send({ type: "snapshot", epoch, snapshot: snapshotOf({ seq, tick: seq }) });
        if (seq % 10 === 0)
          await relay.ask(robot, "/commands", { method: "POST", body: { action: "stop" } });
        if (seq % 10 === 0) await clock.pass(limits.snapshotIntervalMs * 4);
      }
      const states = await relay.ask(robot, "/commands");
      expect(((await states.json()) as { commands: unknown[] }).commands.length).toBeGreaterThan(
        50,
      );
      raw.resume();
      while (!text.includes('"seq":2,')) await once(raw, "data");
      // All that was buffered arrives before this.
      await relay.ask(robot, "/commands", { method: "POST", body: { action: "left 90" } });
      while (!text.includes("left 90")) await once(raw, "data");
      expect(bytes).toBeLessThan(64 * 1024);
      expect(text.split('"type":"snapshot"').length - 1).toBeLessThan(10);
    },
  );
});
