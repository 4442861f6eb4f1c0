import { pino } from "pino";
import { describe, expect, it, onTestFinished, vi } from "vitest";
import { systemClock, type Clock } from "../clock.ts";
import { connectRedis } from "../store/redis/connection.ts";
import { ForgottenBytes } from "../store/redis/forgotten-bytes.ts";
import { RedisSessionStore } from "../store/redis/redis-session-store.ts";
import { swallowingNet } from "../testing/swallowing-net.ts";
import { hasRedis, startTestRedis } from "../testing/test-redis.ts";
import { RedisSwitchboard } from "./redis-switchboard.ts";
import { placeOf, switchboardCases } from "./testing/switchboard.cases.ts";

const TAKEN_FOR_DEAD_MS = 5_000;
const ID = "AAAAAAAAAAAAAAAAAAAAAA";

/** A clock whose timers stand still while its process does. */
function stallingClock() {
  const held: (() => void)[] = [];
  let isStalled = false;
  const clock: Clock = {
    now: () => systemClock.now(),
    after: (ms, call) =>
      systemClock.after(ms, () => {
        if (isStalled) held.push(call);
        else call();
      }),
  };
  return {
    clock,
    stall: () => (isStalled = true),
    goOn: () => {
      isStalled = false;
      for (const call of held.splice(0)) call();
    },
  };
}

async function relayAt(
  url: string,
  relay: string,
  clock: Clock = systemClock,
  hearsAt: string = url,
) {
  const connect = async (to: string) => {
    const connection = await connectRedis(to, () => undefined);
    onTestFinished(() => connection.destroy());
    return connection;
  };
  const [redis, hearing] = [await connect(url), await connect(hearsAt)];
  const log = pino({ level: "silent" });
  const options = { redis, hearing, relay, clock, log };
  const switchboard = await RedisSwitchboard.open(options);
  const store = new RedisSessionStore(redis, new ForgottenBytes(redis), relay);
  const die = (): void => {
    redis.destroy();
    hearing.destroy();
  };
  onTestFinished(() => switchboard.close());
  return { switchboard, store, redis, hearing, die };
}

async function twoRelays() {
  const { url } = await startTestRedis();
  return [await relayAt(url, "relay-a"), await relayAt(url, "relay-b")] as const;
}

describe.skipIf(!hasRedis)("with Redis", () => {
  switchboardCases("RedisSwitchboard", async () => [...(await twoRelays())]);

  it("takes the page of a relay that has died for away, within five seconds", async () => {
    const [dying, other] = await twoRelays();
    await other.store.create({ id: ID, createdAt: 1, keys: [{ kind: "drive", hash: "d" }] });
    const epoch = await (await placeOf(dying)).take();
    const { heard } = await placeOf(other);
    expect(heard).toMatchObject([{ kind: "page", epoch }]);
    dying.die();
    await vi.waitFor(
      () => expect(heard.at(-1)).toMatchObject({ kind: "page-left", epoch }),
      TAKEN_FOR_DEAD_MS,
    );
    expect((await placeOf(other)).heard).toEqual([]);
  });

  it("finds the page again of a relay that stood still and was taken for dead, which learns of it", async () => {
    const { url } = await startTestRedis();
    const { clock, stall, goOn } = stallingClock();
    const stalling = await relayAt(url, "relay-a", clock);
    const other = await relayAt(url, "relay-b");
    await other.store.create({ id: ID, createdAt: 1, keys: [] });
    const [a, b] = [await placeOf(stalling), await placeOf(other)];
    const epoch = await a.take();
    stall();
    await vi.waitFor(
      () => expect(b.heard.at(-1)).toMatchObject({ kind: "page-left", epoch }),
      TAKEN_FOR_DEAD_MS,
    );
    goOn();
    await vi.waitFor(
      () => expect(b.heard.at(-1)).toMatchObject({ kind: "page", epoch }),
      TAKEN_FOR_DEAD_MS,
    );
    expect(a.heard).toEqual([{ kind: "lapsed" }]);
  });

  it("ends nothing of a robot whose page is at another relay that lives", async () => {
    const [dying, other] = await twoRelays();
    await other.store.create({ id: ID, createdAt: 1, keys: [] });
    const epoch = await (await placeOf(dying)).take();
    expect(await other.store.abandon(ID, epoch, "gone")).toBeNull();
    dying.die();
    await vi.waitFor(
      async () => expect(await other.store.abandon(ID, epoch, "gone")).toEqual([]),
      TAKEN_FOR_DEAD_MS,
    );
  });

  it("has keys looked up again and again while it hears nothing: one may be revoked meanwhile", async () => {
    const redis = await startTestRedis();
    const relay = await relayAt(redis.url, "relay-a");
    await relay.store.create({ id: ID, createdAt: 1, keys: [{ kind: "drive", hash: "d" }] });
    const { heard } = await placeOf(relay);
    await redis.stop();
    await vi.waitFor(
      () => expect(heard.slice(0, 2)).toEqual([{ kind: "keys" }, { kind: "keys" }]),
      5_000,
    );
  });

  it("has keys looked up long before it is sure that the line it hears by is dead", async () => {
    const { url, port } = await startTestRedis();
    const net = await swallowingNet(port);
    const relay = await relayAt(url, "relay-a", systemClock, net.url);
    await relay.store.create({ id: ID, createdAt: 1, keys: [{ kind: "drive", hash: "d" }] });
    const { heard } = await placeOf(relay);
    net.swallow();
    await vi.waitFor(() => expect(heard).toContainEqual({ kind: "keys" }), 5_000);
    // It still takes the line for a good one.
    expect(relay.hearing.isReady).toBe(true);
  });

  it("has nothing looked up while all is well, or while Redis stands still", async () => {
    const { url, port } = await startTestRedis();
    const net = await swallowingNet(port);
    const relay = await relayAt(net.url, "relay-a");
    const watcher = await relayAt(url, "relay-b");
    await relay.store.create({ id: ID, createdAt: 1, keys: [{ kind: "drive", hash: "d" }] });
    const { heard } = await placeOf(relay);
    const beats = async (): Promise<void> => {
      for (let n = 0; n < 4; n++) {
        await new Promise((resolve) => void setTimeout(resolve, 300));
        await watcher.redis.ping();
      }
    };
    await beats();
    net.swallow();
    await beats();
    expect(heard).toEqual([]);
  });

  it("says that something was missed when the line was broken, and hears again", async () => {
    const [relay, other] = await twoRelays();
    await relay.store.create({ id: ID, createdAt: 1, keys: [{ kind: "drive", hash: "d" }] });
    const place = await placeOf(relay);
    await other.redis.sendCommand(["CLIENT", "KILL", "TYPE", "pubsub"]);
    await vi.waitFor(() => expect(place.missed).toHaveBeenCalled(), 5_000);
    // The other relay's line was cut too, and may take longer to be back.
    const back = await vi.waitFor(() => placeOf(other), 5_000);
    await back.add();
    await vi.waitFor(() => expect(place.steps).toEqual(["+1"]), 5_000);
  });
});
