/** Commands that the network delays before they reach the relay, for each transport of scripts. */
import { TTL_MS, type Registration } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { FakeClock } from "../../../platform/testing/fake-clock.ts";
import { startTestRelay, type TestRelay } from "../../../testing/test-relay.ts";
import { TestSocket } from "../../../testing/test-socket.ts";

const TTL = 400;
const HELD_MS = 3_000;

/** Sends a command. @returns the problem's type or "accepted" */
type Send = (sentAt: number | undefined, key: string, age?: number) => Promise<string>;

interface Transport {
  name: string;
  /** Sends the script's first message, at 0 on its clock. */
  connect: (relay: TestRelay, robot: Registration) => Promise<Send>;
}

const order = (age: number) => ({ action: "left 90", ttl: TTL, age });
const hello = (robot: Registration) => ({
  type: "hello",
  version: 1,
  role: "drive",
  key: robot.driverKey,
  sentAt: 0,
});
const command = (sentAt: number | undefined, key: string, age: number) => ({
  type: "command",
  key,
  ...(sentAt !== undefined && { sentAt }),
  command: order(age),
});

/** @param answer an `ack` or `problem` */
function outcome(answer: { type: string; [field: string]: unknown } | undefined): string {
  if (answer?.type === "ack") return "accepted";
  return (answer?.["problem"] as { type: string } | undefined)?.type ?? "no answer";
}

const transports: Transport[] = [
  {
    name: "WebSocket",
    connect: async (relay, robot) => {
      const socket = await TestSocket.open(relay, robot.id);
      socket.send(hello(robot));
      await socket.next("welcome");
      return async (sentAt, key, age = 0) => {
        socket.send(command(sentAt, key, age));
        return outcome(await socket.next("ack", "problem"));
      };
    },
  },
  {
    name: "long-poll connection",
    connect: async (relay, robot) => {
      const opened = await relay.ask(robot, "/long-poll", { method: "POST", body: hello(robot) });
      const { key } = (await opened.json()) as { key: string };
      let first = 0;
      let after = 0;
      return async (sentAt, idempotencyKey, age = 0) => {
        first += 1;
        const body = { first, messages: [command(sentAt, idempotencyKey, age)] };
        await relay.ask(robot, "/long-poll/messages", { method: "POST", key, body });
        for (;;) {
          const path = `/long-poll/messages?after=${after}&wait=5`;
          const answer = await relay.ask(robot, path, { key });
          const fetched = (await answer.json()) as {
            first: number;
            messages: { type: string }[];
          };
          after = fetched.first + fetched.messages.length - 1;
          const reply = fetched.messages.find(({ type }) => type === "ack" || type === "problem");
          if (reply !== undefined) return outcome(reply);
        }
      };
    },
  },
  {
    name: "HTTPS",
    connect: async (relay, robot) => {
      const time = (sentAt: number | undefined): Record<string, string> =>
        sentAt === undefined ? {} : { "Script-Clock": `a-clock-1 ${sentAt}` };
      await relay.ask(robot, "/commands", { headers: time(0) });
      return async (sentAt, key, age = 0) => {
        const headers = { "Idempotency-Key": key, ...time(sentAt) };
        const answer = await relay.ask(robot, "/commands", {
          method: "POST",
          body: order(age),
          headers,
        });
        return answer.ok ? "accepted" : ((await answer.json()) as { type: string }).type;
      };
    },
  },
];

describe.each(transports)("a command by $name that was delayed before the relay", ({ connect }) => {
  async function script() {
    const clock = new FakeClock();
    const relay = await startTestRelay({ clock });
    const robot = await relay.register();
    const { socket: page } = await TestSocket.page(relay, robot);
    return { clock, page, send: await connect(relay, robot) };
  }

  it("is rejected as too late if its ttl has passed, and its key stays unused", async () => {
    const { clock, send } = await script();
    await clock.pass(HELD_MS);
    expect(await send(0, "a-key-0001")).toBe("/problems/too-late");
    expect(await send(HELD_MS, "a-key-0001")).toBe("accepted");
  });

  it("has only the rest of its ttl left", async () => {
    const { clock, page, send } = await script();
    await clock.pass(250);
    expect(await send(0, "a-key-0001", 50)).toBe("accepted");
    const { remaining } = await page.next("command");
    expect(Number(remaining)).toBeGreaterThan(TTL - 305);
    expect(Number(remaining)).toBeLessThanOrEqual(TTL - 299);
  });

  it("has its full ttl if it was not delayed or has no timestamp", async () => {
    const { clock, page, send } = await script();
    await clock.pass(HELD_MS);
    expect(await send(HELD_MS, "a-key-0001")).toBe("accepted");
    expect((await page.next("command"))["remaining"]).toBe(TTL);
    expect(await send(undefined, "a-key-0002")).toBe("accepted");
    expect((await page.next("command"))["remaining"]).toBe(TTL);
  });

  it("gets no extra time from a wrong clock", async () => {
    const { clock, page, send } = await script();
    await clock.pass(1_000);
    expect(await send(999_999_999_999_999, "a-key-0001")).toBe("accepted");
    expect((await page.next("command"))["remaining"]).toBe(TTL);
    expect(await send(1_000, "a-key-0002")).toBe("/problems/too-late");
  });
});

it("accepts a stop that was delayed", async () => {
  const clock = new FakeClock();
  const relay = await startTestRelay({ clock });
  const robot = await relay.register();
  const headers = { "Script-Clock": "a-clock-1 0" };
  await relay.ask(robot, "/commands", { headers });
  await clock.pass(HELD_MS);
  const stopped = await relay.ask(robot, "/commands", { method: "DELETE", headers });
  expect(stopped.status).toBe(202);
});

it.each(["7 5", "a-clock-1", "a-clock-1 -5", "a-clock-1 1e9", "a-clock-1 5 5", "a clock-1 5"])(
  "rejects the header Script-Clock: %s and names the field",
  async (text) => {
    const relay = await startTestRelay();
    const robot = await relay.register();
    const answer = await relay.ask(robot, "/commands", { headers: { "Script-Clock": text } });
    expect(answer.status).toBe(400);
    expect(await answer.json()).toMatchObject({ errors: [{ path: "Script-Clock" }] });
  },
);

describe("a stop by DELETE that was delayed before the relay", () => {
  async function script() {
    const clock = new FakeClock();
    const relay = await startTestRelay({ clock });
    const robot = await relay.register();
    const { socket: page } = await TestSocket.page(relay, robot);
    const time = { "Script-Clock": "a-clock-1 0" };
    await relay.ask(robot, "/commands", { headers: time });
    const stop = () => relay.ask(robot, "/commands", { method: "DELETE", headers: time });
    return { clock, page, stop };
  }

  it("has only the rest of its ttl left", async () => {
    const { clock, page, stop } = await script();
    await clock.pass(HELD_MS);
    expect((await stop()).status).toBe(202);
    const { remaining } = await page.next("stop");
    expect(Number(remaining)).toBeGreaterThan(TTL_MS.default - HELD_MS - 5);
    expect(Number(remaining)).toBeLessThanOrEqual(TTL_MS.default - HELD_MS + 1);
  });

  it("is rejected as too late if its ttl has passed", async () => {
    const { clock, stop } = await script();
    // A hundredth of a second more than the ttl: clocks may drift.
    await clock.pass(TTL_MS.default + 10);
    const answer = await stop();
    expect(answer.status).toBe(422);
    expect(await answer.json()).toMatchObject({ type: "/problems/too-late" });
  });
});
