/** Reads commands of a robot, of which only the open ones are in memory. */
import type { CommandRecord } from "@corridor/protocol";
import { z } from "zod";
import type { CommandRow, RobotCommands } from "../../commands/robot-commands.ts";
import { conditionsEndAt, shownRecord } from "../../commands/stored-conditions.ts";
import type { Lookup } from "../../commands/robot-step.ts";
import { asked, type Redis } from "./connection.ts";
import { keyMember, type Found } from "./loaded-robot.ts";
import { endedOf, keysOf, openOf, robotKeyOf } from "./redis-keys.ts";
import { rowIn } from "./rows.ts";
import type { Script } from "./script.ts";
import { isHeldElsewhere } from "./stored-robots.ts";
import { counted } from "./words.ts";

const texts = z.array(z.string());
const seqs = z.array(z.coerce.number());
/** null: there is no such robot */
const lastSeq = z.coerce.number();

async function endedRow(redis: Redis, id: string, seq: number): Promise<CommandRow | null> {
  const [text] = await asked(redis.zRangeByScore(endedOf(id), seq, seq));
  return text === undefined ? null : rowIn(text);
}

async function endedAfter(
  redis: Redis,
  id: string,
  seq: number,
  upTo: number | "+inf" = "+inf",
): Promise<CommandRow[]> {
  return (await asked(redis.zRangeByScore(endedOf(id), `(${seq}`, upTo))).map(rowIn);
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
export async function storedCommand(
  read: Script,
  id: string,
  seq: number,
): Promise<CommandRecord | null> {
  const at = String(seq);
  const replies = await read.call(
    [robotKeyOf(id), openOf(id), endedOf(id)],
    counted([
      ["HGET", robotKeyOf(id), "seq"],
      ["HKEYS", openOf(id)],
      ["HGET", openOf(id), at],
      ["ZRANGEBYSCORE", endedOf(id), at, at],
    ]),
  );
  const reply = z.tuple([lastSeq, seqs, z.string().nullable(), texts]).parse(replies);
  const [last, openSeqs, open, [ended = null]] = reply;
  const text = open ?? ended;
  return text === null ? null : shownRecord(rowIn(text), () => conditionsEndAt(last, openSeqs));
}

/** Commands with a higher seq, in order. */
export async function storedAfter(
  read: Script,
  id: string,
  { seq, limit }: { seq: number; limit: number },
): Promise<CommandRecord[]> {
  const replies = await read.call(
    [robotKeyOf(id), openOf(id), endedOf(id)],
    counted([
      ["HGET", robotKeyOf(id), "seq"],
      ["HVALS", openOf(id)],
      ["ZRANGEBYSCORE", endedOf(id), `(${seq}`, "+inf", "LIMIT", "0", String(limit)],
    ]),
  );
  const [last, openTexts, ended] = z.tuple([lastSeq, texts, texts]).parse(replies);
  const open = openTexts.map(rowIn);
  const rows = [...open, ...ended.map(rowIn)].filter((row) => row.seq > seq);
  const endAt = (): number =>
    conditionsEndAt(
      last,
      open.map((row) => row.seq),
    );
  const found = rows.toSorted((a, b) => a.seq - b.seq).slice(0, limit);
  return found.map((row) => shownRecord(row, endAt));
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
  const { key = null, after = null, ended = null, holder = false, isPresent } = lookup;
  const { seqs: wanted = [] } = lookup;
  const one = wanted
    .filter((seq) => commands.row(seq) === null)
    .map((seq) => endedRow(redis, id, seq));
  if (key !== null && isPresent) one.push(endedWithKey(redis, id, key));
  if (one.length === 0 && after === null && ended === null && !holder) return null;
  const later = after === null ? [] : endedAfter(redis, id, after);
  const old = ended === null ? [] : endedAfter(redis, id, ended.after, ended.upTo);
  const held = holder && isHeldElsewhere(holders, id, relay);
  return Promise.all([later, old, held, ...one]).then(([rows, oldRows, isHeld, ...others]) => ({
    rows: [...rows, ...oldRows, ...others].filter((row) => row !== null),
    isHeldElsewhere: isHeld,
  }));
}
