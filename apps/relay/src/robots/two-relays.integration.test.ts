/**
 * One robot at two relays that share a store and a message bus, in one process with a
 * fake clock.
 */
import { join } from "node:path";
import {
  closeReasons,
  termsOf,
  type CommandRecord,
  type Marks,
  type Order,
  type RelayToPage,
  type Resume,
} from "@corridor/protocol";
import { snapshotOf } from "@corridor/protocol/testing";
import { pino } from "pino";
import { describe, expect, it, onTestFinished } from "vitest";
import { LocalBus } from "../bus/local.ts";
import type { BusListener, BusMessage } from "../bus/bus.ts";
import { SqliteRobotStore } from "../store/sqlite/sqlite-robot-store.ts";
import { StoreUnavailableError } from "../platform/errors/store-unavailable.ts";
import { cutStore } from "../store/cases/cut-store.ts";
import { FakeClock, settled } from "../platform/testing/fake-clock.ts";
import { completed } from "../platform/testing/messages.ts";
import { maze } from "../platform/testing/sample-documents.ts";
import { testFolder } from "../testing/test-relay.ts";
import { limits } from "../platform/limits/limits.ts";
import { hashKey, keyId } from "../platform/keys.ts";
import { unknownScript } from "./access/callers.ts";
import type { PageConnection } from "./page/page-ownership.ts";
import { RobotRegistry } from "./registry.ts";
import type { Robot } from "./robot.ts";

const LEFT: Order = { action: "left 90" };
const waitLimit = (milliseconds: number) => ({
  milliseconds,
  signal: new AbortController().signal,
});

/** A robot with its page at the first relay and its scripts at the second. */
async function withRelays() {
  const clock = new FakeClock();
  const store = new SqliteRobotStore(join(testFolder(), "corridor.sqlite"));
  onTestFinished(() => store.close());
  const bus = new LocalBus();
  const log = pino({ level: "silent" });
  const listener: BusListener[] = [];
  const pages = new RobotRegistry(store, clock, log, {
    bus: {
      join: (registration, own) => {
        listener.push(own);
        return bus.join(registration, own);
      },
      close: () => bus.close(),
    },
  });
  const cut = cutStore(store);
  const scripts = new RobotRegistry(cut.store, clock, log, { bus });
  const registration = await pages.register("10.0.0.1", "http://localhost");
  const atPages = (await pages.authorise(registration.id, registration.ownerKey, "host")).robot;
  const page = async (robot = atPages, resume: Partial<Resume> = {}, isSilent = false) => {
    const sent: RelayToPage[] = [];
    const closed: number[] = [];
    let epoch = 0;
    const connection: PageConnection = {
      isOpen: true,
      send: (...messages) => {
        sent.push(...messages);
        if (messages.some(({ type }) => type === "yield") && !isSilent)
          void robot.page.receive(connection, { type: "yielded", epoch });
      },
      close: ({ code }) => closed.push(code),
    };
    const nothing: Resume = { type: "resume", lastApplied: 0, fresh: false, endings: [] };
    await robot.page.acquire(connection, { ...nothing, ...resume });
    const welcome = sent.find((message) => message.type === "welcome");
    epoch = welcome?.epoch ?? 0;
    return { robot, connection, sent, closed, epoch };
  };
  const host = await page();
  const { robot: atScripts, caller: key } = await scripts.authorise(
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
    await atScripts.submit(key, request, (record) => records.push(record));
    await settled();
    return records[0];
  };
  /** Records what a reader at the second relay receives. */
  const read = (): string[] => {
    const said: string[] = [];
    atScripts.readers.join(
      key,
      {
        transport: "websocket",
        flow: { sentBytes: 0, takenBytes: 0, ask: () => undefined, isProof: false },
        began: () => undefined,
        snapshot: ({ seq, state }) => said.push(`snapshot ${seq} ${state}`),
        state: ({ record }) => said.push(`${record.seq} ${record.state}`),
        gap: ({ open }) => said.push(`gap ${open.map(({ seq }) => seq).join()}`),
        maze: (version) => said.push(`maze ${version}`),
        over: (reason) => said.push(reason),
      },
      null,
    );
    return said;
  };
  return {
    clock,
    cut,
    /** A relay that shares the store, but not the message bus. */
    newRelay: () => new RobotRegistry(store, clock, log),
    /** A relay on the bus. Each robot changes right before it joins the robot's channel. */
    relayThatJoinsAfter: (change: () => Promise<unknown>) =>
      new RobotRegistry(store, clock, log, {
        bus: {
          join: async (id, own) => {
            await change();
            return bus.join(id, own);
          },
          close: () => bus.close(),
        },
      }),
    /** Delivers a message to the first relay, as its channel would. */
    notifyPages: (message: BusMessage) => listener.at(-1)?.received(message),
    bus,
    pages,
    scripts,
    registration,
    atPages,
    atScripts,
    key,
    page,
    host,
    submit,
    read,
  };
}

