import { describe, expect, it, onTestFinished, vi } from "vitest";
import { abandonStep } from "../../../../apps/relay/src/commands/page-transitions.ts";
import { StoreUnavailableError } from "../../../../apps/relay/src/platform/errors/store-unavailable.ts";
import { systemClock, type Clock } from "../../../../apps/relay/src/platform/time/clock.ts";
import { connectRedis } from "../../../../apps/relay/src/store/redis/connection.ts";
import { DeletedBytes } from "../../../../apps/relay/src/store/redis/deleted-bytes.ts";
import { RedisRobotStore } from "../../../../apps/relay/src/store/redis/redis-robot-store.ts";
import { swallowingNet } from "../../../support/relay/swallowing-net.ts";
import { silentLog } from "../../../../apps/relay/src/testing/test-relay.ts";
import { hasRedis, startTestRedis } from "../../../support/relay/test-redis.ts";
import { channelOf } from "../../../../apps/relay/src/store/redis/redis-keys.ts";
import { RedisBus } from "../../../../apps/relay/src/bus/redis.ts";
import { subscribe, busCases } from "../../../../apps/relay/src/bus/bus.cases.ts";

const DETECTION_MS = 5_000;
const ID = "AAAAAAAAAAAAAAAAAAAAAA";

/** A clock that holds its timers while the process is stalled. */
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
    resume: () => {
      isStalled = false;
      for (const call of held.splice(0)) call();
    },
  };
}

async function relayAt(
  url: string,
  relay: string,
  clock: Clock = systemClock,
  subscribesAt: string = url,
) {
  const connect = async (to: string) => {
    const connection = await connectRedis(to, () => undefined);
    onTestFinished(() => connection.destroy());
    return connection;
  };
  const [redis, subscriber] = [await connect(url), await connect(subscribesAt)];
  const options = { redis, subscriber, relay, clock, log: silentLog };
  const bus = await RedisBus.open(options);
  const store = new RedisRobotStore(redis, new DeletedBytes(redis), relay);
  const die = (): void => {
    redis.destroy();
    subscriber.destroy();
  };
  onTestFinished(() => bus.close());
  return { bus, store, redis, subscriber, die };
}

async function twoRelays() {
  const { url } = await startTestRedis();
  return [await relayAt(url, "relay-a"), await relayAt(url, "relay-b")] as const;
}

