/**
 * The complete remote side of a page (host, link, loop, driver), against a relay that repeats
 * messages.
 */
import type { SocketEvents, SocketPort } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { firstMaze, firstProgram } from "../protocol/first-project.ts";
import { RemoteDriver } from "../drivers/remote-driver.ts";
import { RemoteHost } from "./remote-host.ts";
import { RunLoop } from "./run-loop.ts";
import { deliveryOf } from "./testing/bench.ts";
import type { RemoteSession, RemoteView } from "../protocol/worker-messages.ts";

type Message = Record<string, unknown>;

const letters = ["A", "B", "C"];

/** Robots at a relay, which delivers every unfinished command again on each new connection. */
class Relay {
  readonly #events: SocketEvents[] = [];
  readonly #sent: Message[][] = [];
  registered = 0;
  /** status of the answer to a registration */
  status = 201;
  isReachable = true;
  /** per robot: seq of every accepted command */
  readonly accepted = new Map<string, number[]>();
  readonly received: Message[] = [];
  /** pending delays of the page before it reconnects */
  readonly pauses = new Set<() => void>();

  readonly fetch = async () => {
    if (!this.isReachable) throw new TypeError("fetch failed");
    const letter = letters[this.registered++] ?? "Z";
    const body = {
      id: letter.repeat(22),
      ownerKey: `own_${letter.repeat(22)}`,
      driverKey: `drv_${letter.repeat(22)}`,
      address: `http://localhost/r/${letter.repeat(22)}#drv_${letter.repeat(22)}`,
    };
    return { status: this.status, text: async () => JSON.stringify(body) };
  };

  readonly platform = {
    clock: {
      now: () => 0,
      after: (ms: number, call: () => void) => {
        // Only delays before reconnecting are shorter than the timeouts for an answer.
        if (ms < 10_000) this.pauses.add(call);
        return () => void this.pauses.delete(call);
      },
    },
    random: () => 0.5,
    connect: (_url: string, events: SocketEvents): SocketPort => {
      this.#events.push(events);
      const sent: Message[] = [];
      this.#sent.push(sent);
      return {
        send: (text) => {
          const message = JSON.parse(text) as Message;
          sent.push(message);
          this.received.push(message);
        },
        close: () => undefined,
        isOpen: true,
        waitingBytes: 0,
      };
    },
  };

  get lines(): number {
    return this.#events.length;
  }

  /** Accepts the newest connection and delivers what the page has not started. */
  welcome(robot: string): void {
    this.#events.at(-1)?.opened();
    this.#say({ type: "welcome", version: 1, epoch: this.lines, at: 0 });
    const [, resume] = this.#sent.at(-1) ?? [];
    for (const seq of this.accepted.get(robot) ?? []) {
      if (seq > Number(resume?.["lastApplied"])) this.#deliver(seq);
    }
  }

  accept(robot: string, seq: number): void {
    this.accepted.set(robot, [...(this.accepted.get(robot) ?? []), seq]);
    this.#deliver(seq);
  }

  /** A command is accepted and queued at the relay, which reports it to the page. */
  wait(seq: number): void {
    const { command, key, acceptedAt, ttl } = deliveryOf(seq, { action: "move", distance: 20 });
    const rest = { state: "accepted", reason: null, pose: null, distance: null, duplicate: false };
    const record = { seq, key, action: command.action, command, acceptedAt, ...rest };
    this.#say({ type: "state", record, ttl });
  }

  /** The relay has stored an ending of the page. */
  stored(seq: number): void {
    this.#say({ type: "stored", seq });
  }

  /** The delay before the page reconnects is over. */
  pauseOver(): void {
    for (const over of this.pauses) over();
  }

  cut(code: number): void {
    this.#events.at(-1)?.closed(code);
  }

  /** First message of the page on its newest connection. */
  get resume(): Message | undefined {
    return this.#sent.at(-1)?.[1];
  }

  #deliver(seq: number): void {
    this.#say({ type: "command", at: 0, ...deliveryOf(seq, { action: "move", distance: 20 }) });
  }

  #say(message: Message): void {
    this.#events.at(-1)?.received(JSON.stringify(message));
  }
}

