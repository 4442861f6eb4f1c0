/**
 * The periodic pass over all sessions: a slow or failing session or store does not delay others.
 */
import { join } from "node:path";
import { termsOf, type Registration, type Resume } from "@corridor/protocol";
import { pino } from "pino";
import { expect, it, onTestFinished } from "vitest";
import type { SessionStore } from "../store/port.ts";
import { SqliteStore } from "../store/sqlite/sqlite-store.ts";
import { FakeClock } from "../platform/testing/fake-clock.ts";
import { testFolder } from "../testing/test-relay.ts";
import { limits } from "../platform/limits/limits.ts";
import type { PageLink } from "./page/page-link.ts";
import { SessionHub, type Grant } from "./registry.ts";

async function withRobots(count: number) {
  const clock = new FakeClock();
  const store = new SqliteStore(join(testFolder(), "corridor.sqlite"));
  onTestFinished(() => store.close());
  const instead: Partial<SessionStore> = {};
  const whole: SessionStore = new Proxy(store, {
    get(target, name) {
      const part: unknown = Reflect.get(instead, name) ?? Reflect.get(target, name);
      return typeof part === "function" ? (part.bind(target) as unknown) : part;
    },
  });
  const hub = new SessionHub(whole, clock, pino({ level: "silent" }));
  const robots: Registration[] = [];
  for (let n = 0; n < count; n++) robots.push(await hub.register("10.0.0.1", "http://localhost"));
  const enter = (): Promise<Grant[]> =>
    Promise.all(robots.map(({ id, driverKey }) => hub.authorise(id, driverKey, "command")));
  const sessions = await enter();
  /** Delivers a command to the robot's page, then disconnects the page. */
  const leftAlone = async ({ session, key }: Grant): Promise<void> => {
    const link: PageLink = { isOpen: true, send: () => undefined, close: () => undefined };
    const nothing: Resume = { type: "resume", lastApplied: 0, fresh: false, endings: [] };
    await session.takePage(link, nothing);
    const command = { key: null, ...termsOf({ action: "left 90" }) };
    await session.submit(key, command, () => undefined);
    session.leavePage(link, true);
  };
  return { clock, store, hub, instead, sessions, enter, leftAlone };
}

it("sees to every robot though another one's step in the store fails", async () => {
  const { clock, store, instead, sessions, leftAlone } = await withRobots(2);
  for (const each of sessions) await leftAlone(each);
  const [first, second] = sessions;
  instead.abandon = async (id, ...rest) => {
    if (id === first?.session.id) throw new Error("locked");
    return store.abandon(id, ...rest);
  };
  await clock.pass(limits.pageAwayMs + 5_000);
  expect(await second?.session.commandsAfter(0)).toMatchObject([{ state: "cancelled" }]);
});

it("sees to robots though the store takes long to forget others", async () => {
  const { clock, instead, sessions, leftAlone } = await withRobots(1);
  instead.removeExpired = () => new Promise(() => undefined);
  await clock.pass(61_000);
  const [only] = sessions;
  if (only !== undefined) await leftAlone(only);
  await clock.pass(limits.pageAwayMs + 5_000);
  expect(await only?.session.commandsAfter(0)).toMatchObject([{ state: "cancelled" }]);
});

it("writes down over some seconds that many robots are in use, not all in the same", async () => {
  const { clock, store, instead, sessions } = await withRobots(60);
  const notedAt = new Map<string, number>();
  const begun = clock.now();
  instead.touch = async (id, ...rest) => {
    notedAt.set(id, Math.floor((clock.now() - begun) / 1_000));
    return store.touch(id, ...rest);
  };
  await clock.pass(limits.touchMs);
  for (const { session, key } of sessions) session.heard(key)();
  await clock.pass(10_000);
  const perSecond = [...Map.groupBy(notedAt.values(), (second) => second).values()];
  expect(notedAt.size).toBe(60);
  expect(perSecond.map((noted) => noted.length)).toEqual([10, 10, 10, 10, 10, 10]);
});

it("forgets nobody who comes back at the last moment, however many there are", async () => {
  const { clock, enter } = await withRobots(60);
  await clock.pass(limits.sessionIdleMs + 500);
  const sessions = await enter();
  for (const { session, key } of sessions) session.heard(key)();
  await clock.pass(3 * 60_000);
  expect(sessions.filter(({ session }) => session.isOver)).toEqual([]);
});

it("forgets nobody who is in use though it cannot be written down for another", async () => {
  const { clock, store, instead, sessions } = await withRobots(5);
  const [stuck] = sessions;
  instead.touch = (id, ...rest) =>
    id === stuck?.session.id ? new Promise(() => undefined) : store.touch(id, ...rest);
  for (let passed = 0; passed < limits.sessionIdleMs + 5 * 60_000; passed += 60_000) {
    for (const { session, key } of sessions) session.heard(key)();
    await clock.pass(60_000);
  }
  expect(sessions.filter(({ session }) => session.isOver)).toEqual([]);
});

it("looks no more at a robot that is deleted before its turn comes", async () => {
  const { clock, hub, instead, sessions } = await withRobots(15);
  // A pass has started: it has visited the first ten sessions and visits the others soon.
  await clock.pass(limits.touchMs);
  const last = sessions[14];
  if (last === undefined) throw new Error("there are 15");
  last.session.heard(last.key)();
  const noted: string[] = [];
  instead.touch = async (id) => void noted.push(id);
  await hub.remove(last.session);
  await clock.pass(5_000);
  expect(noted).toEqual([]);
});

it("forgets nothing any more once it is closed", async () => {
  const { clock, hub, instead } = await withRobots(1);
  let asked = 0;
  instead.removeExpired = async () => {
    asked += 1;
    return [];
  };
  await clock.pass(1_000);
  expect(asked).toBe(1);
  await hub.close();
  await clock.pass(10 * 60_000);
  expect(asked).toBe(1);
});
