/**
 * The default store: one SQLite file, by the SQLite that is built into Node.
 *
 * The calls are synchronous inside, so each transaction is over before anything else runs. They are
 * short on purpose: rows of one robot by index. Only the sweep for sessions that ran out, once a
 * minute, reads through the sessions (not their commands).
 */
import type { DatabaseSync, SQLInputValue, StatementSync } from "node:sqlite";
import { commandRecordSchema, type CommandRecord, type Ending } from "@corridor/protocol";
import { z } from "zod";
import { isDiskFull, takeRoom } from "./disk-full.ts";
import type {
  AddResult,
  NewCommand,
  PageState,
  SessionStore,
  StoredSession,
} from "./session-store.ts";
import { IS_OPEN, OPEN_COMMANDS, openDatabase } from "./sqlite-schema.ts";
import { forgetDeleted, inTransaction } from "./sqlite-writing.ts";

const sessionRow = z.object({
  id: z.string(),
  epoch: z.int(),
  last_seq: z.int(),
  created_at: z.int(),
  last_used_at: z.int(),
});
const keyRow = z.object({ hash: z.string(), kind: z.enum(["own", "drive"]) });
const commandRow = z.object({
  seq: z.int(),
  key: z.string().nullable(),
  command: z.string(),
  state: z.string(),
  reason: z.string().nullable(),
  accepted_at: z.int(),
  pose: z.string().nullable(),
  distance: z.number().nullable(),
});

const COLUMNS = "seq, key, command, state, reason, accepted_at, pose, distance";
const STOP = '{"action":"stop"}';

export class SqliteStore implements SessionStore {
  readonly #db: DatabaseSync;
  readonly #statements = new Map<string, StatementSync>();

  /** @param file path of the database, made with its folder when it is missing */
  constructor(file: string) {
    this.#db = openDatabase(file);
  }

