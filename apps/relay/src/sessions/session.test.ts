import { snapshotOf } from "@corridor/protocol/testing";
import { join } from "node:path";
import {
  closeReasons,
  termsOf,
  type Command,
  type CommandRecord,
  type Ending,
  type Order,
  type RelayToPage,
  type Resume,
} from "@corridor/protocol";
import { pino } from "pino";
import { describe, expect, it, onTestFinished } from "vitest";
import type { Refusal } from "../problems.ts";
import { SqliteStore } from "../store/sqlite-store.ts";
import { StoreAway } from "../store/store-away.ts";
import { cutStore } from "../testing/cut-store.ts";
import { FakeClock, settled } from "../testing/fake-clock.ts";
import { completed } from "../testing/messages.ts";
import { testFolder } from "../testing/test-relay.ts";
import { limits } from "./limits.ts";
import type { PageLink } from "./page-link.ts";
import { SessionHub } from "./session-hub.ts";

/** What a reader in a test does not listen to. */
const deafReader = {
  door: "websocket",
  flow: { sentBytes: 0, takenBytes: 0, isProof: true, ask: () => undefined },
  began: () => undefined,
  gap: () => undefined,
  over: () => undefined,
} as const;

const LEFT: Command = { action: "left 90" };
const patience = (milliseconds: number) => ({ milliseconds, signal: new AbortController().signal });

async function withRobot() {
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
  return { clock, cut, hub, robot, session, key, submit, states };
}

type Robot = Awaited<ReturnType<typeof withRobot>>;

async function page({ session }: Robot, resume: Partial<Resume> = {}) {
  const told: RelayToPage[] = [];
  const closed: number[] = [];
  const link: PageLink = {
    isOpen: true,
    send: (message) => told.push(message),
    close: ({ code }) => closed.push(code),
  };
  await session.takePage(link, {
    type: "resume",
    lastApplied: 0,
    fresh: false,
    endings: [],
    ...resume,
  });
  const welcome = told.find((message) => message.type === "welcome");
  const epoch = welcome?.type === "welcome" ? welcome.epoch : 0;
  const seqs = (type: "command" | "stop") =>
    told.flatMap((message) => (message.type === type && "seq" in message ? [message.seq] : []));
  return {
    told,
    closed,
    link,
    epoch,
    seqs,
    started: (seq: number) => session.hearPage(link, { type: "started", epoch, seq }),
    ended: (ending: Ending) => session.hearPage(link, { type: "ended", epoch, ...ending }),
    report: (change = {}) =>
      session.hearPage(link, { type: "snapshot", epoch, snapshot: snapshotOf(change) }),
  };
}

type Host = Awaited<ReturnType<typeof page>>;

