/**
 * Robot sessions in Redis or Valkey, which several relays can share. Each step is a run of
 * `sessions.lua`, which also publishes its changes on the robot's channel, in order.
 */
import type { CommandRecord, Ending } from "@corridor/protocol";
import { z } from "zod";
import { StoreFull } from "../disk-full.ts";
import {
  CLOCK_TOLERANCE_MS,
  keyKinds,
  type AddResult,
  type AwayResult,
  type CancelResult,
  type EndResult,
  type KeyChange,
  type KeysResult,
  type KeyTimes,
  type KeyUse,
  type NewCommand,
  type PageState,
  type ScriptChange,
  type SessionStore,
  type StoredSession,
  type TermedRecord,
} from "../session-store.ts";
import { asked, type Redis } from "./connection.ts";
import type { ForgottenBytes } from "./forgotten-bytes.ts";
import { keysOf, sessionOf } from "./redis-keys.ts";
import { endingOf, recordRow, rowOf, termedRow } from "./rows.ts";
import { Script } from "./script.ts";

/** Sessions to delete per step, because each step blocks Redis. */
const MOST_AT_ONCE = 200;

const keysText = z
  .string()
  .transform((text): unknown => JSON.parse(text))
  .pipe(z.array(z.object({ kind: z.enum(keyKinds), hash: z.string() })));
const awayText = z
  .string()
  .transform((text): unknown => JSON.parse(text))
  .pipe(
    z.array(
      z.object({
        id: z.string(),
        driver: z.string(),
        name: z.string().nullable(),
        client: z.string(),
      }),
    ),
  );
const keyTimes = z.object({
  hash: z.string(),
  createdAt: z.number(),
  lastUsedAt: z.number().nullable(),
});
const sessionAnswer = z
  .object({
    epoch: z.int(),
    page: z.string(),
    createdAt: z.number(),
    lastUsedAt: z.number(),
    keys: keysText,
    away: awayText,
    isPaused: z.boolean(),
  })
  .nullable();
const changeAnswer = z.discriminatedUnion("outcome", [
  z.object({ outcome: z.literal("changed"), keys: keysText, ended: z.array(termedRow) }),
  z.object({ outcome: z.enum(["full", "no-session"]) }),
]);
const awayAnswer = z.discriminatedUnion("outcome", [
  z.object({ outcome: z.literal("changed"), away: awayText, ended: z.array(termedRow) }),
  z.object({ outcome: z.enum(["full", "no-session"]) }),
]);
const recalledAnswer = z.array(z.object({ seq: z.int(), reason: z.string() }));
const addAnswer = z.discriminatedUnion("outcome", [
  z.object({ outcome: z.literal("stored"), row: recordRow, ended: z.array(termedRow) }),
  z.object({ outcome: z.enum(["duplicate", "conflict"]), row: recordRow }),
  z.object({ outcome: z.enum(["full", "late", "revoked", "blocked", "paused", "no-session"]) }),
]);
const expireAnswer = z.object({ ended: z.array(termedRow), next: z.number().nullable() });
const cancelAnswer = z.discriminatedUnion("outcome", [
  z.object({ outcome: z.literal("cancelled"), row: termedRow }),
  z.object({ outcome: z.enum(["delivered", "over"]), row: recordRow }),
  z.object({ outcome: z.enum(["not-yours", "no-command"]) }),
]);
const endAnswer = z.discriminatedUnion("outcome", [
  z.object({ outcome: z.literal("ended"), row: recordRow }),
  z.object({ outcome: z.literal("over"), row: recordRow.nullable() }),
]);
const takeAnswer = z
  .object({ epoch: z.int(), changed: z.array(recordRow), refused: z.array(recordRow) })
  .nullable();

export class RedisSessionStore implements SessionStore {
  readonly #redis: Redis;
  readonly #script: Script;
  readonly #forgotten: ForgottenBytes;

  /**
   * @param redis closed by the caller
   * @param relay name of this relay, by which it recognises its own steps on the channel
   */
  constructor(redis: Redis, forgotten: ForgottenBytes, relay: string) {
    this.#redis = redis;
    this.#script = new Script(redis, "sessions.lua", [relay]);
    this.#forgotten = forgotten;
  }

  async create({
    id,
    createdAt,
    keys,
  }: Omit<StoredSession, "epoch" | "page" | "lastUsedAt" | "away" | "isPaused">) {
    await this.#step("create", id, { id, createdAt, keys: JSON.stringify(keys) });
  }