type Host = Awaited<ReturnType<Awaited<ReturnType<typeof withRelays>>["page"]>>;

const report = ({ robot, connection, epoch }: Host, change = {}) =>
  robot.page.receive(connection, { type: "snapshot", epoch, snapshot: snapshotOf(change) });
const seqs = ({ sent }: Host): number[] =>
  sent.flatMap((message) =>
    message.type === "command" || message.type === "stop" ? [message.seq] : [],
  );

describe("page and script at different relays", () => {
  it("delivers a command to the page and its states to the script, in order", async () => {
    const { host, submit, read, atScripts } = await withRelays();
    const said = read();
    expect(await submit(LEFT)).toMatchObject({ seq: 1, state: "accepted" });
    expect(seqs(host)).toEqual([1]);
    const { robot, connection, epoch } = host;
    await robot.page.receive(connection, { type: "started", epoch, seq: 1 });
    const end = atScripts.endOf(1, waitLimit(25_000));
    await robot.page.receive(connection, { type: "ended", epoch, ...completed(1) });
    expect(await end).toMatchObject({ seq: 1, state: "completed" });
    expect(said).toEqual(["1 delivered", "1 started", "1 completed"]);
  });

  it("shows the page commands that wait or ended at the other relay, and asks it to cancel", async () => {
    const { host, clock, submit, atScripts, key } = await withRelays();
    for (let n = 0; n < 9; n++) await submit(LEFT);
    expect(host.sent.at(-1)).toMatchObject({
      type: "state",
      record: { seq: 9, state: "accepted" },
    });
    await atScripts.cancel(key, 9);
    await clock.pass(limits.shownIntervalMs);
    expect(host.sent.findLast(({ type }) => type === "state")).toMatchObject({
      record: { seq: 9, state: "cancelled" },
    });
    await atScripts.cancel(key, 1);
    expect(host.sent.at(-1)).toEqual({ type: "cancel", seq: 1, cause: "sender" });
    await submit({ action: "stop" });
    expect(seqs(host)).toEqual([1, 2, 3, 4, 5, 6, 7, 8, 10]);
  });

  it("sends marks of a script to the page at the other relay", async () => {
    const { atScripts, host } = await withRelays();
    const marks: Marks = { fresh: true, pitch: 1, cells: [] };
    atScripts.marks.publish(marks);
    await settled();
    expect(host.sent.at(-1)).toEqual({ type: "marks", ...marks });
  });

  it("sends the newest snapshot to readers at the other relay, and reports when the page disconnects", async () => {
    const { host, clock, atScripts, read } = await withRelays();
    await clock.pass(limits.relayHereMs);
    const said = read();
    await report(host, { seq: 7 });
    expect(atScripts.newest).toMatchObject({ seq: 7, state: "running" });
    const next = atScripts.readers.nextSnapshot(7, waitLimit(25_000));
    await clock.pass(limits.snapshotIntervalMs);
    await report(host, { seq: 8, tick: 9 });
    await clock.pass(limits.snapshotIntervalMs);
    expect(await next).toMatchObject({ seq: 8 });
    host.robot.page.leave(host.connection, true);
    await clock.pass(limits.snapshotIntervalMs);
    expect(said.at(-1)).toBe("snapshot 8 gone");
    expect(atScripts.newest).toMatchObject({ state: "gone" });
  });

  it("returns the newest snapshot immediately at a relay that never held the robot", async () => {
    const { host, scripts, atScripts, registration, clock } = await withRelays();
    await report(host, { seq: 7 });
    // Nobody used the robot there for a while, so it left memory.
    await clock.pass(limits.touchMs + 2_000);
    const again = await scripts.authorise(registration.id, registration.driverKey, "command");
    expect(again.robot).not.toBe(atScripts);
    expect(again.robot.newest).toMatchObject({ seq: 7 });
  });

  it("sends readers at the other relay the newest snapshot before an ending that followed it", async () => {
    const { host, clock, submit, read } = await withRelays();
    await clock.pass(limits.relayHereMs);
    await submit(LEFT);
    const said = read();
    await report(host, { seq: 1 });
    await report(host, { seq: 2 });
    const { robot, connection, epoch } = host;
    await robot.page.receive(connection, { type: "ended", epoch, ...completed(1) });
    await settled();
    expect(said).toEqual(["snapshot 1 running", "snapshot 2 running", "1 completed"]);
  });

  it("continues the numbers of snapshots when a reloaded page connects to a relay that never held the robot", async () => {
    const { host, page, clock, registration, newRelay } = await withRelays();
    await clock.pass(30_000);
    await report(host, { seq: 900 });
    const { robot } = await newRelay().authorise(registration.id, registration.ownerKey, "host");
    const reloaded = await page(robot, { fresh: true });
    await report(reloaded, { seq: 1 });
    expect(robot.newest?.seq).toBeGreaterThan(900);
    const seq = robot.newest?.seq ?? 0;
    await report(reloaded, { seq: 2 });
    expect(robot.newest?.seq).toBe(seq + 1);
  });

  it("sends nothing to a relay that no longer holds the robot", async () => {
    const { host, clock, atScripts, bus, registration } = await withRelays();
    atScripts.leave();
    await clock.pass(limits.relaySilenceMs + 2_000);
    const received: string[] = [];
    await bus.join(registration.id, {
      commandsChanged: () => undefined,
      missed: () => undefined,
      received: ({ kind }) => received.push(kind),
    });
    await report(host, { seq: 8 });
    expect(received).toEqual(["page"]);
  });

  it("reports the scripts at all relays to the page", async () => {
    const { host, clock, atScripts, key, read } = await withRelays();
    read();
    atScripts.received(key)();
    await clock.pass(limits.driversIntervalMs);
    const drivers = host.sent.findLast(({ type }) => type === "drivers");
    expect(drivers).toMatchObject({
      connected: 1,
      client: "Python",
      alive: [{ connectionMs: 1_000 }],
    });
  });

  it("disconnects the page when another acquires the robot at the other relay, and ignores its later messages", async () => {
    const { host, atScripts, page, submit } = await withRelays();
    await submit(LEFT);
    const second = await page(atScripts);
    expect(host.closed).toEqual([closeReasons.replaced.code]);
    expect(second.epoch).toBe(host.epoch + 1);
    expect(seqs(second)).toEqual([1]);
    await host.robot.page.receive(host.connection, { type: "started", epoch: host.epoch, seq: 1 });
    expect(await atScripts.commandsAfter(0)).toMatchObject([{ seq: 1, state: "delivered" }]);
  });

  it("asks the page at the other relay what it has started before another page acquires the robot", async () => {
    const { atPages, atScripts, page, submit } = await withRelays();
    const first = await page(atPages, { page: "page-one", fresh: true });
    for (let n = 0; n < 2; n++) await submit(LEFT);
    const { robot, connection, epoch } = first;
    void robot.page.receive(connection, { type: "started", epoch, seq: 1 });
    const second = await page(atScripts, { page: "page-two", fresh: true });
    expect(first.sent.at(-1)).toEqual({ type: "yield" });
    expect(first.closed).toEqual([closeReasons.replaced.code]);
    expect(seqs(second)).toEqual([2]);
    // The same page on a new connection, at another relay, is not asked.
    const again = await page(atPages, { page: "page-two", lastApplied: 2 });
    expect(second.sent.at(-1)).not.toEqual({ type: "yield" });
    expect(await atPages.commandsAfter(1)).toMatchObject([{ seq: 2, state: "started" }]);
    expect(seqs(again)).toEqual([]);
  });

  it("delivers no command to another page that a silent page at the other relay may have started", async () => {
    const { atPages, atScripts, page, submit, clock } = await withRelays();
    await page(atPages, { page: "page-one", fresh: true }, true);
    await submit(LEFT);
    const coming = page(atScripts, { page: "page-two", fresh: true });
    await clock.pass(limits.yieldMs);
    expect(seqs(await coming)).toEqual([]);
    expect(await atScripts.commandsAfter(0)).toMatchObject([{ seq: 1, state: "cancelled" }]);
  });

  it("ends the commands of a disconnected page once, and none of a page that reconnected elsewhere", async () => {
    const { host, atScripts, page, submit, clock, read } = await withRelays();
    await submit(LEFT);
    host.robot.page.leave(host.connection, true);
    await clock.pass(limits.pageDisconnectedMs - 5_000);
    const second = await page(atScripts, { lastApplied: 1 });
    await clock.pass(20_000);
    expect(await atScripts.commandsAfter(0)).toMatchObject([{ state: "started" }]);
    const said = read();
    atScripts.page.leave(second.connection, true);
    await clock.pass(limits.pageDisconnectedMs + 5_000);
    expect(said.filter((text) => text.endsWith("cancelled"))).toEqual(["1 cancelled"]);
  });

  it("lets the page of a relay that was considered dead reconnect, and ends none of its commands", async () => {
    const { host, atScripts, page, submit, clock, notifyPages } = await withRelays();
    await submit(LEFT);
    notifyPages({ kind: "lapsed" });
    expect(host.closed).toEqual([closeReasons.restart.code]);
    const again = await page(host.robot, { lastApplied: 1 });
    await clock.pass(limits.pageDisconnectedMs + 5_000);
    expect(again.epoch).toBe(host.epoch + 1);
    expect(await atScripts.commandsAfter(0)).toMatchObject([{ seq: 1, state: "started" }]);
  });

  it("expires waiting commands after the relay that stored them has ended", async () => {
    const { host, atPages, scripts, submit, clock } = await withRelays();
    await clock.pass(1_000);
    atPages.page.leave(host.connection, true);
    await submit({ ...LEFT, ttl: 400 });
    await scripts.close();
    await clock.pass(500);
    expect(await atPages.commandsAfter(0)).toMatchObject([{ seq: 1, state: "expired" }]);
  });

  it("sends a gap and delivers waiting commands if messages between the relays were lost", async () => {
    const { host, registration, pages, atScripts, read, submit } = await withRelays();
    const said = read();
    for (const robot of [host.robot, atScripts]) robot.missedMessages();
    await settled();
    await submit(LEFT);
    expect(said).toEqual(["gap ", "1 delivered"]);
    expect(seqs(host)).toEqual([1]);
    expect((await pages.authorise(registration.id, registration.ownerKey, "host")).robot).toBe(
      host.robot,
    );
  });

  it("ends a revoked key at every relay immediately", async () => {
    const { host, scripts, registration, read, submit } = await withRelays();
    const said = read();
    await submit(LEFT);
    await host.robot.keys.make({ kind: "drive", replace: true });
    await settled();
    expect(said).toEqual(["1 delivered", "revoked"]);
    expect(host.sent.filter(({ type }) => type === "cancel")).not.toEqual([]);
    await expect(
      scripts.authorise(registration.id, registration.driverKey, "read"),
    ).rejects.toMatchObject({
      kind: "not-authorised",
    });
  });

  it("disconnects scripts within a second if the relay cannot verify their key", async () => {
    const { host, scripts, registration, read, clock, cut } = await withRelays();
    const said = read();
    cut.isCut = true;
    await host.robot.keys.make({ kind: "drive", replace: true });
    await clock.pass(1_000);
    expect(said).toEqual(["busy"]);
    const again = (): Promise<unknown> =>
      scripts
        .authorise(registration.id, registration.driverKey, "read")
        .catch((error: unknown) => error);
    expect(await again()).toBeInstanceOf(StoreUnavailableError);
    cut.isCut = false;
    await clock.pass(limits.keysRetryMs);
    expect(await again()).toMatchObject({ kind: "not-authorised" });
  });

  it("keeps scripts connected if the store recovers quickly and their key is valid", async () => {
    const { host, atScripts, key, read, clock, cut } = await withRelays();
    const said = read();
    cut.isCut = true;
    await host.robot.keys.make({ kind: "watch" });
    await clock.pass(limits.keysRetryMs);
    cut.isCut = false;
    await clock.pass(1_000);
    expect(said).toEqual([]);
    expect(() => atScripts.keys.check(key, "command")).not.toThrow();
  });

  it("forbids resets at every relay immediately, and limits them for all relays together", async () => {
    const { clock, host, atScripts, key, submit } = await withRelays();
    const reset = { action: "reset" } as const;
    await submit(reset);
    await settled();
    const viaPage = host.robot.submit.bind(host.robot);
    const second = viaPage(key, { key: null, ...termsOf(reset) }, () => undefined);
    await expect(second).rejects.toMatchObject({ kind: "too-fast" });
    await clock.pass(1_000);
    await host.robot.scriptAccess.permitReset(false);
    await settled();
    expect(atScripts.scriptAccess.mayReset).toBe(false);
    await expect(submit(reset)).rejects.toMatchObject({ kind: "reset-disabled" });
  });

  it("pauses remote driving at every relay immediately", async () => {
    const { host, atScripts, submit } = await withRelays();
    await submit(LEFT);
    await atScripts.scriptAccess.pause(true);
    await settled();
    expect(host.sent).toContainEqual({ type: "cancel", seq: 1, cause: "paused" });
    expect(host.robot.scriptAccess.isPaused).toBe(true);
    await expect(submit(LEFT)).rejects.toMatchObject({ kind: "driving-paused" });
    await host.robot.scriptAccess.pause(false);
    await settled();
    expect(await submit(LEFT)).toMatchObject({ seq: 2 });
  });

  it("notifies readers at every relay of a maze change, even if the message was lost", async () => {
    const { host, atScripts, read, cut } = await withRelays();
    const said = read();
    const first = await host.robot.mazes.keep(maze);
    expect(said).toEqual([`maze ${first}`]);
    expect(await atScripts.mazes.read()).toEqual({ text: JSON.stringify(maze), version: first });
    await host.robot.mazes.keep(maze);
    atScripts.missedMessages();
    await settled();
    const ofMazes = () => said.filter((words) => words.startsWith("maze"));
    expect(ofMazes()).toEqual([`maze ${first}`]);
    await cut.store.storeMaze(host.robot.id, "{}");
    atScripts.missedMessages();
    await settled();
    expect(ofMazes()).toHaveLength(2);
  });

  it("deletes the robot at every relay immediately", async () => {
    const { host, pages, scripts, registration, read } = await withRelays();
    const said = read();
    await pages.remove(host.robot);
    expect(said).toEqual(["over"]);
    await expect(
      scripts.authorise(registration.id, registration.driverKey, "command"),
    ).rejects.toMatchObject({
      kind: "no-robot",
    });
  });

  it.each([
    {
      change: "revokes a key",
      act: async ({ keys }: Robot) => keys.make({ kind: "drive", replace: true }),
      kind: "not-authorised",
    },
    {
      change: "blocks a script",
      act: async ({ scriptAccess }: Robot, driver: string) =>
        scriptAccess.block({ driver, ...unknownScript }),
      kind: "blocked",
    },
    {
      change: "deletes the robot",
      act: async (robot: Robot, _: string, pages: RobotRegistry) => pages.remove(robot),
      kind: "no-robot",
    },
  ])("$change at one relay while another one loads the robot", async ({ act, kind }) => {
    const { host, pages, relayThatJoinsAfter, registration } = await withRelays();
    const { id, driverKey } = registration;
    const other = relayThatJoinsAfter(async () =>
      act(host.robot, keyId(hashKey(driverKey)), pages),
    );
    await expect(other.authorise(id, driverKey, "read")).rejects.toMatchObject({ kind });
  });

  it("disconnects a client that reconnects to another relay during the deletion", async () => {
    const { host, pages, scripts, registration } = await withRelays();
    const removal = pages.remove(host.robot);
    const again = scripts.authorise(registration.id, registration.driverKey, "command");
    const reached = await again.then(
      ({ robot }) => robot,
      () => null,
    );
    await removal;
    expect(reached?.isOver ?? true).toBe(true);
  });
});
