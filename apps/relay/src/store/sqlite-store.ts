/**
 * The default store: one SQLite file, by the SQLite that is built into Node.
 *
 * The calls are synchronous inside, so each step is over before anything else runs; it is answered
 * once the group that it is in is on disk. They are short on purpose: rows of one robot by index. Only
 * the sweep for sessions that ran out, once a minute, reads through the sessions (not their commands).
 */
import type { SQLInputValue } from "node:sqlite";
import { commandRecordSchema, type CommandRecord, type Ending } from "@corridor/protocol";
import { z } from "zod";
import type {
  AddResult,
  NewCommand,
  PageState,
  SessionStore,
  StoredSession,
} from "./session-store.ts";
import { SqliteFile } from "./sqlite-file.ts";
import { IS_OPEN, OPEN_COMMANDS } from "./sqlite-schema.ts";
import type { Statements } from "./statements.ts";

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

const actionOf = z.object({ action: z.string() });

const COLUMNS = "seq, key, command, state, reason, accepted_at, pose, distance";
const STOP = '{"action":"stop"}';

export class SqliteStore implements SessionStore {
  readonly #file: SqliteFile;

  /** @param file or its path; closing the store closes it */
  constructor(file: SqliteFile | string) {
    this.#file = typeof file === "string" ? new SqliteFile(file) : file;
  }

  async create({ id, createdAt, keys }: Omit<StoredSession, "epoch" | "lastUsedAt">) {
    await this.#file.growingStep(() => {
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
    const { reading } = this.#file;
    const row = sessionIn(reading, id);
    if (row === null) return null;
    const keys = reading.all("SELECT hash, kind FROM keys WHERE robot = ?", [id]);
    return {
      id,
      epoch: row.epoch,
      createdAt: row.created_at,
      lastUsedAt: row.last_used_at,
      keys: keys.map((key) => keyRow.parse(key)),
    };
  }

  async touch(id: string, now: number): Promise<void> {
    const sql = "UPDATE sessions SET last_used_at = max(last_used_at, ?) WHERE id = ?";
    await this.#file.step(() => this.#run(sql, [now, id]));
  }

  async remove(id: string): Promise<boolean> {
    return this.#file.forget(
      () => this.#run("DELETE FROM sessions WHERE id = ?", [id]) > 0,
      (removed) => removed,
    );
  }

  async removeExpired(before: { lastUsedAt: number; createdAt: number }): Promise<string[]> {
    const sql = "DELETE FROM sessions WHERE last_used_at < ? OR created_at < ? RETURNING id";
    const rows = await this.#file.forget(
      () => this.#all(sql, [before.lastUsedAt, before.createdAt]),
      ({ length }) => length > 0,
    );
    return rows.map((row) => String(row["id"]));
  }

  async add(id: string, command: NewCommand): Promise<AddResult> {
    const text = JSON.stringify(command.command);
    const work = (): AddResult => {
      const session = sessionIn(this.#file.writing, id);
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
    };
    // A robot can be stopped on a full disk, too.
    return text === STOP ? this.#file.step(work) : this.#file.growingStep(work);
  }

  async deliver(id: string, epoch: number, window: number): Promise<CommandRecord[]> {
    return this.#file.step(() => {
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
    return this.#file.step(() => {
      const [record] = this.#records(
        `UPDATE commands SET state = 'started'
         WHERE robot = ? AND seq = ? AND state = 'delivered' RETURNING ${COLUMNS}`,
        [id, seq],
      );
      return record ?? null;
    });
  }

  async end(id: string, ending: Ending): Promise<CommandRecord | null> {
    return this.#file.step(() => this.#end(id, ending));
  }

  async cancelOpen(id: string, reason: string): Promise<CommandRecord[]> {
    return this.#file.step(() =>
      this.#records(
        `UPDATE ${OPEN_COMMANDS} SET state = 'cancelled', reason = ?
         WHERE robot = ? AND state IN ('delivered', 'started') AND ${IS_OPEN}
         RETURNING ${COLUMNS}`,
        [reason, id],
      ),
    );
  }

  async takeOver(id: string, page: PageState) {
    return this.#file.step(() => {
      const session = sessionIn(this.#file.writing, id);
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
    const sql = `SELECT ${COLUMNS} FROM commands WHERE robot = ? AND seq = ?`;
    return recordsIn(this.#file.reading, sql, [id, seq])[0] ?? null;
  }

  async commandsAfter(id: string, seq: number, limit: number): Promise<CommandRecord[]> {
    const sql = `SELECT ${COLUMNS} FROM commands WHERE robot = ? AND seq > ? ORDER BY seq LIMIT ?`;
    return recordsIn(this.#file.reading, sql, [id, seq, limit]);
  }

  async openCommands(id: string): Promise<CommandRecord[]> {
    return this.#records(
      `SELECT ${COLUMNS} FROM ${OPEN_COMMANDS} WHERE robot = ? AND ${IS_OPEN} ORDER BY seq`,
      [id],
    );
  }

  async check(): Promise<"ok" | "full"> {
    return this.#file.check();
  }

  async close(): Promise<void> {
    this.#file.close();
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

  #records(sql: string, values: SQLInputValue[]): CommandRecord[] {
    return recordsIn(this.#file.writing, sql, values);
  }

  #all(sql: string, values: SQLInputValue[]) {
    return this.#file.writing.all(sql, values);
  }

  #run(sql: string, values: SQLInputValue[]): number {
    return this.#file.writing.run(sql, values);
  }
}

function sessionIn(statements: Statements, id: string): z.infer<typeof sessionRow> | null {
  const [row] = statements.all("SELECT * FROM sessions WHERE id = ?", [id]);
  return row === undefined ? null : sessionRow.parse(row);
}

function recordsIn(statements: Statements, sql: string, values: SQLInputValue[]): CommandRecord[] {
  // RETURNING gives rows in no promised order.
  return statements
    .all(sql, values)
    .map(readRecord)
    .toSorted((a, b) => a.seq - b.seq);
}

function readRecord(row: unknown): CommandRecord {
  const { command, pose, accepted_at, ...rest } = commandRow.parse(row);
  const parsed: unknown = JSON.parse(command);
  const { action } = actionOf.parse(parsed);
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
