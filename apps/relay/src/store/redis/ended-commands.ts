/** Reads ended commands of a robot, which are not in memory. */
import { z } from "zod";
import type { CommandRow } from "../../robots/commands/command-row.ts";
import type { RobotCommands } from "../../robots/commands/robot-commands.ts";
import type { PageState } from "../../robots/commands/steps.ts";
import { asked, type Redis } from "./connection.ts";
import { keyMember } from "./loaded-robot.ts";
import { endedOf, keysOf, openOf } from "./redis-keys.ts";
import { rowIn } from "./rows.ts";

const reply = z.tuple([z.string().nullable(), z.array(z.string())]);
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
export async function storedRow(redis: Redis, id: string, seq: number): Promise<CommandRow | null> {
  const both = redis.multi().hGet(openOf(id), String(seq)).zRangeByScore(endedOf(id), seq, seq);
  const [open, [ended = null]] = reply.parse(await asked(both.exec()));
  const text = open ?? ended;
  return text === null ? null : rowIn(text);
}

/** Commands with a higher seq, in order. */
export async function storedAfter(
  redis: Redis,
  id: string,
  { seq, limit }: { seq: number; limit: number },
): Promise<CommandRow[]> {
  const both = redis
    .multi()
    .hVals(openOf(id))
    .zRangeByScore(endedOf(id), `(${seq}`, "+inf", { LIMIT: { offset: 0, count: limit } });
  const [open, ended] = z.tuple([texts, texts]).parse(await asked(both.exec()));
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
  const reads = [
    ...reported.map(async (seq) => [await endedRow(redis, id, seq)]),
    mayWait ? endedAfter(redis, id, after) : [],
  ];
  return Promise.all(reads).then((rows) => rows.flat().filter((row) => row !== null));
}
