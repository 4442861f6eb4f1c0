import { describe, expect, it, onTestFinished, vi } from "vitest";
import type { ClassListener } from "../../../../apps/relay/src/bus/class-bus.ts";
import { RedisClassBus } from "../../../../apps/relay/src/bus/redis-class-bus.ts";
import {
  twoRelaysCases,
  type RelayBackend,
} from "../../../../apps/relay/src/classes/two-relays.cases.ts";
import { connectRedis } from "../../../../apps/relay/src/store/redis/connection.ts";
import { DeletedBytes } from "../../../../apps/relay/src/store/redis/deleted-bytes.ts";
import { classChannelOf } from "../../../../apps/relay/src/store/redis/redis-keys.ts";
import { RedisClassStore } from "../../../../apps/relay/src/store/redis/redis-class-store.ts";
import { silentLog } from "../../../../apps/relay/src/testing/test-relay.ts";
import { hasRedis, startTestRedis } from "../../../support/relay/test-redis.ts";

const ID = "AAAAAAAAAAAAAAAAAAAAAA";
const SOON = { timeout: 10_000, interval: 100 };

async function relayAt(url: string, relay: string) {
  const connect = async () => {
    const connection = await connectRedis(url, () => undefined);
    onTestFinished(() => connection.destroy());
    return connection;
  };
  const [redis, subscriber] = [await connect(), await connect()];
  const bus = new RedisClassBus({ redis, subscriber, relay, log: silentLog });
  return { redis, bus, store: new RedisClassStore(redis, new DeletedBytes(redis)) };
}

async function twoRelays(): Promise<[RelayBackend, RelayBackend]> {
  const { url } = await startTestRedis();
  return [await relayAt(url, "a"), await relayAt(url, "b")];
}

describe.skipIf(!hasRedis)("with Redis", () => {
  twoRelaysCases("RedisClassBus", twoRelays);

  it("reports that messages may be missing after a broken connection, and ignores invalid ones", async () => {
    const server = await startTestRedis();
    const { bus, redis } = await relayAt(server.url, "a");
    const listener = {
      committed: vi.fn<ClassListener["committed"]>(),
      over: vi.fn<ClassListener["over"]>(),
      received: vi.fn<ClassListener["received"]>(),
      missed: vi.fn<ClassListener["missed"]>(),
    };
    await bus.join(ID, listener);
    await redis.publish(classChannelOf(ID), '{"kind":"unknown"}');
    await redis.publish(classChannelOf(ID), '{"kind":"over"}');
    await vi.waitFor(() => expect(listener.over).toHaveBeenCalledOnce());
    expect(
      [listener.committed, listener.received, listener.missed].map(({ mock }) => mock.calls),
    ).toEqual([[], [], []]);
    await server.stop();
    await server.restart();
    await vi.waitFor(() => expect(listener.missed).toHaveBeenCalledOnce(), SOON);
  });
});
