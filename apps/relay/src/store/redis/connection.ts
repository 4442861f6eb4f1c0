/** The connection to Redis or Valkey, and what its errors mean to whoever waits for a store. */
import { createClient, ErrorReply } from "@redis/client";
import { z } from "zod";
import { StoreFull } from "../disk-full.ts";
import { StoreAway } from "../store-away.ts";

const CONNECT_MS = 5_000;
/** Pause before a new try, drawn from 0 to a limit that doubles up to this one. */
const LONGEST_PAUSE_MS = 1_000;
const FIRST_PAUSE_MS = 50;

export type Redis = ReturnType<typeof redisAt>;

/**
 * Connects. A lost connection is mended by itself; what is asked meanwhile fails at once, so that
 * whoever waits can be told to come back.
 * @param log is told of a connection that breaks
 * @throws Error when nobody answers there
 */
export async function connectRedis(url: string, log: (error: unknown) => void): Promise<Redis> {
  const redis = redisAt(url);
  let isConnected = false;
  redis.on("error", (error: unknown) => {
    if (isConnected) log(error);
  });
  try {
    await redis.connect();
  } catch (error) {
    redis.destroy();
    const why = error instanceof Error ? error.message : String(error);
    throw new Error(`STORE_URL leads to no Redis that answers (${why}).`, { cause: error });
  }
  isConnected = true;
  return redis;
}

function redisAt(url: string) {
  let wasReady = false;
  const redis = createClient({
    url,
    disableOfflineQueue: true,
    socket: {
      connectTimeout: CONNECT_MS,
      reconnectStrategy: (tries, cause) => {
        // At the start nobody waits for a Redis that may never come.
        if (!wasReady) return cause;
        return Math.random() * Math.min(LONGEST_PAUSE_MS, FIRST_PAUSE_MS * 2 ** tries);
      },
    },
  });
  redis.on("ready", () => (wasReady = true));
  return redis;
}

/** ms since 1970, as Redis believes. @throws StoreAway */
export async function timeOf(redis: Redis): Promise<number> {
  const answer = await asked(redis.sendCommand(["TIME"]));
  const [seconds, micros] = z.tuple([z.coerce.number(), z.coerce.number()]).parse(answer);
  return seconds * 1000 + micros / 1000;
}

/** @throws StoreFull or StoreAway for what Redis, not the step, is to blame for */
export async function asked<T>(answer: Promise<T>): Promise<T> {
  try {
    return await answer;
  } catch (error) {
    if (!(error instanceof ErrorReply)) throw new StoreAway(error);
    // OOM: its memory is full. MISCONF: it cannot write its files, most often for want of room.
    if (/^(OOM|MISCONF)\b/.test(error.message)) throw new StoreFull();
    if (/^(LOADING|READONLY|MASTERDOWN|NOREPLICAS|BUSY)\b/.test(error.message)) {
      throw new StoreAway(error);
    }
    throw error;
  }
}