  async create({ id, createdAt, keys }: Omit<StoredSession, "epoch" | "lastUsedAt">) {
    inTransaction(this.#db, () => {
      this.#run("INSERT INTO sessions (id, created_at, last_used_at) VALUES (?, ?, ?)", [
        id,
        createdAt,
        createdAt,
      ]);
      for (const { hash, kind } of keys) {
        this.#run("INSERT INTO keys (robot, hash, kind) VALUES (?, ?, ?)", [id, hash, kind]);
      }
    });
  }

  async find(id: string): Promise<StoredSession | null> {
    const row = this.#session(id);
    if (row === null) return null;
    const keys = this.#all("SELECT hash, kind FROM keys WHERE robot = ?", [id]);
    return {
      id,
      epoch: row.epoch,
      createdAt: row.created_at,
      lastUsedAt: row.last_used_at,
      keys: keys.map((key) => keyRow.parse(key)),
    };
  }

  async touch(id: string, now: number): Promise<void> {
    this.#run("UPDATE sessions SET last_used_at = max(last_used_at, ?) WHERE id = ?", [now, id]);
  }

  async remove(id: string): Promise<boolean> {
    const removed = this.#run("DELETE FROM sessions WHERE id = ?", [id]) > 0;
    if (removed) forgetDeleted(this.#db);
    return removed;
  }

  async removeExpired(before: { lastUsedAt: number; createdAt: number }): Promise<string[]> {
    const rows = this.#all(
      "DELETE FROM sessions WHERE last_used_at < ? OR created_at < ? RETURNING id",
      [before.lastUsedAt, before.createdAt],
    );
    if (rows.length > 0) forgetDeleted(this.#db);
    return rows.map((row) => z.object({ id: z.string() }).parse(row).id);
  }

  async add(id: string, command: NewCommand): Promise<AddResult> {
    const text = JSON.stringify(command.command);
    return inTransaction(this.#db, (): AddResult => {
      const session = this.#session(id);
      if (session === null) return { outcome: "no-session" };
      const earlier = this.#records(
        `SELECT ${COLUMNS} FROM commands WHERE robot = ? AND driver = ? AND key = ?`,
        [id, command.driver, command.key],
      )[0];
      if (earlier !== undefined) {
        const same = JSON.stringify(earlier.command) === text;
        return { outcome: same ? "duplicate" : "conflict", record: earlier };
      }
      const seq = session.last_seq + 1;
      const ended = text === STOP ? this.#overtake(id, seq) : [];
      if (text !== STOP && this.#count(id, "accepted") >= command.maxWaiting) {
        return { outcome: "full" };
      }
      this.#run("UPDATE sessions SET last_seq = ? WHERE id = ?", [seq, id]);
      const [record] = this.#records(
        `INSERT INTO commands (robot, seq, driver, key, command, state, accepted_at)
         VALUES (?, ?, ?, ?, ?, 'accepted', ?) RETURNING ${COLUMNS}`,
        [id, seq, command.driver, command.key, text, command.acceptedAt],
      );
      if (record === undefined) throw new Error("SQLite did not return the stored command");
      this.#run(
        `DELETE FROM commands WHERE robot = ? AND seq <= ?
         AND NOT (${IS_OPEN})`,
        [id, seq - command.keep],
      );
      return { outcome: "stored", record, ended };
    });
  }

  async deliver(id: string, epoch: number, window: number): Promise<CommandRecord[]> {
    return inTransaction(this.#db, () => {
      const free = Math.max(0, window - this.#count(id, "delivered"));
      return this.#records(
        `UPDATE ${OPEN_COMMANDS} SET state = 'delivered', epoch = ?1
         WHERE robot = ?2 AND state = 'accepted' AND ${IS_OPEN} AND (command = '${STOP}' OR seq IN (
           SELECT seq FROM ${OPEN_COMMANDS} WHERE robot = ?2 AND state = 'accepted' AND ${IS_OPEN}
           ORDER BY seq LIMIT ?3))
         RETURNING ${COLUMNS}`,
        [epoch, id, free],
      );
    });
  }

  async start(id: string, seq: number): Promise<CommandRecord | null> {
    const [record] = this.#records(
      `UPDATE commands SET state = 'started'
       WHERE robot = ? AND seq = ? AND state = 'delivered' RETURNING ${COLUMNS}`,
      [id, seq],
    );
    return record ?? null;
  }

  async end(id: string, ending: Ending): Promise<CommandRecord | null> {
    return this.#end(id, ending);
  }

  async cancelOpen(id: string, reason: string): Promise<CommandRecord[]> {
    return this.#records(
      `UPDATE ${OPEN_COMMANDS} SET state = 'cancelled', reason = ?
       WHERE robot = ? AND state IN ('delivered', 'started') AND ${IS_OPEN}
       RETURNING ${COLUMNS}`,
      [reason, id],
    );
  }

  async takeOver(id: string, page: PageState) {
    return inTransaction(this.#db, () => {
      const session = this.#session(id);
      if (session === null) return null;
      const epoch = session.epoch + 1;
      // A page that knows of later commands than this file saw a store that lost its newest rows.
      this.#run("UPDATE sessions SET epoch = ?, last_seq = max(last_seq, ?) WHERE id = ?", [
        epoch,
        page.lastApplied,
        id,
      ]);
      const changed = page.endings.flatMap((ending) => this.#end(id, ending) ?? []);
      changed.push(
        ...this.#records(
          `UPDATE ${OPEN_COMMANDS} SET state = CASE WHEN seq > ? THEN 'accepted' ELSE 'started' END
           WHERE robot = ? AND state = 'delivered' AND ${IS_OPEN} RETURNING ${COLUMNS}`,
          [page.lastApplied, id],
        ),
      );
      if (page.fresh) changed.push(...this.#endLostWithPage(id));
      return { epoch, changed: lastOfEach(changed) };
    });
  }

  async command(id: string, seq: number): Promise<CommandRecord | null> {
    const [record] = this.#records(`SELECT ${COLUMNS} FROM commands WHERE robot = ? AND seq = ?`, [
      id,
      seq,
    ]);
    return record ?? null;
  }

  async commandsAfter(id: string, seq: number, limit: number): Promise<CommandRecord[]> {
    return this.#records(
      `SELECT ${COLUMNS} FROM commands WHERE robot = ? AND seq > ? ORDER BY seq LIMIT ?`,
      [id, seq, limit],
    );
  }

  async check(): Promise<"ok" | "full"> {
    try {
      inTransaction(this.#db, () => takeRoom(this.#db));
      return "ok";
    } catch (error) {
      if (isDiskFull(error)) return "full";
      throw error;
    }
  }

  async close(): Promise<void> {
    this.#statements.clear();
    this.#db.close();
  }

  /** What ran in a page that is gone, and what a later stop had overtaken, can only end here. */
  #endLostWithPage(id: string): CommandRecord[] {
    const lost = this.#records(
      `UPDATE ${OPEN_COMMANDS} SET state = 'cancelled', reason = 'the page was reloaded'
       WHERE robot = ? AND state = 'started' AND ${IS_OPEN} RETURNING ${COLUMNS}`,
      [id],
    );
    const stop = this.#all(
      `SELECT max(seq) AS seq FROM ${OPEN_COMMANDS}
       WHERE robot = ? AND state = 'accepted' AND ${IS_OPEN} AND command = '${STOP}'`,
      [id],
    )[0]?.["seq"];
    return typeof stop === "number" ? [...lost, ...this.#overtake(id, stop)] : lost;
  }

  #overtake(id: string, stop: number): CommandRecord[] {
    return this.#records(
      `UPDATE ${OPEN_COMMANDS} SET state = 'cancelled', reason = ?
       WHERE robot = ? AND state = 'accepted' AND ${IS_OPEN} AND seq < ? RETURNING ${COLUMNS}`,
      [`stopped by command ${stop}`, id, stop],
    );
  }

  #end(id: string, { seq, state, reason, pose, distance }: Ending): CommandRecord | null {
    const [record] = this.#records(
      `UPDATE commands SET state = ?, reason = ?, pose = ?, distance = ?
       WHERE robot = ? AND seq = ? AND state IN ('delivered', 'started') RETURNING ${COLUMNS}`,
      [state, reason, pose === null ? null : JSON.stringify(pose), distance, id, seq],
    );
    return record ?? null;
  }

  #count(id: string, state: "accepted" | "delivered"): number {
    const sql = `SELECT count(*) AS n FROM ${OPEN_COMMANDS}
      WHERE robot = ? AND state = '${state}' AND ${IS_OPEN} AND command <> '${STOP}'`;
    return Number(this.#all(sql, [id])[0]?.["n"] ?? 0);
  }

  #session(id: string): z.infer<typeof sessionRow> | null {
    const [row] = this.#all("SELECT * FROM sessions WHERE id = ?", [id]);
    return row === undefined ? null : sessionRow.parse(row);
  }

  #records(sql: string, values: SQLInputValue[]): CommandRecord[] {
    // RETURNING gives rows in no promised order.
    return this.#all(sql, values)
      .map(readRecord)
      .toSorted((a, b) => a.seq - b.seq);
  }

  #all(sql: string, values: SQLInputValue[]) {
    return this.#statement(sql).all(...values);
  }

  #run(sql: string, values: SQLInputValue[]): number {
    return Number(this.#statement(sql).run(...values).changes);
  }

  #statement(sql: string): StatementSync {
    let statement = this.#statements.get(sql);
    if (statement === undefined) {
      statement = this.#db.prepare(sql);
      this.#statements.set(sql, statement);
    }
    return statement;
  }
}

function readRecord(row: unknown): CommandRecord {
  const { command, pose, accepted_at, ...rest } = commandRow.parse(row);
  const parsed: unknown = JSON.parse(command);
  const action = z.object({ action: z.string() }).parse(parsed).action;
  return commandRecordSchema.parse({
    ...rest,
    action,
    command: parsed,
    acceptedAt: new Date(accepted_at).toISOString(),
    pose: pose === null ? null : JSON.parse(pose),
    duplicate: false,
  });
}

/** A command that changed twice in one step is reported once, with its last state. */
function lastOfEach(records: CommandRecord[]): CommandRecord[] {
  const bySeq = new Map(records.map((record) => [record.seq, record]));
  return [...bySeq.values()].toSorted((a, b) => a.seq - b.seq);
}