  async find(id: string): Promise<StoredSession | null> {
    const found = sessionAnswer.parse(await this.#step("find", id, { id }));
    return found === null ? null : { id, ...found };
  }

  async changeKeys(id: string, change: KeyChange): Promise<KeysResult> {
    return changeAnswer.parse(await this.#step("changeKeys", id, change));
  }

  async changeAway(id: string, { add, remove, ...rest }: ScriptChange): Promise<AwayResult> {
    // As text, because Lua encodes an empty list as an object.
    const script = add === null ? null : JSON.stringify(add);
    const values = { add: script, id: add?.id ?? remove, ...rest };
    return awayAnswer.parse(await this.#step("changeAway", id, values));
  }

  async pause(id: string, isPaused: boolean, reason: string): Promise<TermedRecord[] | null> {
    return z
      .array(termedRow)
      .nullable()
      .parse(await this.#step("pause", id, { isPaused, reason }));
  }

  async keepMaze(id: string, text: string): Promise<boolean> {
    return z.boolean().parse(await this.#step("keepMaze", id, { text }));
  }

  async maze(id: string): Promise<string | null> {
    return (await asked(this.#redis.hGet(sessionOf(id), "maze"))) ?? null;
  }

  async keyTimes(id: string): Promise<KeyTimes[]> {
    return z.array(keyTimes).parse(await this.#step("keyTimes", id, {}));
  }

  async touch(id: string, now: number, keys: readonly KeyUse[]): Promise<void> {
    await this.#step("touch", id, { id, now, keys });
  }

  async remove(id: string): Promise<boolean> {
    const removed = z.boolean().parse(await this.#step("remove", id, { id }));
    if (removed) await this.#forgotten.sweep();
    return removed;
  }

  async removeExpired(before: { lastUsedAt: number; createdAt: number }): Promise<string[]> {
    const all: string[] = [];
    for (;;) {
      const values = { ...before, most: MOST_AT_ONCE };
      const ids = z.array(z.string()).parse(await this.#step("removeExpired", "", values));
      all.push(...ids);
      if (ids.length < MOST_AT_ONCE) break;
    }
    if (all.length > 0) await this.#forgotten.sweep();
    return all;
  }

  async add(id: string, command: NewCommand): Promise<AddResult> {
    const { maxWaiting, keep } = command;
    const values = { row: rowOf(command), maxWaiting, keep };
    const answer = addAnswer.parse(await this.#step("add", id, values));
    if (!("row" in answer)) return answer;
    const { row: record, ...rest } = answer;
    return { ...rest, record };
  }

  async deliver(id: string, epoch: number, window: number, now: number): Promise<TermedRecord[]> {
    const values = { epoch, window, now, tolerance: CLOCK_TOLERANCE_MS };
    return z.array(termedRow).parse(await this.#step("deliver", id, values));
  }

  /** Always false: another relay may have changed the session. */
  hasAll(): boolean {
    return false;
  }

  async expire(id: string, now: number): Promise<{ ended: TermedRecord[]; next: number | null }> {
    const values = { now, tolerance: CLOCK_TOLERANCE_MS };
    return expireAnswer.parse(await this.#step("expire", id, values));
  }

  async cancel(
    id: string,
    seq: number,
    by: { driver: string; reason: string },
  ): Promise<CancelResult> {
    const answer = cancelAnswer.parse(await this.#step("cancel", id, { seq, ...by }));
    if (answer.outcome === "cancelled") return { outcome: answer.outcome, termed: answer.row };
    return "row" in answer ? { outcome: answer.outcome, record: answer.row } : answer;
  }

  async start(id: string, epoch: number, seq: number): Promise<CommandRecord | null> {
    return recordRow.nullable().parse(await this.#step("start", id, { epoch, seq }));
  }

  async end(id: string, epoch: number, ending: Ending): Promise<EndResult> {
    const values = { epoch, ending: endingOf(ending) };
    const { row: record, outcome } = endAnswer.parse(await this.#step("finish", id, values));
    return outcome === "ended" ? { outcome, record } : { outcome, record };
  }

  async abandon(id: string, epoch: number, reason: string): Promise<CommandRecord[] | null> {
    return z
      .array(recordRow)
      .nullable()
      .parse(await this.#step("abandon", id, { epoch, reason }));
  }

  async takeOver(id: string, { endings, page = "", ...state }: PageState) {
    const { lastApplied, fresh, settled, left, pose } = state;
    const told = { lastApplied, fresh, settled, left, page, endings: endings.map(endingOf) };
    const where = pose === null ? null : JSON.stringify(pose);
    return takeAnswer.parse(await this.#step("takeOver", id, { ...told, pose: where }));
  }

  async command(id: string, seq: number): Promise<CommandRecord | null> {
    return recordRow.nullable().parse(await this.#step("command", id, { seq }));
  }

  async commandsAfter(id: string, seq: number, limit: number): Promise<CommandRecord[]> {
    const rows = z.array(recordRow).parse(await this.#step("after", id, { seq, limit }));
    return rows.slice(0, limit);
  }

  async openCommands(id: string): Promise<CommandRecord[]> {
    return z.array(recordRow).parse(await this.#step("open", id, {}));
  }

  async recalled(id: string): Promise<{ seq: number; reason: string }[]> {
    return recalledAnswer.parse(await this.#step("recalled", id, {}));
  }

  async check(): Promise<"ok" | "full"> {
    try {
      await asked(this.#redis.set("corridor:check", "written"));
      return "ok";
    } catch (error) {
      if (error instanceof StoreFull) return "full";
      throw error;
    }
  }

  async close(): Promise<void> {
    // Other stores share the connection.
  }

  async #step(name: string, id: string, values: unknown): Promise<unknown> {
    return this.#script.run(name, keysOf(id), values);
  }
}
