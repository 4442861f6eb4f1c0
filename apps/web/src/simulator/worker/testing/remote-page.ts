/** The complete remote side of a page in tests, at a relay that repeats messages. */
import type { SocketEvents, SocketPort } from "@corridor/protocol";
import { expect } from "vitest";
import { RemoteDriver } from "../../drivers/remote-driver.ts";
import { firstMaze, firstProgram } from "../../protocol/first-project.ts";
import type { RemoteSession, RemoteView } from "../../protocol/worker-messages.ts";
import { RemoteHost } from "../remote-host.ts";
import { RunLoop } from "../run-loop.ts";
import { deliveryOf } from "./bench.ts";

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

/** A page whose robot is not registered yet, and whose driver is Remote. */
export function openPage() {
  const relay = new Relay();
  let time = 0;
  let view: RemoteView = {
    status: { kind: "off" },
    session: null,
    commands: [],
    scripts: [],
    isPaused: false,
    mayReset: true,
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

/** A page with a connected robot. */
export async function openRobot() {
  const page = openPage();
  await page.open(null);
  page.relay.welcome("A");
  const { session } = page.view();
  if (session === null) throw new Error("No robot was registered.");
  return { ...page, session };
}
