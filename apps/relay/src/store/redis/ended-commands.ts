/** Reads commands of a robot, of which only the open ones are in memory. */
import { z } from "zod";
import type { CommandRow } from "../../commands/command-row.ts";
import type { RobotCommands } from "../../commands/robot-commands.ts";
import type { Lookup } from "../../commands/robot-state.ts";
import { asked, type Redis } from "./connection.ts";
import { keyMember, type Found } from "./loaded-robot.ts";
import { endedOf, keysOf, openOf } from "./redis-keys.ts";
import { rowIn } from "./rows.ts";
import type { Script } from "./script.ts";
import { isHeldElsewhere } from "./stored-robots.ts";
import { counted } from "./words.ts";

const texts = z.array(z.string());

async function endedRow(redis: Redis, id: string, seq: number): Promise<CommandRow | null> {
  const [text] = await asked(redis.zRangeByScore(endedOf(id), seq, seq));
  return text === undefined ? null : rowIn(text);
}

async function endedAfter(redis: Redis, id: string, seq: number): Promise<CommandRow[]> {
  return (await asked(redis.zRangeByScore(endedOf(id), `(${seq}`, "+inf"))).map(rowIn);
}

/** The ended command with this idempotency key. */
async function endedWithKey(
  redis: Redis,
  id: string,
  { driver, key }: { driver: string; key: string },
): Promise<CommandRow | null> {
  const seq = await asked(redis.zScore(keysOf(id), keyMember(driver, key)));
  return seq === null ? null : endedRow(redis, id, seq);
}

/** The command in its stored state, whether or not it has ended. */
export async function storedRow(read: Script, id: string, seq: number): Promise<CommandRow | null> {
  const at = String(seq);
  const replies = await read.call(
    [openOf(id), endedOf(id)],
    counted([
      ["HGET", openOf(id), at],
      ["ZRANGEBYSCORE", endedOf(id), at, at],
    ]),
  );
  const [open, [ended = null]] = z.tuple([z.string().nullable(), texts]).parse(replies);
  const text = open ?? ended;
  return text === null ? null : rowIn(text);
}

/** Commands with a higher seq, in order. */
export async function storedAfter(
  read: Script,
  id: string,
  { seq, limit }: { seq: number; limit: number },
): Promise<CommandRow[]> {
  const replies = await read.call(
    [openOf(id), endedOf(id)],
    counted([
      ["HVALS", openOf(id)],
      ["ZRANGEBYSCORE", endedOf(id), `(${seq}`, "+inf", "LIMIT", "0", String(limit)],
    ]),
  );
  const [open, ended] = z.tuple([texts, texts]).parse(replies);
  const rows = [...open, ...ended].map(rowIn).filter((row) => row.seq > seq);
  return rows.toSorted((a, b) => a.seq - b.seq).slice(0, limit);
}

/** The commands that have not ended, in order. */
export async function storedOpen(redis: Redis, id: string): Promise<CommandRow[]> {
  const open = await asked(redis.hVals(openOf(id)));
  return open.map(rowIn).toSorted((a, b) => a.seq - b.seq);
}

/**
 * Finds what a step needs and memory lacks.
 * @param lookup `isPresent`: the index by idempotency key contains the key of the command
 * @returns null if it lacks nothing
 */
export function lookUp(
  { redis, holders, id, relay }: { redis: Redis; holders: Script; id: string; relay: string },
  commands: RobotCommands,
  lookup: Lookup & { isPresent: boolean },
): Promise<Found> | null {
  const { seqs = [], key = null, after = null, holder = false, isPresent } = lookup;
  const one = seqs
    .filter((seq) => commands.row(seq) === null)
    .map((seq) => endedRow(redis, id, seq));
  if (key !== null && isPresent) one.push(endedWithKey(redis, id, key));
  if (one.length === 0 && after === null && !holder) return null;
  const later = after === null ? [] : endedAfter(redis, id, after);
  const held = holder && isHeldElsewhere(holders, id, relay);
  return Promise.all([later, held, ...one]).then(([rows, isHeld, ...others]) => ({
    rows: [...rows, ...others].filter((row) => row !== null),
    isHeldElsewhere: isHeld,
  }));
}
