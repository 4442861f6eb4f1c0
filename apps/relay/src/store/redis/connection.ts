/** The connection to Redis or Valkey, and what its errors mean to whoever waits for a store. */
import { createClient, ErrorReply } from "@redis/client";
import { z } from "zod";
import { StoreFull } from "../disk-full.ts";
import { StoreAway } from "../store-away.ts";

const CONNECT_MS = 5_000;
/** Pause between signs of life, and the longest wait for one: a disk may hold Redis up for two seconds. */
const PING_MS = 1_000;
const SILENCE_MS = 3_000;
/** For a line on which nothing is written, such as one whose greeting is never answered. */
const IDLE_MS = 6_000;
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
    throw new Error(
      `Cannot connect to Redis at ${new URL(url).host} (${why}). Start Redis, or correct STORE_URL.`,
      { cause: error },
    );
  }
  isConnected = true;
  watch(redis, log);
  return redis;
}

/**
 * A line may be cut without a word, and whoever still writes to it never learns of it: the line is asked
 * for a sign of life, and made anew where none comes.
 */
function watch(redis: Redis, log: (error: unknown) => void): void {
  const again = (): void => void setTimeout(() => void look(), PING_MS).unref();
  const look = async (): Promise<void> => {
    // Whoever opened it has closed it.
    if (!redis.isOpen) return;
    if (redis.isReady && !(await answers(redis)) && redis.isReady) {
      log(new Error(`Redis did not respond for ${SILENCE_MS} ms; reconnecting.`));
      redis.destroy();
      // Given up only when it is closed meanwhile.
      redis.connect().catch(() => undefined);
    }
    again();
  };
  again();
}

async function answers(redis: Redis): Promise<boolean> {
  const silence = new Promise<false>((resolve) => {
    setTimeout(() => resolve(false), SILENCE_MS).unref();
  });
  const answer = redis.ping().then(
    () => true,
    // An error is an answer, or the line is known to be broken.
    () => true,
  );
  return Promise.race([answer, silence]);
}

function redisAt(url: string) {
  let wasReady = false;
  const redis = createClient({
    url,
    disableOfflineQueue: true,
    socket: {
      connectTimeout: CONNECT_MS,
      socketTimeout: IDLE_MS,
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