function openPage() {
  const relay = new Relay();
  let time = 0;
  let view: RemoteView = {
    status: { kind: "off" },
    session: null,
    commands: [],
    scripts: [],
    isPaused: false,
  };
  const host: RemoteHost = new RemoteHost({
    origin: "http://localhost",
    now: () => time,
    snapshot: () => loop.snapshot(),
    onView: (newest) => (view = newest),
    onDelivery: (delivery) => loop.accept(delivery),
    cancel: (reason) => loop.cancelRemote(reason),
    cancelOne: (seq, reason) => loop.remote?.cancelOne(seq, reason),
    reset: () => loop.remote?.reset(),
    renew: (alive) => loop.remote?.renew(alive),
    fetch: relay.fetch,
    platform: relay.platform,
  });
  const loop = new RunLoop(firstMaze, firstProgram, () => time);
  loop.connect((robot) => new RemoteDriver(host, robot, () => time));
  loop.setDriver("remote");
  return {
    relay,
    host,
    loop,
    view: () => view,
    states: () => view.commands.map(({ seq, state, reason }) => [seq, state, reason]),
    /** Opens, and waits until there is a connection or an error. */
    open: async (session: RemoteSession | null): Promise<void> => {
      const { lines } = relay;
      host.open(session, false);
      await expect.poll(() => relay.lines > lines || view.status.kind === "lost").toBe(true);
    },
    drive: (milliseconds: number): void => {
      for (const end = time + milliseconds; time < end; time += 8) loop.advance();
    },
  };
}

async function openRobot() {
  const page = openPage();
  await page.open(null);
  page.relay.welcome("A");
  const { session } = page.view();
  if (session === null) throw new Error("No robot was registered.");
  return { ...page, session };
}

