/** The sweep over all sessions: what one of them, or the store, holds up holds up nobody else. */
import { join } from "node:path";
import { termsOf, type Resume } from "@corridor/protocol";
import { pino } from "pino";
import { expect, it, onTestFinished } from "vitest";
import type { SessionStore } from "../store/session-store.ts";
import { SqliteStore } from "../store/sqlite-store.ts";
import { FakeClock } from "../testing/fake-clock.ts";
import { testFolder } from "../testing/test-relay.ts";
import { limits } from "./limits.ts";
import type { PageLink } from "./page-link.ts";
import { SessionHub, type Grant } from "./session-hub.ts";

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
  const sessions: Grant[] = [];
  for (let n = 0; n < count; n++) {
    const robot = await hub.register("10.0.0.1", "http://localhost");
    sessions.push(await hub.authorise(robot.id, robot.driverKey, "command"));
  }
  /** A robot whose page begins a command and goes. */
  const leftAlone = async ({ session, key }: Grant): Promise<void> => {
    const link: PageLink = { isOpen: true, send: () => undefined, close: () => undefined };
    const nothing: Resume = { type: "resume", lastApplied: 0, fresh: false, endings: [] };
    await session.takePage(link, nothing);
    const command = { key: null, ...termsOf({ action: "left 90" }) };
    await session.submit(key, command, () => undefined);
    session.leavePage(link, true);
  };
  return { clock, store, instead, sessions, leftAlone };
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