describe("a robot session: delivery", () => {
  it("lets commands wait for the page, then gives it eight at a time, in order", async () => {
    const robot = await withRobot();
    for (let n = 0; n < 10; n++) await robot.submit(LEFT);
    const host = await page(robot);
    expect(host.seqs("command")).toEqual([1, 2, 3, 4, 5, 6, 7, 8]);
    await host.started(1);
    await host.ended(completed(1));
    await host.ended(completed(2));
    expect(host.seqs("command")).toEqual([1, 2, 3, 4, 5, 6, 7, 8, 9, 10]);
  });

  it("gives nothing to a page that went while it took the robot, and all to the next", async () => {
    const robot = await withRobot();
    await robot.submit(LEFT);
    const told: RelayToPage[] = [];
    let isOpen = true;
    const link: PageLink = {
      get isOpen() {
        return isOpen;
      },
      send: (message) => told.push(message),
      close: () => undefined,
    };
    const nothing: Resume = { type: "resume", lastApplied: 0, fresh: false, endings: [] };
    const taken = robot.session.takePage(link, nothing);
    isOpen = false;
    robot.session.leavePage(link);
    await taken;
    expect(robot.session.hasPage).toBe(false);
    expect(told.filter(({ type }) => type === "command")).toEqual([]);
    expect(await robot.states()).toEqual(["1 accepted"]);
    const host = await page(robot);
    expect(host.seqs("command")).toEqual([1]);
  });

  it("tells the page its time, so that the page knows what a frame was held up", async () => {
    const robot = await withRobot();
    const host = await page(robot);
    await robot.session.hearPage(host.link, { type: "time", epoch: host.epoch });
    const welcome = host.told.find(({ type }) => type === "welcome");
    expect(host.told.at(-1)).toEqual({ type: "time", at: (welcome as { at: number }).at });
  });

  it("acknowledges a command before anything else is said about it", async () => {
    const robot = await withRobot();
    await page(robot);
    const said: string[] = [];
    robot.session.join(
      robot.key,
      {
        snapshot: () => undefined,
        state: ({ record }) => said.push(record.state),
        ...deafReader,
      },
      null,
    );
    await robot.session.submit(robot.key, { key: null, ...termsOf(LEFT) }, ({ state }) =>
      said.push(`ack ${state}`),
    );
    expect(said).toEqual(["ack accepted", "delivered"]);
  });

  it("gives a page that comes back what it has not begun, and takes its endings first", async () => {
    const robot = await withRobot();
    for (let n = 0; n < 3; n++) await robot.submit(LEFT);
    const before = await page(robot);
    await before.started(1);
    robot.session.leavePage(before.link);
    const after = await page(robot, { lastApplied: 2, endings: [completed(1)] });
    expect(after.seqs("command")).toEqual([3]);
    expect(after.told).toContainEqual({ type: "stored", seq: 1 });
    expect(await robot.states()).toEqual(["1 completed", "2 started", "3 delivered"]);
  });

  it("sends the page before away, and refuses what it still says", async () => {
    const robot = await withRobot();
    await robot.submit(LEFT);
    const first = await page(robot);
    const second = await page(robot);
    expect(first.closed).toEqual([closeReasons.replaced.code]);
    expect(second.epoch).toBe(first.epoch + 1);
    await first.started(1);
    robot.session.leavePage(first.link);
    expect(await robot.states()).toEqual(["1 delivered"]);
    await robot.session.hearPage(second.link, { type: "started", epoch: first.epoch, seq: 1 });
    expect(second.closed).toEqual([closeReasons.replaced.code]);
    expect(await robot.states()).toEqual(["1 delivered"]);
  });

  it("tells the page to stop at once, past a full window", async () => {
    const robot = await withRobot();
    const host = await page(robot);
    for (let n = 0; n < 10; n++) await robot.submit(LEFT);
    await robot.submit({ action: "stop" });
    expect(host.seqs("stop")).toEqual([11]);
    expect((await robot.states()).slice(7)).toEqual([
      "8 delivered",
      "9 cancelled",
      "10 cancelled",
      "11 delivered",
    ]);
  });

  it("ends what runs once the page has been away for two minutes, and says so", async () => {
    const robot = await withRobot();
    await robot.submit(LEFT);
    const host = await page(robot);
    await host.started(1);
    robot.session.leavePage(host.link);
    await robot.clock.pass(limits.pageAwayMs - 2_000);
    expect(await robot.states()).toEqual(["1 started"]);
    await robot.clock.pass(5_000);
    expect(await robot.states()).toEqual(["1 cancelled"]);
    const late = await page(robot, { lastApplied: 1, endings: [completed(1)] });
    const { told } = late;
    expect(told.find(({ type }) => type === "refused")).toMatchObject({
      record: { seq: 1, state: "cancelled", reason: "the robot's page is gone" },
    });
    expect(told.some(({ type }) => type === "stored")).toBe(false);
    expect(await robot.states()).toEqual(["1 cancelled"]);
  });
});

