/** Checks at startup that Redis is configured to persist data. Later, data may already be lost. */
import { ErrorReply } from "@redis/client";
import type { Redis } from "./connection.ts";

/** @throws Error that states which setting to change */
export async function requireDurable(redis: Redis): Promise<void> {
  if (valueIn(await redis.info("persistence"), "aof_enabled") !== "1") {
    throw new Error(
      "the Redis at STORE_URL has no append-only file, so its restart would lose acknowledged commands. " +
        "Start it with: redis-server --appendonly yes --appendfsync everysec",
    );
  }
  if ((await setting(redis, "appendfsync")) === "no") {
    throw new Error(
      "the Redis at STORE_URL does not sync its append-only file to disk (appendfsync no). " +
        "Set it to everysec or always: redis-cli CONFIG SET appendfsync everysec",
    );
  }
  const memory = await redis.info("memory");
  const policy = valueIn(memory, "maxmemory_policy");
  if (valueIn(memory, "maxmemory") !== "0" && policy !== "noeviction") {
    throw new Error(
      `the Redis at STORE_URL evicts keys when its memory is full (maxmemory-policy ${policy}). ` +
        "Set it to noeviction: redis-cli CONFIG SET maxmemory-policy noeviction",
    );
  }
}

/** The value of a field in the response to INFO, or null. */
export function valueIn(info: string, field: string): string | null {
  const line = info.split(/\r?\n/).find((each) => each.startsWith(`${field}:`));
  return line?.slice(field.length + 1).trim() ?? null;
}

async function setting(redis: Redis, name: string): Promise<string | null> {
  try {
    return (await redis.configGet(name))[name] ?? null;
  } catch (error) {
    // Providers of hosted Redis may forbid reading the settings.
    if (error instanceof ErrorReply) return null;
    throw error;
  }
}
