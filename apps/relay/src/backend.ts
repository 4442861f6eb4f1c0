/**
 * Storage and messaging of a relay: SQLite for a single relay, or the Redis or Valkey at STORE_URL,
 * which several relays can share.
 */
import { join } from "node:path";
import type { Logger } from "pino";
import type { Clock } from "./platform/time/clock.ts";
import { LocalBus } from "./bus/local.ts";
import { RedisBus } from "./bus/redis.ts";
import type { Bus } from "./bus/bus.ts";
import type { ClassBus } from "./bus/class-bus.ts";
import { LocalClassBus } from "./bus/local-class-bus.ts";
import { RedisClassBus } from "./bus/redis-class-bus.ts";
import type { Config } from "./config.ts";
import { mintId } from "./platform/keys.ts";
import type { ClassStore } from "./store/class-store.ts";
import type { DocumentStore } from "./store/document-store.ts";
import type { PairingStore } from "./store/pairing-store.ts";
import { connectRedis, timeOf, type Redis } from "./store/redis/connection.ts";
import { requireDurable } from "./store/redis/durability.ts";
import { DeletedBytes } from "./store/redis/deleted-bytes.ts";
import { RedisClassStore } from "./store/redis/redis-class-store.ts";
import { RedisClock } from "./store/redis/redis-clock.ts";
import { RedisDocumentStore } from "./store/redis/redis-document-store.ts";
import { RedisPairingStore } from "./store/redis/redis-pairing-store.ts";
import { RedisRobotStore } from "./store/redis/redis-robot-store.ts";
import type { RobotStore } from "./store/robot-store.ts";
import { SqliteClassStore } from "./store/sqlite/sqlite-class-store.ts";
import { SqliteDocumentStore } from "./store/sqlite/sqlite-document-store.ts";
import { SqliteFile } from "./store/sqlite/file/sqlite-file.ts";
import { SqlitePairingStore } from "./store/sqlite/sqlite-pairing-store.ts";
import { SqliteRobotStore } from "./store/sqlite/sqlite-robot-store.ts";

export interface Backend {
  /** clock that produces and compares stored times */
  clock: Clock;
  robots: RobotStore;
  documents: DocumentStore;
  pairings: PairingStore;
  classes: ClassStore;
  bus: Bus;
  classBus: ClassBus;
  close(): Promise<void>;
}

/** @throws Error whose message describes the problem with the database for the operator */
export async function openBackend(
  { storeUrl, dataDir }: Pick<Config, "storeUrl" | "dataDir">,
  clock: Clock,
  log: Logger,
): Promise<Backend> {
  return storeUrl === null
    ? sqliteBackend(dataDir, clock, log)
    : redisBackend(storeUrl, clock, log);
}

function sqliteBackend(dataDir: string, clock: Clock, log: Logger): Backend {
  const file = new SqliteFile(join(dataDir, "corridor.sqlite"), {
    setAside: (to) => {
      log.error(
        { path: to },
        "the database was damaged and moved here; the relay starts with a new one",
      );
    },
  });
  return {
    clock,
    robots: new SqliteRobotStore(file),
    documents: new SqliteDocumentStore(file),
    pairings: new SqlitePairingStore(file),
    classes: new SqliteClassStore(file),
    bus: new LocalBus(),
    classBus: new LocalClassBus(),
    close: async () => file.close(),
  };
}

async function redisBackend(url: string, machine: Clock, log: Logger): Promise<Backend> {
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
