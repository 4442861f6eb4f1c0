/**
 * Fixture for robot tests: one robot, its page and its script, at one relay with a fake clock.
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
import { SqliteRobotStore } from "../../store/sqlite/sqlite-robot-store.ts";
import { cutStore } from "../../store/cases/cut-store.ts";
import { FakeClock } from "../../platform/testing/fake-clock.ts";
import { testFolder } from "../../testing/test-relay.ts";
import type { PageConnection } from "../page/page-ownership.ts";
import { RobotRegistry } from "../registry.ts";

/** No-op parts of a reader. */
export const ignoringReader = {
  transport: "websocket",
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
  const store = new SqliteRobotStore(join(testFolder(), "corridor.sqlite"));
  onTestFinished(() => store.close());
  const cut = cutStore(store);
  const registry = new RobotRegistry(cut.store, clock, pino({ level: "silent" }));
  const registration = await registry.register("10.0.0.1", "http://localhost");
  const { robot, caller } = await registry.authorise(
    registration.id,
    registration.driverKey,
    "command",
    {
      client: "Python",
      name: null,
    },
  );
  const submit = async (order: Order, idempotencyKey: string | null = null) => {
    const records: CommandRecord[] = [];
    const request = { key: idempotencyKey, ...termsOf(order) };
    await robot.submit(caller, request, (record) => records.push(record));
    return records[0];
  };
  const states = async () =>
    (await robot.commandsAfter(0)).map(({ seq, state }) => `${seq} ${state}`);
  /** The same robot at a relay that has just started. */
  const restarted = async () => {
    const anew = new RobotRegistry(cut.store, clock, pino({ level: "silent" }));
    const { robot: again } = await anew.authorise(registration.id, registration.ownerKey, "host");
    return {
      clock,
      cut,
      registry: anew,
      registration,
      robot: again,
      caller,
      submit,
      states,
      restarted,
    };
  };
  return { clock, cut, registry, registration, robot, caller, submit, states, restarted };
}

export type Setup = Awaited<ReturnType<typeof withRobot>>;

/**
 * Connects a page to the robot and records all that it receives.
 * @param isSilent whether the page ignores the request to release the robot
 */
export async function page({ robot }: Setup, resume: Partial<Resume> = {}, isSilent = false) {
  const sent: RelayToPage[] = [];
  const closed: number[] = [];
  let epoch = 0;
  let isOpen = true;
  const connection: PageConnection = {
    get isOpen() {
      return isOpen;
    },
    send: (...messages) => {
      sent.push(...messages);
      if (messages.some(({ type }) => type === "yield") && !isSilent) void yielded();
    },
    close: ({ code }) => {
      isOpen = false;
      closed.push(code);
    },
  };
  const yielded = async () => robot.page.receive(connection, { type: "yielded", epoch });
  await robot.page.acquire(connection, {
    type: "resume",
    lastApplied: 0,
    fresh: false,
    endings: [],
    ...resume,
  });
  const welcome = sent.find((message) => message.type === "welcome");
  epoch = welcome?.type === "welcome" ? welcome.epoch : 0;
  const seqs = (type: "command" | "stop") =>
    sent.flatMap((message) => (message.type === type && "seq" in message ? [message.seq] : []));
  return {
    sent,
    closed,
    connection,
    epoch,
    seqs,
    yielded,
    started: (seq: number) => robot.page.receive(connection, { type: "started", epoch, seq }),
    ended: (ending: Ending) => robot.page.receive(connection, { type: "ended", epoch, ...ending }),
    report: (change = {}) =>
      robot.page.receive(connection, { type: "snapshot", epoch, snapshot: snapshotOf(change) }),
  };
}

export type Host = Awaited<ReturnType<typeof page>>;
