/** What stands behind a relay: SQLite, or the Redis or Valkey that STORE_URL names, which others may share. */
import { join } from "node:path";
import type { Logger } from "pino";
import type { Clock } from "./clock.ts";
import { LocalSwitchboard } from "./cluster/local-switchboard.ts";
import { RedisSwitchboard } from "./cluster/redis-switchboard.ts";
import type { Switchboard } from "./cluster/switchboard.ts";
import type { Config } from "./config.ts";
import { mintId } from "./keys.ts";
import type { DocumentStore } from "./store/document-store.ts";
import type { PairingStore } from "./store/pairing-store.ts";
import { connectRedis, timeOf, type Redis } from "./store/redis/connection.ts";
import { requireDurable } from "./store/redis/durability.ts";
import { ForgottenBytes } from "./store/redis/forgotten-bytes.ts";
import { RedisClock } from "./store/redis/redis-clock.ts";
import { RedisDocumentStore } from "./store/redis/redis-document-store.ts";
import { RedisPairingStore } from "./store/redis/redis-pairing-store.ts";
import { RedisSessionStore } from "./store/redis/redis-session-store.ts";
import type { SessionStore } from "./store/session-store.ts";
import { SqliteDocumentStore } from "./store/sqlite-document-store.ts";
import { SqliteFile } from "./store/sqlite-file.ts";
import { SqlitePairingStore } from "./store/sqlite-pairing-store.ts";
import { SqliteStore } from "./store/sqlite-store.ts";

export interface Backing {
  /** the time that whatever is stored is compared by */
  clock: Clock;
  sessions: SessionStore;
  documents: DocumentStore;
  pairings: PairingStore;
  switchboard: Switchboard;
  close(): Promise<void>;
}

/** @throws Error that says what is wrong with the database, for whoever starts the relay */
export async function openBacking(
  { storeUrl, dataDir }: Pick<Config, "storeUrl" | "dataDir">,
  clock: Clock,
  log: Logger,
): Promise<Backing> {
  return storeUrl === null
    ? sqliteBacking(dataDir, clock, log)
    : redisBacking(storeUrl, clock, log);
}

function sqliteBacking(dataDir: string, clock: Clock, log: Logger): Backing {
  const file = new SqliteFile(join(dataDir, "corridor.sqlite"), {
    isThreaded: true,
    setAside: (to) => {
      log.error(
        { path: to },
        "the database was damaged and moved here; the relay starts with a new one",
      );
    },
  });
  return {
    clock,
    sessions: new SqliteStore(file),
    documents: new SqliteDocumentStore(file),
    pairings: new SqlitePairingStore(file),
    switchboard: new LocalSwitchboard(),
    close: async () => file.close(),
  };
}

async function redisBacking(url: string, machine: Clock, log: Logger): Promise<Backing> {
  const connections: Redis[] = [];
  const connect = async (): Promise<Redis> => {
    const redis = await connectRedis(url, (error) => log.error({ err: error }, "Redis is away"));
    connections.push(redis);
    return redis;
  };
  const disconnect = (): void => {
    for (const redis of connections) redis.destroy();
  };
  try {
    const redis = await connect();
    await requireDurable(redis);
    const hearing = await connect();
    const relay = mintId();
    const clock = await RedisClock.open({ clock: machine, log, ask: async () => timeOf(redis) });
    const switchboard = await RedisSwitchboard.open({ redis, hearing, relay, clock, log });
    const forgotten = new ForgottenBytes(redis);
    return {
      clock,
      sessions: new RedisSessionStore(redis, forgotten, relay),
      documents: new RedisDocumentStore(redis, forgotten),
      pairings: new RedisPairingStore(redis, forgotten),
      switchboard,
      close: async () => {
        clock.close();
        await switchboard.close();
        disconnect();
      },
    };
  } catch (error) {
    disconnect();
    throw error;
  }
}