describe("a new key for scripts", () => {
  it("is used while the robot drives on", async () => {
    const { relay, host, view, states, drive, session } = await openRobot();
    relay.accept("A", 1);
    drive(50);
    const address = session.address.replace(/#.*/, "#drv_new");
    host.open({ ...session, driverKey: "drv_new", address }, false);
    expect(view().session).toMatchObject({ driverKey: "drv_new", address, lastApplied: 1 });
    drive(2_000);
    expect(states()).toEqual([[1, "completed", null]]);
    expect(relay.lines).toBe(1);
  });
});

describe("reconnecting after the connection was lost", () => {
  it("drives each command once and loses no ending", async () => {
    const { relay, host, view, states, drive, session } = await openRobot();
    for (const seq of [1, 2, 3]) relay.accept("A", seq);
    drive(100);
    relay.cut(1006);
    expect(view().status).toEqual({ kind: "lost", reason: "connectionLost" });
    drive(150);
    host.open({ ...session, lastApplied: 1 }, false);
    expect(relay.lines).toBe(2);
    expect(relay.pauses.size).toBe(0);
    relay.welcome("A");
    drive(5_000);
    expect(states()).toEqual([
      [3, "completed", null],
      [2, "completed", null],
      [1, "completed", null],
    ]);
    const received = (type: string) =>
      relay.received.flatMap((it) => (it["type"] === type ? it["seq"] : []));
    expect(relay.resume?.["endings"]).toMatchObject([{ seq: 1, state: "completed" }]);
    expect(received("started")).toEqual([1, 3]);
    expect(received("ended")).toEqual([2, 3]);
  });

  it("reports the connection that already exists", async () => {
    const { relay, host, view, session } = await openRobot();
    host.open(session, false);
    expect(relay.lines).toBe(1);
    expect(view().status).toEqual({ kind: "waiting" });
  });
});

describe("disconnecting while the connection is lost", () => {
  it("ends all commands, and the relay receives the endings when the page reconnects", async () => {
    const { relay, host, view, states, drive, session } = await openRobot();
    for (const seq of [1, 2]) relay.accept("A", seq);
    drive(100);
    relay.cut(1006);
    host.close();
    expect(view().status).toEqual({ kind: "off" });
    expect(states()).toEqual([
      [2, "cancelled", "disconnected"],
      [1, "cancelled", "disconnected"],
    ]);
    host.open(session, false);
    relay.welcome("A");
    const reason = "The robot's page disconnected.";
    expect(relay.resume).toMatchObject({
      lastApplied: 2,
      endings: [
        { seq: 1, state: "cancelled", reason },
        { seq: 2, state: "cancelled", reason },
      ],
    });
    relay.accept("A", 3);
    drive(1_000);
    expect(states()[0]).toEqual([3, "completed", null]);
  });
});

describe("a command that is queued at the relay when the page takes the robot", () => {
  it.each([
    { what: "is handed over", reason: "takenOver", act: (loop: RunLoop) => loop.setDriver("me") },
    { what: "is reset", reason: "reset", act: (loop: RunLoop) => loop.reset() },
  ])("never runs if the robot $what, although Remote drives when it arrives", async (row) => {
    const { relay, loop, states, drive } = await openRobot();
    relay.accept("A", 1);
    relay.wait(2);
    drive(50);
    row.act(loop);
    loop.setDriver("remote");
    relay.accept("A", 2);
    relay.accept("A", 3);
    drive(2_000);
    expect(states()).toEqual([
      [3, "completed", null],
      [2, "cancelled", row.reason],
      [1, "cancelled", row.reason],
    ]);
    const started = relay.received.filter(({ type }) => type === "started");
    expect(started.map(({ seq }) => seq)).toEqual([1, 3]);
  });

  it("never runs even if the relay reports it later, unlike later commands", async () => {
    const { relay, loop, states, drive } = await openRobot();
    relay.accept("A", 1);
    drive(50);
    loop.reset();
    relay.wait(2);
    relay.stored(1);
    relay.wait(3);
    for (const seq of [2, 3]) relay.accept("A", seq);
    drive(2_000);
    expect(states()).toEqual([
      [3, "completed", null],
      [2, "cancelled", "reset"],
      [1, "cancelled", "reset"],
    ]);
  });

  it("runs if it is reported late and the page had not taken the robot", async () => {
    const { relay, loop, states, drive } = await openRobot();
    relay.accept("A", 1);
    loop.cancelRemote("stopped");
    relay.wait(2);
    relay.stored(1);
    relay.accept("A", 2);
    drive(2_000);
    expect(states()[0]).toEqual([2, "completed", null]);
  });

  it("never runs if it was sent while Remote did not drive", async () => {
    const { relay, loop, states, drive } = await openRobot();
    loop.setDriver("me");
    relay.wait(2);
    relay.accept("A", 1);
    loop.setDriver("remote");
    relay.accept("A", 2);
    drive(2_000);
    expect(states()).toEqual([
      [2, "cancelled", "notRemote"],
      [1, "cancelled", "notRemote"],
    ]);
  });

  it("runs after a script's stop, and for another robot", async () => {
    const { relay, open, loop, states, drive } = await openRobot();
    relay.wait(2);
    loop.cancelRemote("stopped");
    relay.accept("A", 2);
    drive(2_000);
    expect(states()).toEqual([[2, "completed", null]]);
    relay.wait(5);
    loop.reset();
    await open(null);
    relay.welcome("B");
    relay.accept("B", 1);
    drive(2_000);
    expect(states()).toEqual([[1, "completed", null]]);
  });
});

describe("another robot", () => {
  it.each([
    { code: 4410, reason: "over" },
    { code: 4404, reason: "noRobot" },
    { code: 4409, reason: "replaced" },
  ])("after $reason starts with nothing of the old one", async ({ code, reason }) => {
    const { relay, open, view, states, drive } = await openRobot();
    for (const seq of [1, 2]) relay.accept("A", seq);
    drive(100);
    relay.cut(code);
    expect(view().status).toEqual({ kind: "over", reason });
    expect(states()).toEqual([
      [2, "cancelled", "addressEnded"],
      [1, "cancelled", "addressEnded"],
    ]);
    await open(null);
    relay.welcome("B");
    expect(relay.resume).toMatchObject({ lastApplied: 0, endings: [] });
    expect(states()).toEqual([]);
    drive(1_000);
    relay.accept("B", 1);
    drive(1_000);
    expect(states()).toEqual([[1, "completed", null]]);
    expect(view().session).toMatchObject({ id: "B".repeat(22), lastApplied: 1 });
  });

  it("ends the commands of the one before it while that is still connected", async () => {
    const { relay, open, drive } = await openRobot();
    relay.accept("A", 1);
    drive(100);
    await open(null);
    expect(relay.received.at(-1)).toMatchObject({ type: "ended", seq: 1, state: "cancelled" });
    relay.welcome("B");
    expect(relay.resume).toMatchObject({ lastApplied: 0, endings: [] });
  });
});

describe("a robot that is not registered", () => {
  it.each([
    { name: "nothing answers", isReachable: false, status: 0, reason: "connectionLost" },
    { name: "only files are served", isReachable: true, status: 405, reason: "noService" },
    { name: "too many were registered", isReachable: true, status: 429, reason: "tooManyRobots" },
    { name: "the service is in trouble", isReachable: true, status: 503, reason: "refused" },
  ])("shows the cause when $name", async ({ isReachable, status, reason }) => {
    const { relay, open, view } = openPage();
    Object.assign(relay, { isReachable, status });
    await open(null);
    expect(view()).toMatchObject({ status: { kind: "lost", reason }, session: null });
  });

  it("is registered without user action once the network is back", async () => {
    const { relay, open, view } = openPage();
    relay.isReachable = false;
    await open(null);
    relay.isReachable = true;
    relay.pauseOver();
    await expect.poll(() => relay.lines).toBe(1);
    relay.welcome("A");
    expect(view()).toMatchObject({ status: { kind: "waiting" }, session: { id: "A".repeat(22) } });
  });

  it("is not registered later if the user disconnected, and once if they reconnected", async () => {
    const { relay, host, open, view } = openPage();
    relay.isReachable = false;
    await open(null);
    const pauseOver = [...relay.pauses];
    host.close();
    relay.isReachable = true;
    for (const over of pauseOver) over();
    await open(null);
    relay.welcome("A");
    expect(relay.registered).toBe(1);
    expect(view().status).toEqual({ kind: "waiting" });
  });
});