describe("a robot session: time to live", () => {
  it("expires what no page takes in time, and tells who waits for its end", async () => {
    const robot = await withRobot();
    await robot.submit({ ...LEFT, ttl: 400 });
    await robot.submit(LEFT);
    const end = robot.session.endOf(1, patience(25_000));
    await robot.clock.pass(399);
    expect(await robot.states()).toEqual(["1 accepted", "2 accepted"]);
    await robot.clock.pass(1);
    expect(await end).toMatchObject({ state: "expired", reason: "older than 0.4 s" });
    await robot.clock.pass(9_600);
    expect(await robot.states()).toEqual(["1 expired", "2 expired"]);
  });

  it("tells the robot how much time is left, counted from the first try", async () => {
    const robot = await withRobot();
    await robot.submit({ ...LEFT, ttl: 2_000, age: 300 });
    await robot.clock.pass(500);
    const host = await page(robot);
    expect(host.told.find(({ type }) => type === "command")).toMatchObject({
      seq: 1,
      ttl: 2_000,
      remaining: 1_200,
      driver: robot.key.hash.slice(0, 6),
      replace: false,
      lease: null,
    });
    await robot.clock.pass(60_000);
    expect(await robot.states()).toEqual(["1 delivered"]);
    await host.ended({ ...completed(1), state: "expired" });
    expect(await robot.states()).toEqual(["1 expired"]);
  });

  it("refuses a try that comes too late, keeps its key free, and answers a known key at any age", async () => {
    const robot = await withRobot();
    const late = robot.submit({ ...LEFT, ttl: 1_000, age: 1_000 }, "key-0001");
    await expect(late).rejects.toMatchObject({ kind: "too-late" });
    expect(await robot.submit({ ...LEFT, ttl: 1_000 }, "key-0001")).toMatchObject({ seq: 1 });
    await robot.clock.pass(1_500);
    expect(await robot.submit({ ...LEFT, ttl: 1_000, age: 1_500 }, "key-0001")).toMatchObject({
      seq: 1,
      state: "expired",
      duplicate: true,
    });
  });

  it("shows the page what waits for it and how it ends", async () => {
    const robot = await withRobot();
    const host = await page(robot);
    for (let n = 0; n < 9; n++) await robot.submit({ ...LEFT, ttl: 2_000 });
    await robot.clock.pass(2_000);
    const shown = host.told.flatMap((message) =>
      message.type === "state" ? [[message.record.seq, message.record.state, message.ttl]] : [],
    );
    expect(shown).toEqual([
      [9, "accepted", 2_000],
      [9, "expired", 2_000],
    ]);
  });

  it("does not deliver again what has expired while the page was away", async () => {
    const robot = await withRobot();
    const before = await page(robot);
    await robot.submit({ ...LEFT, ttl: 400 });
    await robot.submit(LEFT);
    robot.session.leavePage(before.link);
    await robot.clock.pass(500);
    expect(await robot.states()).toEqual(["1 delivered", "2 delivered"]);
    const after = await page(robot);
    expect(after.seqs("command")).toEqual([2]);
    expect(await robot.states()).toEqual(["1 expired", "2 delivered"]);
  });
});

describe("a robot session: while its store does not answer", () => {
  it("expires late what it could not expire in time", async () => {
    const robot = await withRobot();
    await robot.submit({ ...LEFT, ttl: 400 });
    robot.cut.isCut = true;
    await robot.clock.pass(2_000);
    robot.cut.isCut = false;
    await robot.clock.pass(limits.storeRetryMs);
    expect(await robot.states()).toEqual(["1 expired"]);
  });

  it("ends later what runs without a page", async () => {
    const robot = await withRobot();
    await robot.submit(LEFT);
    const host = await page(robot);
    await host.started(1);
    robot.session.leavePage(host.link);
    robot.cut.isCut = true;
    await robot.clock.pass(limits.pageAwayMs + 5_000);
    robot.cut.isCut = false;
    await robot.clock.pass(2_000);
    expect(await robot.states()).toEqual(["1 cancelled"]);
  });

  it("delivers what was stored although the answer was lost, at the next try", async () => {
    const robot = await withRobot();
    const host = await page(robot);
    robot.cut.losesAnswers = true;
    await expect(robot.submit(LEFT, "key-0001")).rejects.toBeInstanceOf(StoreAway);
    robot.cut.losesAnswers = false;
    expect(await robot.submit(LEFT, "key-0001")).toMatchObject({ seq: 1, duplicate: true });
    expect(host.seqs("command")).toEqual([1]);
  });

  it("delivers it also where nobody tries again", async () => {
    const robot = await withRobot();
    const host = await page(robot);
    robot.cut.losesAnswers = true;
    await expect(robot.submit(LEFT)).rejects.toBeInstanceOf(StoreAway);
    robot.cut.losesAnswers = false;
    await robot.clock.pass(limits.storeRetryMs);
    expect(host.seqs("command")).toEqual([1]);
  });
});

