/**
 * Fixture for session tests: one robot, its page and its script, at one relay with a fake clock.
 */
import { snapshotOf } from "@corridor/protocol/testing";
import { join } from "node:path";
import {
  termsOf,
  type Command,
  type CommandRecord,
  type Ending,
  type Order,
  type RelayToPage,
  type Resume,
} from "@corridor/protocol";
import { pino } from "pino";
import { onTestFinished } from "vitest";
import { SqliteStore } from "../../store/sqlite/sqlite-store.ts";
import { cutStore } from "../../store/cases/cut-store.ts";
import { FakeClock } from "../../platform/testing/fake-clock.ts";
import { testFolder } from "../../testing/test-relay.ts";
import type { PageLink } from "../page/page-link.ts";
import { SessionHub } from "../registry.ts";

/** No-op parts of a reader. */
export const deafReader = {
  door: "websocket",
  flow: { sentBytes: 0, takenBytes: 0, isProof: true, ask: () => undefined },
  began: () => undefined,
  gap: () => undefined,
  maze: () => undefined,
  over: () => undefined,
} as const;

export const LEFT: Command = { action: "left 90" };
export const waitLimit = (milliseconds: number) => ({
  milliseconds,
  signal: new AbortController().signal,
});

/** Registers a robot at a relay of its own, with a script that drives it. */
export async function withRobot() {
  const clock = new FakeClock();
  const store = new SqliteStore(join(testFolder(), "corridor.sqlite"));
  onTestFinished(() => store.close());
  const cut = cutStore(store);
  const hub = new SessionHub(cut.store, clock, pino({ level: "silent" }));
  const robot = await hub.register("10.0.0.1", "http://localhost");
  const { session, key } = await hub.authorise(robot.id, robot.driverKey, "command", {
    client: "Python",
    name: null,
  });
  const submit = async (order: Order, idempotencyKey: string | null = null) => {
    const records: CommandRecord[] = [];
    const request = { key: idempotencyKey, ...termsOf(order) };
    await session.submit(key, request, (record) => records.push(record));
    return records[0];
  };
  const states = async () =>
    (await session.commandsAfter(0)).map(({ seq, state }) => `${seq} ${state}`);
  /** The same robot at a relay that has just started. */
  const restarted = async () => {
    const anew = new SessionHub(cut.store, clock, pino({ level: "silent" }));
    const { session: again } = await anew.authorise(robot.id, robot.ownerKey, "host");
    return { clock, cut, hub: anew, robot, session: again, key, submit, states, restarted };
  };
  return { clock, cut, hub, robot, session, key, submit, states, restarted };
}

export type Robot = Awaited<ReturnType<typeof withRobot>>;

/**
 * Connects a page to the robot and records all that it receives.
 * @param isSilent whether the page ignores the request to release the robot
 */
export async function page({ session }: Robot, resume: Partial<Resume> = {}, isSilent = false) {
  const told: RelayToPage[] = [];
  const closed: number[] = [];
  let epoch = 0;
  let isOpen = true;
  const link: PageLink = {
    get isOpen() {
      return isOpen;
    },
    send: (...messages) => {
      told.push(...messages);
      if (messages.some(({ type }) => type === "yield") && !isSilent) void yielded();
    },
    close: ({ code }) => {
      isOpen = false;
      closed.push(code);
    },
  };
  const yielded = async () => session.hearPage(link, { type: "yielded", epoch });
  await session.takePage(link, {
    type: "resume",
    lastApplied: 0,
    fresh: false,
    endings: [],
    ...resume,
  });
  const welcome = told.find((message) => message.type === "welcome");
  epoch = welcome?.type === "welcome" ? welcome.epoch : 0;
  const seqs = (type: "command" | "stop") =>
    told.flatMap((message) => (message.type === type && "seq" in message ? [message.seq] : []));
  return {
    told,
    closed,
    link,
    epoch,
    seqs,
    yielded,
    started: (seq: number) => session.hearPage(link, { type: "started", epoch, seq }),
    ended: (ending: Ending) => session.hearPage(link, { type: "ended", epoch, ...ending }),
    report: (change = {}) =>
      session.hearPage(link, { type: "snapshot", epoch, snapshot: snapshotOf(change) }),
  };
}

export type Host = Awaited<ReturnType<typeof page>>;
