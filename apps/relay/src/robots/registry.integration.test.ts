/**
 * The periodic pass over all robots: a slow or failing robot or store does not delay others.
 */
import { join } from "node:path";
import { termsOf, type Registration, type Resume } from "@corridor/protocol";
import { pino } from "pino";
import { expect, it, onTestFinished } from "vitest";
import type { RobotStore } from "../store/robot-store.ts";
import { SqliteRobotStore } from "../store/sqlite/sqlite-robot-store.ts";
import { FakeClock, settled } from "../platform/testing/fake-clock.ts";
import { testFolder } from "../testing/test-relay.ts";
import { limits } from "../platform/limits/limits.ts";
import type { PageConnection } from "./page/page-ownership.ts";
import { RobotRegistry, type Grant } from "./registry.ts";

async function withRobots(count: number) {
  const clock = new FakeClock();
  const store = new SqliteRobotStore(join(testFolder(), "corridor.sqlite"));
  onTestFinished(() => store.close());
  const instead: Partial<RobotStore> = {};
  const whole: RobotStore = new Proxy(store, {
    get(target, name) {
      const part: unknown = Reflect.get(instead, name) ?? Reflect.get(target, name);
      return typeof part === "function" ? (part.bind(target) as unknown) : part;
    },
  });
  const registry = new RobotRegistry(whole, clock, pino({ level: "silent" }));
  const registrations: Registration[] = [];
  for (let n = 0; n < count; n++)
    registrations.push(await registry.register("10.0.0.1", "http://localhost"));
  const enter = (): Promise<Grant[]> =>
    Promise.all(
      registrations.map(({ id, driverKey }) => registry.authorise(id, driverKey, "command")),
    );
  const robots = await enter();
  /** Delivers a command to the robot's page, then disconnects the page. */
  const leftAlone = async ({ robot, caller }: Grant): Promise<void> => {
    const connection: PageConnection = {
      isOpen: true,
      send: () => undefined,
      close: () => undefined,
    };
    const nothing: Resume = { type: "resume", lastApplied: 0, fresh: false, endings: [] };
    await robot.page.acquire(connection, nothing);
    const command = { key: null, ...termsOf({ action: "left 90" }) };
    await robot.submit(caller, command, () => undefined);
    robot.page.leave(connection, true);
  };
  return { clock, store, registry, instead, robots, enter, leftAlone };
}

it("checks every robot even if the store fails for another one", async () => {
  const { clock, store, instead, robots, leftAlone } = await withRobots(2);
  for (const each of robots) await leftAlone(each);
  const [first, second] = robots;
  instead.commit = async (id, step) => {
    if (id === first?.robot.id) throw new Error("locked");
    return store.commit(id, step);
  };
  await clock.pass(limits.pageDisconnectedMs + 5_000);
  expect(await second?.robot.commandsAfter(0)).toMatchObject([{ state: "cancelled" }]);
});

it("checks robots while the store is slow to delete others", async () => {
  const { clock, instead, robots, leftAlone } = await withRobots(1);
  instead.removeExpired = () => new Promise(() => undefined);
  await clock.pass(61_000);
  const [only] = robots;
  if (only !== undefined) await leftAlone(only);
  await clock.pass(limits.pageDisconnectedMs + 5_000);
  expect(await only?.robot.commandsAfter(0)).toMatchObject([{ state: "cancelled" }]);
});

it("spreads the writes of last uses over some seconds", async () => {
  const { clock, store, instead, robots } = await withRobots(60);
  const notedAt = new Map<string, number>();
  const begun = clock.now();
  instead.touch = async (id, ...rest) => {
    notedAt.set(id, Math.floor((clock.now() - begun) / 1_000));
    return store.touch(id, ...rest);
  };
  await clock.pass(limits.touchMs);
  for (const { robot, caller } of robots) robot.received(caller)();
  await clock.pass(10_000);
  const perSecond = [...Map.groupBy(notedAt.values(), (second) => second).values()];
  expect(notedAt.size).toBe(60);
  expect(perSecond.map((noted) => noted.length)).toEqual([10, 10, 10, 10, 10, 10]);
});

it("deletes no robot that is used just before its deletion, for any number of robots", async () => {
  const { clock, enter } = await withRobots(60);
  await clock.pass(limits.robotIdleMs + 500);
  const robots = await enter();
  for (const { robot, caller } of robots) robot.received(caller)();
  await clock.pass(3 * 60_000);
  expect(robots.filter(({ robot }) => robot.isOver)).toEqual([]);
});

it("deletes no robot in use even if the use of another cannot be stored", async () => {
  const { clock, store, instead, robots } = await withRobots(5);
  const [stuck] = robots;
  instead.touch = (id, ...rest) =>
    id === stuck?.robot.id ? new Promise(() => undefined) : store.touch(id, ...rest);
  for (let passed = 0; passed < limits.robotIdleMs + 5 * 60_000; passed += 60_000) {
    for (const { robot, caller } of robots) robot.received(caller)();
    await clock.pass(60_000);
  }
  expect(robots.filter(({ robot }) => robot.isOver)).toEqual([]);
});

it("skips a robot that was deleted before its check", async () => {
  const { clock, registry, instead, robots } = await withRobots(15);
  // A pass has started: it has visited the first ten robots and visits the others soon.
  await clock.pass(limits.touchMs);
  const last = robots[14];
  if (last === undefined) throw new Error("there are 15");
  last.robot.received(last.caller)();
  const noted: string[] = [];
  instead.touch = async (id) => void noted.push(id);
  await registry.remove(last.robot);
  await clock.pass(5_000);
  expect(noted).toEqual([]);
});

it("deletes nothing after it is closed", async () => {
  const { clock, registry, instead } = await withRobots(1);
  let asked = 0;
  instead.removeExpired = async () => {
    asked += 1;
    return [];
  };
  await clock.pass(1_000);
  expect(asked).toBe(1);
  await registry.close();
  await clock.pass(10 * 60_000);
  expect(asked).toBe(1);
});

it("disconnects the clients of expired robots even if another one cannot be loaded", async () => {
  const { clock, store, registry, instead, robots } = await withRobots(1);
  const broken = await registry.register("10.0.0.1", "http://localhost");
  instead.find = async (id) => {
    await settled();
    if (id === broken.id) throw new Error("locked");
    return store.find(id);
  };
  instead.removeExpired = async () => {
    void registry.authorise(broken.id, broken.driverKey, "command").catch(() => undefined);
    return [broken.id, ...robots.map(({ robot }) => robot.id)];
  };
  await clock.pass(1_000);
  expect(robots.map(({ robot }) => robot.isOver)).toEqual([true]);
});

it("keeps serving a robot that could not be deleted", async () => {
  const { registry, instead, robots, enter } = await withRobots(1);
  instead.remove = async () => {
    throw new Error("the disk is full");
  };
  for (const { robot } of robots) {
    await expect(registry.remove(robot)).rejects.toThrow("the disk is full");
    expect(robot.isOver).toBe(false);
  }
  expect((await enter()).map(({ robot }) => robot)).toEqual(robots.map(({ robot }) => robot));
});