describe("a robot session: replacing and cancelling", () => {
  it("gives the page at once what replaces, and supersedes what waits", async () => {
    const robot = await withRobot();
    const host = await page(robot);
    for (let n = 0; n < 9; n++) await robot.submit(LEFT);
    await robot.submit({ ...LEFT, replace: true });
    expect(host.told.at(-1)).toMatchObject({ type: "command", seq: 10, replace: true });
    expect((await robot.states()).slice(7)).toEqual([
      "8 delivered",
      "9 superseded",
      "10 delivered",
    ]);
  });

  it("takes back what waits, and asks the robot for what it has", async () => {
    const robot = await withRobot();
    const host = await page(robot);
    for (let n = 0; n < 9; n++) await robot.submit(LEFT);
    expect(await robot.session.cancel(robot.key, 9)).toMatchObject({ state: "cancelled" });
    expect(await robot.session.cancel(robot.key, 8)).toMatchObject({ state: "delivered" });
    expect(host.told.at(-1)).toEqual({ type: "cancel", seq: 8, why: "sender" });
    await host.ended({ ...completed(8), state: "cancelled" });
    expect(await robot.session.cancel(robot.key, 8)).toMatchObject({ state: "cancelled" });
    await expect(robot.session.cancel(robot.key, 10)).rejects.toMatchObject({ kind: "no-command" });
    const other = robot.session.cancel({ kind: "drive", hash: "other" }, 1);
    await expect(other).rejects.toMatchObject({ kind: "forbidden" });
  });
});

describe("a robot session: taking back while the page is away", () => {
  it("does not deliver again what was taken back, and asks for what has begun", async () => {
    const robot = await withRobot();
    const before = await page(robot);
    for (let n = 0; n < 3; n++) await robot.submit(LEFT);
    await before.started(1);
    robot.session.leavePage(before.link);
    for (const seq of [1, 2])
      expect(await robot.session.cancel(robot.key, seq)).toHaveProperty("seq");
    const after = await page(robot, { lastApplied: 1 });
    expect(after.seqs("command")).toEqual([3]);
    expect(after.told).toContainEqual({ type: "cancel", seq: 1, why: "sender" });
    expect(await robot.states()).toEqual(["1 started", "2 cancelled", "3 delivered"]);
    await after.ended({ ...completed(1), state: "cancelled" });
    expect(await robot.states()).toEqual(["1 cancelled", "2 cancelled", "3 delivered"]);
  });

  it("does not deliver again what a revoked key had sent", async () => {
    const robot = await withRobot();
    const before = await page(robot);
    await robot.submit(LEFT);
    robot.session.leavePage(before.link);
    await robot.session.keys.make({ kind: "drive", replace: true });
    const after = await page(robot);
    expect(after.seqs("command")).toEqual([]);
    const [record] = await robot.session.commandsAfter(0);
    expect(record).toMatchObject({ state: "cancelled", reason: "its key was revoked" });
  });
});