describe.skipIf(!hasRedis)("with Redis", () => {
  busCases("RedisBus", async () => [...(await twoRelays())]);

  it("leaves the channel of a robot that it could not load", async () => {
    const relay = await relayAt((await startTestRedis()).url, "relay-a");
    const { redis } = relay;
    const evalSha = redis.evalSha.bind(redis);
    vi.spyOn(redis, "evalSha").mockImplementation(async (hash, options) => {
      if (options?.arguments?.[0] === "holder") throw new Error("the connection was lost");
      return evalSha(hash, options);
    });
    await expect(subscribe(relay)).rejects.toBeInstanceOf(StoreUnavailableError);
    const channel = channelOf(ID);
    await vi.waitFor(async () =>
      expect(await redis.sendCommand(["PUBSUB", "NUMSUB", channel])).toEqual([channel, 0]),
    );
  });

  it("reports a deletion also to the relay that made it, because the response can be lost", async () => {
    const relay = await relayAt((await startTestRedis()).url, "relay-a");
    await relay.store.create({ id: ID, createdAt: 1, keys: [{ kind: "drive", hash: "d" }] });
    const { received } = await subscribe(relay);
    vi.spyOn(relay.redis, "info").mockRejectedValueOnce(new Error("the connection was lost"));
    const expiry = relay.store.removeExpired({ lastUsedAt: 2, createdAt: 2 });
    await expect(expiry).rejects.toBeInstanceOf(StoreUnavailableError);
    await vi.waitFor(() => expect(received).toContainEqual({ kind: "over", from: "relay-a" }));
  });

  it("reports the page of a dead relay as disconnected within five seconds", async () => {
    const [dying, other] = await twoRelays();
    await other.store.create({ id: ID, createdAt: 1, keys: [{ kind: "drive", hash: "d" }] });
    const epoch = await (await subscribe(dying)).take();
    const { received } = await subscribe(other);
    expect(received).toMatchObject([{ kind: "page", epoch }]);
    dying.die();
    await vi.waitFor(
      () => expect(received.at(-1)).toMatchObject({ kind: "page-left", epoch }),
      DETECTION_MS,
    );
    expect((await subscribe(other)).received).toEqual([]);
  });

  it("restores the page of a stalled relay that was considered dead, and notifies that relay", async () => {
    const { url } = await startTestRedis();
    const { clock, stall, resume } = stallingClock();
    const stalling = await relayAt(url, "relay-a", clock);
    const other = await relayAt(url, "relay-b");
    await other.store.create({ id: ID, createdAt: 1, keys: [] });
    const [a, b] = [await subscribe(stalling), await subscribe(other)];
    const epoch = await a.take();
    stall();
    await vi.waitFor(
      () => expect(b.received.at(-1)).toMatchObject({ kind: "page-left", epoch }),
      DETECTION_MS,
    );
    resume();
    await vi.waitFor(
      () => expect(b.received.at(-1)).toMatchObject({ kind: "page", epoch }),
      DETECTION_MS,
    );
    expect(a.received).toEqual([{ kind: "lapsed" }]);
  });

  it("does not end commands while the page is connected to another live relay", async () => {
    const [dying, other] = await twoRelays();
    await other.store.create({ id: ID, createdAt: 1, keys: [] });
    const epoch = await (await subscribe(dying)).take();
    expect(await other.store.commit(ID, abandonStep(epoch))).toBeNull();
    dying.die();
    await vi.waitFor(
      async () => expect(await other.store.commit(ID, abandonStep(epoch))).toEqual([]),
      DETECTION_MS,
    );
  });

  it("requests repeated key checks while disconnected, because a key may have been revoked", async () => {
    const redis = await startTestRedis();
    const relay = await relayAt(redis.url, "relay-a");
    await relay.store.create({ id: ID, createdAt: 1, keys: [{ kind: "drive", hash: "d" }] });
    const { received } = await subscribe(relay);
    await redis.stop();
    await vi.waitFor(
      () => expect(received.slice(0, 2)).toEqual([{ kind: "keys" }, { kind: "keys" }]),
      5_000,
    );
  });

  it("requests key checks before it detects that its subscriber connection is dead", async () => {
    const { url, port } = await startTestRedis();
    const net = await swallowingNet(port);
    const relay = await relayAt(url, "relay-a", systemClock, net.url);
    await relay.store.create({ id: ID, createdAt: 1, keys: [{ kind: "drive", hash: "d" }] });
    const { received } = await subscribe(relay);
    net.swallow();
    await vi.waitFor(() => expect(received).toContainEqual({ kind: "keys" }), 5_000);
    // The connection still counts as working.
    expect(relay.subscriber.isReady).toBe(true);
  });

  it("requests no key checks while all connections work, or while Redis is stalled", async () => {
    const { url, port } = await startTestRedis();
    const net = await swallowingNet(port);
    const relay = await relayAt(net.url, "relay-a");
    const watcher = await relayAt(url, "relay-b");
    await relay.store.create({ id: ID, createdAt: 1, keys: [{ kind: "drive", hash: "d" }] });
    const { received } = await subscribe(relay);
    const beats = async (): Promise<void> => {
      for (let n = 0; n < 4; n++) {
        await new Promise((resolve) => void setTimeout(resolve, 300));
        await watcher.redis.ping();
      }
    };
    await beats();
    net.swallow();
    await beats();
    expect(received).toEqual([]);
  });

  it("requests no key checks when Redis continues after a stall", async () => {
    const redis = await startTestRedis();
    const relay = await relayAt(redis.url, "relay-a");
    await relay.store.create({ id: ID, createdAt: 1, keys: [{ kind: "drive", hash: "d" }] });
    const { received } = await subscribe(relay);
    for (const stallMs of [600, 900]) {
      redis.stall();
      await new Promise((resolve) => void setTimeout(resolve, stallMs));
      redis.resume();
      // Checks that began during the stall end within a few responses of Redis.
      for (let n = 0; n < 5; n++) await relay.redis.ping();
    }
    expect(received).toEqual([]);
  });

  it("reports missed messages after its connection broke, and receives again", async () => {
    const [relay, other] = await twoRelays();
    await relay.store.create({ id: ID, createdAt: 1, keys: [{ kind: "drive", hash: "d" }] });
    const place = await subscribe(relay);
    await other.redis.sendCommand(["CLIENT", "KILL", "TYPE", "pubsub"]);
    await vi.waitFor(() => expect(place.missed).toHaveBeenCalled(), 5_000);
    // The other relay's connection was closed too, and may reconnect later.
    const back = await vi.waitFor(() => subscribe(other), 5_000);
    await back.add();
    await vi.waitFor(() => expect(place.steps).toEqual(["+1"]), 5_000);
  });
});
