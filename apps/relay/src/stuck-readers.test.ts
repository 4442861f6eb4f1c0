/** Scripts that connect and never read: they are sent away, and nobody else notices. */
import { once } from "node:events";
import { connect, type Socket } from "node:net";
import type { Registration } from "@corridor/protocol";
import { describe, expect, it, onTestFinished } from "vitest";
import { limits } from "./sessions/limits.ts";
import { FakeClock } from "./testing/fake-clock.ts";
import { startTestRelay, type TestRelay } from "./testing/test-relay.ts";
import { TestSocket } from "./testing/test-socket.ts";

/** Connected scripts, as a page that comes now is told. */
async function connectedScripts(relay: TestRelay, robot: Registration): Promise<number> {
  const { socket } = await TestSocket.page(relay, robot);
  return Number((await socket.next("drivers"))["connected"]);
}

async function expectService(relay: TestRelay, robot: Registration): Promise<void> {
  const bystander = await TestSocket.driver(relay, robot);
  bystander.send({ type: "command", command: { action: "stop" } });
  expect(await bystander.next("ack")).toMatchObject({ record: { action: "stop" } });
}

/** An event stream of which only the beginning is read. */
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

describe("a reader that does not read", () => {
  it("is cut from its event stream, and the relay lives on", { timeout: 60_000 }, async () => {
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
    // Each page that comes gets the commands anew, which is told to all who read.
    const mostPages = 3_000;
    let pages = 0;
    while (pages < mostPages && (await connectedScripts(relay, robot)) > 0) pages += 1;
    expect(pages).toBeGreaterThan(10);
    expect(pages).toBeLessThan(mostPages);
    await clock.pass(2 * limits.heartbeatMs);
    await expectService(relay, robot);
    stuck.resume();
    await once(stuck, "close");
  });

  /** Causes more answers than the lines of a machine hold, plus what the relay lets wait. */
  async function floodUnread(relay: TestRelay, robot: Registration): Promise<TestSocket> {
    const socket = await TestSocket.driver(relay, robot);
    socket.pause();
    // Of a retry only its sender hears, so that no state of a command shows that it does not read.
    const retry = { type: "command", key: "a-key-0001", command: { action: "stop" } };
    for (let batch = 0; batch < 30; batch++) {
      for (let n = 0; n < 2_000; n++) socket.send(retry);
      expect((await relay.ask(robot, "/commands")).status).toBe(200);
    }
    return socket;
  }

  it("is closed with 4408, as it learns when it reads again", { timeout: 60_000 }, async () => {
    const relay = await startTestRelay({ clock: new FakeClock() });
    const robot = await relay.register();
    const socket = await floodUnread(relay, robot);
    socket.resume();
    expect((await socket.closed).code).toBe(4408);
    await expectService(relay, robot);
  });

  it("is cut off when it goes on like that", { timeout: 60_000 }, async () => {
    const clock = new FakeClock();
    const relay = await startTestRelay({ clock });
    const robot = await relay.register();
    await floodUnread(relay, robot);
    await clock.pass(limits.goodbyeMs);
    expect(await connectedScripts(relay, robot)).toBe(0);
    await expectService(relay, robot);
  });

  it("is sent away when nothing that it sends can be taken", async () => {
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
