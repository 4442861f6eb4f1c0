/** Storage and messaging of a relay that shares a Redis or Valkey with others. */
import type { Logger } from "pino";
import type { Backend } from "./backend.ts";
import { RedisBus } from "./bus/redis.ts";
import { RedisClassBus } from "./bus/redis-class-bus.ts";
import { mintId } from "./platform/keys.ts";
import type { Clock } from "./platform/time/clock.ts";
import { connectRedis, timeOf, type Redis } from "./store/redis/connection.ts";
import { DeletedBytes } from "./store/redis/deleted-bytes.ts";
import { requireDurable } from "./store/redis/durability.ts";
import { RedisClassStore } from "./store/redis/redis-class-store.ts";
import { RedisClock } from "./store/redis/redis-clock.ts";
import { RedisDocumentStore } from "./store/redis/redis-document-store.ts";
import { RedisPairingStore } from "./store/redis/redis-pairing-store.ts";
import { RedisRobotStore } from "./store/redis/redis-robot-store.ts";

/** @throws Error whose message describes the problem with the database for the operator */
export async function redisBackend(url: string, machine: Clock, log: Logger): Promise<Backend> {
  const connections: Redis[] = [];
  const connect = async (): Promise<Redis> => {
    const redis = await connectRedis(url, (error) =>
      log.error({ err: error }, "Redis is unavailable"),
    );
    connections.push(redis);
    return redis;
  };
  const disconnect = (): void => {
    for (const redis of connections) redis.destroy();
  };
  try {
    const redis = await connect();
    await requireDurable(redis);
    const subscriber = await connect();
    const relay = mintId();
    const clock = await RedisClock.open({ clock: machine, log, ask: async () => timeOf(redis) });
    const bus = await RedisBus.open({ redis, subscriber, relay, clock, log });
    const deletedBytes = new DeletedBytes(redis);
    return {
      clock,
      robots: new RedisRobotStore(redis, deletedBytes, relay),
      documents: new RedisDocumentStore(redis, deletedBytes),
      pairings: new RedisPairingStore(redis, deletedBytes),
      classes: new RedisClassStore(redis, deletedBytes),
      bus,
      classBus: new RedisClassBus({ redis, subscriber, relay, log }),
      close: async () => {
        clock.close();
        await bus.close();
        disconnect();
      },
    };
  } catch (error) {
    disconnect();
    throw error;
  }
}
