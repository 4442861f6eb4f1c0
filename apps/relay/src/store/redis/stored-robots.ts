/** Reads robots and the times of their keys. */
import { z } from "zod";
import { asked, type Redis } from "./connection.ts";
import type { KeyTimes, StoredRobot } from "../robot-store.ts";
import { channelOf, madeAt, RELAYS, robotKeyOf, usedAt, USES } from "./redis-keys.ts";
import type { Script } from "./script.ts";
import { blockedText, keysText } from "./permission-texts.ts";
import { counted } from "./words.ts";

const text = z.string().nullable();
const isThere = z.tuple([z.tuple([z.string()], z.unknown())], z.unknown());
const robotReply = z.tuple([
  z.tuple([
    z.string(),
    z.coerce.number(),
    z.coerce.number(),
    keysText,
    blockedText.nullable(),
    text,
    text,
    text,
  ]),
  z.coerce.number(),
]);
const holderReply = z.object({ relay: z.string() }).nullable();

export async function robotIn(read: Script, id: string): Promise<StoredRobot | null> {
  const fields = ["version", "epoch", "createdAt", "keys", "blocked", "paused", "name", "mayReset"];
  const replies = await read.call(
    [robotKeyOf(id), USES],
    counted([
      ["HMGET", robotKeyOf(id), ...fields],
      ["ZSCORE", USES, id],
    ]),
  );
  if (!isThere.safeParse(replies).success) return null;
  const [found, lastUsedAt] = robotReply.parse(replies);
  const [, epoch, createdAt, keys, blocked, paused, page, mayReset] = found;
  return {
    id,
    epoch,
    page: page ?? "",
    createdAt,
    lastUsedAt,
    keys,
    blocked: blocked ?? [],
    isPaused: paused === "1",
    mayReset: mayReset !== "0",
  };
}

export async function keyTimesIn(redis: Redis, id: string): Promise<KeyTimes[]> {
  const [keys, createdAt] = await asked(redis.hmGet(robotKeyOf(id), ["keys", "createdAt"]));
  if (keys === null || keys === undefined) return [];
  const hashes = keysText.parse(keys).map(({ hash }) => hash);
  if (hashes.length === 0) return [];
  const fields = hashes.flatMap((hash) => [madeAt(hash), usedAt(hash)]);
  const times = await asked(redis.hmGet(robotKeyOf(id), fields));
  return hashes.map((hash, index) => {
    const [made, used] = times.slice(2 * index, 2 * index + 2);
    // A key that was revoked meanwhile has no times.
    return {
      hash,
      createdAt: Number(made ?? createdAt),
      lastUsedAt: used === null || used === undefined ? null : Number(used),
    };
  });
}

/** When each of these keys was last used, as far as recorded. */
export async function usesIn(
  redis: Redis,
  id: string,
  hashes: readonly string[],
): Promise<Map<string, number>> {
  const times = await asked(redis.hmGet(robotKeyOf(id), hashes.map(usedAt)));
  return new Map(hashes.map((hash, index) => [hash, Number(times[index] ?? 0)]));
}

/**
 * Whether a running relay other than this one is connected to the robot's page.
 * @param holders runs page-holders.lua
 */
export async function isHeldElsewhere(
  holders: Script,
  id: string,
  relay: string,
): Promise<boolean> {
  const keys = [robotKeyOf(id), channelOf(id), RELAYS];
  const holder = holderReply.parse(await holders.run("holder", keys, {}));
  return holder !== null && holder.relay !== relay;
}