describe("a robot session: limits", () => {
  it("takes 40 commands at once and 20 a second, and always a stop", async () => {
    const robot = await withRobot();
    const host = await page(robot);
    const send = async (): Promise<string> => {
      try {
        const record = await robot.submit(LEFT);
        await host.ended(completed(record?.seq ?? 0));
        return "stored";
      } catch (error) {
        return (error as Refusal).kind;
      }
    };
    const outcomes: string[] = [];
    for (let n = 0; n < 45; n++) outcomes.push(await send());
    expect(outcomes.filter((outcome) => outcome === "stored")).toHaveLength(40);
    expect(outcomes.at(-1)).toBe("too-fast");
    expect(await robot.submit({ action: "stop" })).toMatchObject({ state: "accepted" });
    await robot.clock.pass(50);
    expect([await send(), await send()]).toEqual(["stored", "too-fast"]);
  });

  it("stores 20 stops at once and 5 a second; the open one answers for more", async () => {
    const robot = await withRobot();
    await page(robot);
    for (let n = 1; n <= 20; n++) {
      expect(await robot.submit({ action: "stop" })).toMatchObject({ seq: n, duplicate: false });
    }
    expect(await robot.submit({ action: "stop" })).toMatchObject({ seq: 20, duplicate: true });
    const keyed = robot.submit({ action: "stop" }, "key-0001");
    await expect(keyed).rejects.toMatchObject({ kind: "too-fast" });
    await robot.clock.pass(200);
    expect(await robot.submit({ action: "stop" }, "key-0001")).toMatchObject({ seq: 21 });
    expect(await robot.submit({ action: "stop" }, "key-0001")).toMatchObject({ seq: 21 });
  });

  it.each([
    { name: "has ended", meanwhile: (host: Host) => host.ended(completed(20)) },
    { name: "is followed by a command", meanwhile: (_: Host, robot: Robot) => robot.submit(LEFT) },
  ])("refuses a stop too many when the one before $name", async ({ meanwhile }) => {
    const robot = await withRobot();
    const host = await page(robot);
    for (let n = 0; n < 20; n++) await robot.submit({ action: "stop" });
    await meanwhile(host, robot);
    await expect(robot.submit({ action: "stop" })).rejects.toMatchObject({ kind: "too-fast" });
    await robot.clock.pass(200);
    expect(await robot.submit({ action: "stop" })).toMatchObject({ duplicate: false });
  });

  it("lets 64 commands wait and names the 65th", async () => {
    const robot = await withRobot();
    for (let n = 0; n < 64; n++) {
      await robot.submit(LEFT);
      await robot.clock.pass(50);
    }
    const refused = robot.submit(LEFT, "key-0001");
    await expect(refused).rejects.toMatchObject({
      kind: "queue-full",
      headers: { "Retry-After": "1" },
    });
  });

  it("lets a class register at once, not a flood", async () => {
    const { hub } = await withRobot();
    const register = () => hub.register("10.0.0.2", "http://localhost");
    for (let n = 0; n < 200; n++) await register();
    await expect(register()).rejects.toMatchObject({ kind: "too-fast" });
    await expect(hub.register("10.0.0.3", "http://localhost")).resolves.toBeDefined();
  });
});

