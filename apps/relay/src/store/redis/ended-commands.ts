/** Reads ended commands of a robot, which are not in memory. */
import { z } from "zod";
import type { CommandRow } from "../../commands/command-row.ts";
import type { RobotCommands } from "../../commands/robot-commands.ts";
import type { PageState } from "../../commands/steps.ts";
import { asked, type Redis } from "./connection.ts";
import { keyMember } from "./loaded-robot.ts";
import { endedOf, keysOf, openOf } from "./redis-keys.ts";
import { rowIn } from "./rows.ts";
import type { Script } from "./script.ts";
import { counted } from "./words.ts";

const texts = z.array(z.string());

export async function endedRow(redis: Redis, id: string, seq: number): Promise<CommandRow | null> {
  const [text] = await asked(redis.zRangeByScore(endedOf(id), seq, seq));
  return text === undefined ? null : rowIn(text);
}

export async function endedAfter(redis: Redis, id: string, seq: number): Promise<CommandRow[]> {
  return (await asked(redis.zRangeByScore(endedOf(id), `(${seq}`, "+inf"))).map(rowIn);
}

/** The ended command with this idempotency key. */
export async function endedWithKey(
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
 * The ended commands that a page reports as ended, and those that may overtake a waiting one.
 * @returns null if the robot has none to look for
 */
export function endedForPage(
  redis: Redis,
  id: string,
  { commands, page }: { commands: RobotCommands; page: PageState },
): Promise<CommandRow[]> | null {
  const reported = page.endings.map(({ seq }) => seq).filter((seq) => commands.row(seq) === null);
  const mayWait = [...commands.open].some(({ state }) => state !== "started");
  if (reported.length === 0 && !mayWait) return null;
  const after = Math.max(page.lastApplied, commands.openFrom);
  const reads = reported.map(async (seq) => endedRow(redis, id, seq));
  const overtaking = mayWait ? endedAfter(redis, id, after) : Promise.resolve([]);
  return Promise.all([overtaking, ...reads]).then(([later, ...rows]) =>
    [...later, ...rows].filter((row) => row !== null),
  );
}
