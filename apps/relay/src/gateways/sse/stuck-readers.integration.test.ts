/**
 * Scripts that connect and never read. The relay closes them, and other clients are not affected.
 */
import { once } from "node:events";
import { connect, type Socket } from "node:net";
import type { Registration } from "@corridor/protocol";
import { describe, expect, it, onTestFinished } from "vitest";
import { limits } from "../../platform/limits/limits.ts";
import { FakeClock } from "../../platform/testing/fake-clock.ts";
import { startTestRelay, type TestRelay } from "../../testing/test-relay.ts";
import { TestSocket } from "../../testing/test-socket.ts";

/** Number of connected scripts, as reported to a page that connects now. */
async function connectedScripts(relay: TestRelay, robot: Registration): Promise<number> {
  const { socket } = await TestSocket.page(relay, robot);
  return Number((await socket.next("drivers"))["connected"]);
}

async function expectService(relay: TestRelay, robot: Registration): Promise<void> {
  const bystander = await TestSocket.driver(relay, robot);
  bystander.send({ type: "command", command: { action: "stop" } });
  expect(await bystander.next("ack")).toMatchObject({ record: { action: "stop" } });
}

/** Opens an event stream and reads only its head. */
async function stuckEventStream(relay: TestRelay, robot: Registration): Promise<Socket> {
  const socket = connect(Number(new URL(relay.origin).port), "127.0.0.1");
  onTestFinished(() => void socket.destroy());
  socket.on("error", () => undefined);
  socket.write(
    `GET /api/v1/robots/${robot.id}/events HTTP/1.1\r\nHost: relay\r\n` +
      `Authorization: Bearer ${robot.driverKey}\r\n\r\n`,
  );
  await once(socket, "data");
  return socket.pause();
}

describe("a client that does not read", () => {
  it("loses its event stream, and the relay keeps working", { timeout: 60_000 }, async () => {
    const clock = new FakeClock();
    const relay = await startTestRelay({ clock });
    const robot = await relay.register();
    for (let n = 0; n < 8; n++) {
      await relay.ask(robot, "/commands", {
        method: "POST",
        body: { action: "move", distance: 100 },
        headers: { "Idempotency-Key": `${n}`.repeat(64) },
      });
    }
    const stuck = await stuckEventStream(relay, robot);
    // Each new page receives the commands again, which publishes events to all readers.
    const maxPages = 3_000;
    let pages = 0;
    while (pages < maxPages && (await connectedScripts(relay, robot)) > 0) pages += 1;
    expect(pages).toBeGreaterThan(10);
    expect(pages).toBeLessThan(maxPages);
    await clock.pass(2 * limits.heartbeatMs);
    await expectService(relay, robot);
    stuck.resume();
    await once(stuck, "close");
  });

  /** Causes more responses than the socket buffers and the relay's own buffer hold. */
  async function floodUnread(relay: TestRelay, robot: Registration): Promise<TestSocket> {
    const socket = await TestSocket.driver(relay, robot);
    socket.pause();
    // The response to a retry goes to its sender only, so no command state reveals that it does not
    // read.
    const retry = { type: "command", key: "a-key-0001", command: { action: "stop" } };
    for (let batch = 0; batch < 30; batch++) {
      for (let n = 0; n < 2_000; n++) socket.send(retry);
      expect((await relay.ask(robot, "/commands")).status).toBe(200);
    }
    return socket;
  }

  it(
    "is closed with 4408, which it receives when it reads again",
    { timeout: 60_000 },
    async () => {
      const relay = await startTestRelay({ clock: new FakeClock() });
      const robot = await relay.register();
      const socket = await floodUnread(relay, robot);
      socket.resume();
      expect((await socket.closed).code).toBe(4408);
      await expectService(relay, robot);
    },
  );

  it("is dropped if it still does not read", { timeout: 60_000 }, async () => {
    const clock = new FakeClock();
    const relay = await startTestRelay({ clock });
    const robot = await relay.register();
    await floodUnread(relay, robot);
    await clock.pass(limits.closingMs);
    expect(await connectedScripts(relay, robot)).toBe(0);
    await expectService(relay, robot);
  });

  it("is closed when the relay rejects everything that it sends", async () => {
    const relay = await startTestRelay({ clock: new FakeClock() });
    const robot = await relay.register();
    const socket = await TestSocket.driver(relay, robot);
    const left = { type: "command", command: { action: "left 90" } };
    const { burst } = limits.commandRate;
    for (let n = 0; n < burst + limits.tooFastInARow - 1; n++) socket.send(left);
    socket.send({ type: "command", command: { action: "stop" } });
    for (let n = 0; n < limits.tooFastInARow; n++) socket.send(left);
    expect((await socket.closed).code).toBe(4400);
    await expectService(relay, robot);
    const log = (await (await relay.ask(robot, "/commands?after=40")).json()) as {
      commands: { action: string }[];
    };
    expect(log.commands[0]).toMatchObject({ action: "stop" });
  });
});