describe("a robot session: what scripts see", () => {
  it("sends a reader at most 20 snapshots a second, the newest each time", async () => {
    const robot = await withRobot();
    const host = await page(robot);
    const seen: number[] = [];
    robot.session.join(
      robot.key,
      { snapshot: ({ seq }) => seen.push(seq), state: () => undefined, ...deafReader },
      null,
    );
    for (let seq = 1; seq <= 100; seq++) {
      await host.report({ seq });
      await robot.clock.pass(10);
    }
    await robot.clock.pass(100);
    expect(seen.length).toBeGreaterThan(15);
    expect(seen.length).toBeLessThanOrEqual(22);
    expect(seen.at(-1)).toBe(100);
  });

  it("sends a slow reader nothing old, and drops one that does not read", async () => {
    const robot = await withRobot();
    const host = await page(robot);
    const flow = { sentBytes: 0, takenBytes: 0, isProof: false, ask: () => undefined };
    const seen: number[] = [];
    const over: string[] = [];
    const snapshot = ({ seq }: { seq: number }): void => {
      seen.push(seq);
      flow.sentBytes += 400;
    };
    robot.session.join(
      robot.key,
      {
        ...deafReader,
        snapshot,
        state: () => undefined,
        over: (reason) => over.push(reason),
        door: "events",
        flow,
      },
      null,
    );
    for (let seq = 1; seq <= 9; seq++) {
      await host.report({ seq });
      await robot.clock.pass(limits.snapshotIntervalMs);
    }
    expect(seen).toEqual([1, 2]);
    flow.takenBytes = flow.sentBytes;
    await robot.clock.pass(limits.snapshotIntervalMs);
    expect(seen).toEqual([1, 2, 9]);
    flow.sentBytes += limits.stuckReaderBytes + 1;
    await robot.submit(LEFT);
    expect(over).toEqual(["tooSlow"]);
  });

  it("shows a newer snapshot before the ending that came after it", async () => {
    const robot = await withRobot();
    const host = await page(robot);
    await robot.submit(LEFT);
    const said: string[] = [];
    robot.session.join(
      robot.key,
      {
        snapshot: ({ seq }) => said.push(`snapshot ${seq}`),
        state: ({ record }) => said.push(record.state),
        ...deafReader,
      },
      null,
    );
    await host.report({ seq: 1 });
    await host.report({ seq: 2 });
    await host.ended(completed(1));
    expect(said).toEqual(["snapshot 1", "snapshot 2", "completed"]);
  });

  it("shows the robot as it is before the endings that a page brings along", async () => {
    const robot = await withRobot();
    const host = await page(robot);
    await robot.submit(LEFT);
    await host.started(1);
    await host.report({ seq: 1, tick: 100 });
    robot.session.leavePage(host.link);
    const ended = robot.session.endOf(1, patience(20_000));
    const read = ended.then(({ state }) => `${state} at ${robot.session.newest?.tick}`);
    const snapshot = snapshotOf({ seq: 2, tick: 200 });
    await page(robot, { lastApplied: 1, endings: [completed(1)], snapshot });
    expect(await read).toBe("completed at 200");
  });

  it("tells apart a robot that runs, one that sleeps and one that is gone", async () => {
    const robot = await withRobot();
    const host = await page(robot);
    await host.report({ tick: 1 });
    expect(robot.session.newest?.state).toBe("running");
    await robot.clock.pass(5_000);
    expect(robot.session.newest?.state).toBe("paused");
    robot.session.leavePage(host.link);
    expect(robot.session.newest?.state).toBe("gone");
  });

  it("takes a robot whose ticks stand still for asleep, until they go on", async () => {
    const robot = await withRobot();
    const host = await page(robot);
    for (let second = 0; second < 5; second++) {
      await host.report({ seq: second, tick: 7 });
      await robot.clock.pass(1_000);
    }
    expect(robot.session.newest?.state).toBe("paused");
    await host.report({ seq: 9, tick: 8 });
    expect(robot.session.newest?.state).toBe("running");
  });

  it("keeps counting snapshots when a reloaded page begins at 1 again", async () => {
    const robot = await withRobot();
    await (await page(robot)).report({ seq: 900 });
    await (await page(robot)).report({ seq: 1 });
    expect(robot.session.newest?.seq).toBe(901);
  });

  it("answers a long poll when there is news, and after the wait when there is none", async () => {
    const robot = await withRobot();
    const host = await page(robot);
    await host.report({ seq: 7 });
    const newer = robot.session.nextSnapshot(7, patience(25_000));
    await host.report({ seq: 8 });
    expect(await newer).toMatchObject({ seq: 8 });
    const none = robot.session.nextSnapshot(8, patience(25_000));
    await robot.clock.pass(3_000);
    await host.report({ seq: 8 });
    expect(await none).toMatchObject({ seq: 9 });
    const gone = robot.session.nextSnapshot(9, patience(25_000));
    robot.session.leavePage(host.link);
    expect(await gone).toMatchObject({ seq: 9, state: "gone" });
    const quiet = robot.session.nextSnapshot(9, patience(25_000));
    await robot.clock.pass(25_000);
    expect(await quiet).toMatchObject({ seq: 9, state: "gone" });
  });

  it("waits for the end of a command", async () => {
    const robot = await withRobot();
    const host = await page(robot);
    await robot.submit(LEFT);
    const end = robot.session.endOf(1, patience(25_000));
    await settled();
    await host.ended(completed(1));
    expect(await end).toMatchObject({ state: "completed" });
    expect(await robot.session.endOf(1, patience(25_000))).toMatchObject({ state: "completed" });
    await expect(robot.session.endOf(2, patience(0))).rejects.toMatchObject({ kind: "no-command" });
  });

  it("tells the page about its scripts, at most once a second", async () => {
    const robot = await withRobot();
    const host = await page(robot);
    await robot.clock.pass(2_000);
    const before = host.told.length;
    for (let n = 0; n < 50; n++) {
      robot.session.heard(robot.key)();
      await robot.clock.pass(100);
    }
    const drivers = host.told.slice(before).filter(({ type }) => type === "drivers");
    expect(drivers.length).toBeGreaterThanOrEqual(5);
    expect(drivers.length).toBeLessThanOrEqual(6);
    expect(drivers.at(-1)).toMatchObject({ connected: 0, client: "Python" });
  });
});

