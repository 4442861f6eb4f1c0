/** Which database is behind the stores: SQLite, or the Redis or Valkey that STORE_URL names. */
import { join } from "node:path";
import type { Logger } from "pino";
import type { Config } from "../config.ts";
import { mintId } from "../keys.ts";
import type { DocumentStore } from "./document-store.ts";
import { connectRedis } from "./redis/connection.ts";
import { requireDurable } from "./redis/durability.ts";
import { ForgottenBytes } from "./redis/forgotten-bytes.ts";
import { RedisDocumentStore } from "./redis/redis-document-store.ts";
import { RedisSessionStore } from "./redis/redis-session-store.ts";
import type { SessionStore } from "./session-store.ts";
import { SqliteDocumentStore } from "./sqlite-document-store.ts";
import { SqliteFile } from "./sqlite-file.ts";
import { SqliteStore } from "./sqlite-store.ts";

export interface Stores {
  sessions: SessionStore;
  documents: DocumentStore;
  close(): Promise<void>;
}

/** @throws Error that says what is wrong with the database, for whoever starts the relay */
export async function openStores(
  { storeUrl, dataDir }: Pick<Config, "storeUrl" | "dataDir">,
  log: Logger,
): Promise<Stores> {
  return storeUrl === null ? sqliteStores(dataDir) : redisStores(storeUrl, log);
}

function sqliteStores(dataDir: string): Stores {
  const file = new SqliteFile(join(dataDir, "corridor.sqlite"));
  return {
    sessions: new SqliteStore(file),
    documents: new SqliteDocumentStore(file),
    close: async () => file.close(),
  };
}

async function redisStores(url: string, log: Logger): Promise<Stores> {
  const redis = await connectRedis(url, (error) => log.error({ err: error }, "Redis is away"));
  try {
    await requireDurable(redis);
  } catch (error) {
    redis.destroy();
    throw error;
  }
  const forgotten = new ForgottenBytes(redis);
  return {
    sessions: new RedisSessionStore(redis, forgotten, mintId()),
    documents: new RedisDocumentStore(redis, forgotten),
    close: async () => redis.destroy(),
  };
}
