/** The connection to Redis or Valkey, and the mapping of its errors to store errors. */
import { createClient, ErrorReply } from "@redis/client";
import { z } from "zod";
import { StoreFull } from "../../platform/errors/disk-full.ts";
import { StoreUnavailableError } from "../../platform/errors/store-unavailable.ts";

const CONNECT_MS = 5_000;
/** Interval between pings, and timeout for a response. A disk may block Redis for two seconds. */
const PING_MS = 1_000;
const SILENCE_MS = 3_000;
/** Timeout for a connection without traffic, such as one whose handshake is never answered. */
const IDLE_MS = 6_000;
/** Reconnection delay: random, from 0 to a limit that doubles up to LONGEST_PAUSE_MS. */
const LONGEST_PAUSE_MS = 1_000;
const FIRST_PAUSE_MS = 50;

export type Redis = ReturnType<typeof redisAt>;

/**
 * Connects. The client reconnects automatically. Commands fail immediately while it is
 * disconnected, so that callers can ask their clients to retry.
 * @param log receives each error of a lost connection once
 * @throws Error if the server cannot be reached
 */
export async function connectRedis(url: string, log: (error: unknown) => void): Promise<Redis> {
  const redis = redisAt(url);
  let isConnected = false;
  let lastLogged: string | null = null;
  redis.on("ready", () => (lastLogged = null));
  redis.on("error", (error: unknown) => {
    const why = reasonOf(error);
    // While Redis is unavailable, each attempt to reconnect fails with the same error.
    if (!isConnected || why === lastLogged) return;
    lastLogged = why;
    log(error);
  });
  try {
    await redis.connect();
  } catch (error) {
    redis.destroy();
    throw new Error(
      `Cannot connect to Redis at ${new URL(url).host} (${reasonOf(error)}). Start Redis, or correct STORE_URL.`,
      { cause: error },
    );
  }
  isConnected = true;
  watch(redis, log);
  return redis;
}

function reasonOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}

/**
 * Pings the server and reconnects if there is no response. A connection can break without a
 * notification, and writing to it does not reveal that.
 */
function watch(redis: Redis, log: (error: unknown) => void): void {
  const again = (): void => void setTimeout(() => void look(), PING_MS).unref();
  const look = async (): Promise<void> => {
    // The caller has closed the client.
    if (!redis.isOpen) return;
    if (redis.isReady && !(await answers(redis)) && redis.isReady) {
      log(new Error(`Redis did not respond for ${SILENCE_MS} ms; reconnecting.`));
      redis.destroy();
      // Fails only if the client is closed meanwhile.
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
    // An error is also a response, or shows that the connection is broken.
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
        // At startup, a failed connection is reported instead of retried.
        if (!wasReady) return cause;
        return Math.random() * Math.min(LONGEST_PAUSE_MS, FIRST_PAUSE_MS * 2 ** tries);
      },
    },
  });
  redis.on("ready", () => (wasReady = true));
  return redis;
}

/** Time of the Redis server in ms since 1970. @throws StoreUnavailableError */
export async function timeOf(redis: Redis): Promise<number> {
  const answer = await asked(redis.sendCommand(["TIME"]));
  const [seconds, micros] = z.tuple([z.coerce.number(), z.coerce.number()]).parse(answer);
  return seconds * 1000 + micros / 1000;
}

/** @throws StoreFull or StoreUnavailableError for failures of Redis rather than of the step */
export async function asked<T>(answer: Promise<T>): Promise<T> {
  try {
    return await answer;
  } catch (error) {
    if (!(error instanceof ErrorReply)) throw new StoreUnavailableError(error);
    // OOM: the memory is full. MISCONF: Redis cannot write its files, usually because the disk is
    // full.
    if (/^(OOM|MISCONF)\b/.test(error.message)) throw new StoreFull();
    if (/^(LOADING|READONLY|MASTERDOWN|NOREPLICAS|BUSY)\b/.test(error.message)) {
      throw new StoreUnavailableError(error);
    }
    throw error;
  }
}