describe("a robot session: the life of its scripts", () => {
  const name = (robot: Robot): string => robot.key.hash.slice(0, 6);
  const alive = (host: Host) =>
    host.told.flatMap((message) => (message.type === "drivers" ? [message.alive] : [])).at(-1);

  it("says within a second which script was heard, and for how long it has been silent", async () => {
    const robot = await withRobot();
    const host = await page(robot);
    await robot.clock.pass(2_000);
    robot.session.heard(robot.key)();
    expect(alive(host)).toEqual([{ driver: name(robot), silentMs: 0, lineMs: null }]);
    await robot.clock.pass(300);
    robot.session.heard(robot.key)();
    await robot.clock.pass(700);
    expect(alive(host)).toEqual([{ driver: name(robot), silentMs: 700, lineMs: null }]);
  });

  it("takes a request that waits for a sign of life, each second, and none that was answered", async () => {
    const robot = await withRobot();
    const host = await page(robot);
    const answered = robot.session.heard(robot.key);
    await robot.clock.pass(10_500);
    const before = host.told.length;
    await robot.clock.pass(2_000);
    expect(host.told.slice(before)).toHaveLength(2);
    expect(alive(host)).toMatchObject([{ silentMs: 0 }]);
    answered();
    await robot.clock.pass(2_000);
    const silent = host.told.length;
    await robot.clock.pass(10_000);
    expect(host.told).toHaveLength(silent);
  });

  it("says at once that a script has a new line", async () => {
    const robot = await withRobot();
    const host = await page(robot);
    robot.session.heard(robot.key)();
    robot.session.join(
      robot.key,
      { snapshot: () => undefined, state: () => undefined, ...deafReader },
      null,
    );
    expect(alive(host)).toMatchObject([{ driver: name(robot), lineMs: 0 }]);
  });
});

describe("a robot session: its end", () => {
  it("is forgotten two hours after its last use, with everyone sent away", async () => {
    const robot = await withRobot();
    const host = await page(robot);
    await robot.clock.pass(60 * 60 * 1000);
    await host.report();
    await robot.clock.pass(90 * 60 * 1000);
    expect(host.closed).toEqual([]);
    await robot.clock.pass(35 * 60 * 1000);
    expect(host.closed).toEqual([closeReasons.over.code]);
    const { hub, robot: registration } = robot;
    await expect(
      hub.authorise(registration.id, registration.driverKey, "command"),
    ).rejects.toMatchObject({ kind: "no-robot" });
  });

  it("is forgotten after a day, however busy it is", async () => {
    const robot = await withRobot();
    const host = await page(robot);
    for (let hour = 0; hour < 24; hour++) {
      await host.report();
      await robot.clock.pass(60 * 60 * 1000);
    }
    await robot.clock.pass(2 * 60 * 1000);
    expect(host.closed).toEqual([closeReasons.over.code]);
  });
});

describe("a relay that ends", () => {
  it("asks for another try, and never calls a robot or a key unknown", async () => {
    const { hub, robot, submit } = await withRobot();
    await hub.close();
    const restarting = expect.objectContaining({ kind: "restarting" });
    await expect(submit(LEFT)).rejects.toEqual(restarting);
    await expect(hub.authorise(robot.id, robot.driverKey, "command")).rejects.toEqual(restarting);
    await expect(hub.register("10.0.0.1", "http://localhost")).rejects.toEqual(restarting);
  });
});
