/**
 * The default store: one SQLite file, by the SQLite that is built into Node.
 *
 * The calls are synchronous inside, so each step is over before anything else runs; it is answered
 * once the group that it is in is on disk. They are short on purpose: rows of one robot by index. Only
 * the sweep for sessions that ran out, once a minute, reads through the sessions (not their commands).
 */
import { hasEnded, type CommandRecord, type Ending } from "@corridor/protocol";
import { z } from "zod";
import {
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
} from "./session-store.ts";
import { awayIn, changeAway } from "./sqlite-away.ts";
import { SqliteFile } from "./sqlite-file.ts";
import { begin, countIn, deliver, epochOf, IS_LATE } from "./sqlite-delivery.ts";
import { addKeys, changeKeys, keysIn, keyTimesIn, noteKeyUses } from "./sqlite-keys.ts";
import { end, meetPage, overtake, recallAllOf, recordOf, STOP } from "./sqlite-overtaking.ts";
import { numberIn, RECORD, recordsIn, TERMED, termedIn } from "./sqlite-rows.ts";
import { IS_OPEN, OPEN_COMMANDS } from "./sqlite-schema.ts";
import type { Statements } from "./statements.ts";

const STANDING = `SELECT last_seq AS lastSeq, paused,
  EXISTS (SELECT 1 FROM keys WHERE robot = ?1 AND hash = ?2) AS isKey,
  EXISTS (SELECT 1 FROM away WHERE robot = ?1 AND id = ?3) AS isAway
  FROM sessions WHERE id = ?1`;
const BY_KEY = `SELECT ${RECORD} FROM commands WHERE robot = ? AND driver = ? AND key = ?`;

const sessionRow = z.object({
  id: z.string(),
  epoch: z.int(),
  page: z.string(),
  last_seq: z.int(),
  created_at: z.int(),
  last_used_at: z.int(),
  paused: z.int(),
});

export class SqliteStore implements SessionStore {
  readonly #file: SqliteFile;

  /** @param file or its path; closing the store closes it */
  constructor(file: SqliteFile | string) {
    this.#file = typeof file === "string" ? new SqliteFile(file) : file;
  }

  async create({
    id,
    createdAt,
    keys,
  }: Omit<StoredSession, "epoch" | "page" | "lastUsedAt" | "away" | "isPaused">) {
    await this.#file.growingStep(() => {
      this.#writing.run("INSERT INTO sessions (id, created_at, last_used_at) VALUES (?, ?, ?)", [
        id,
        createdAt,
        createdAt,
      ]);
      addKeys(this.#writing, id, keys, createdAt);
    });
  }

  async find(id: string): Promise<StoredSession | null> {
    const { reading } = this.#file;
    const row = sessionIn(reading, id);
    if (row === null) return null;
    return {
      id,
      epoch: row.epoch,
      page: row.page,
      createdAt: row.created_at,
      lastUsedAt: row.last_used_at,
      keys: keysIn(reading, id),
      away: awayIn(reading, id),
      isPaused: row.paused === 1,
    };
  }

  async changeKeys(id: string, change: KeyChange): Promise<KeysResult> {
    const work = (): KeysResult =>
      sessionIn(this.#writing, id) === null
        ? { outcome: "no-session" }
        : changeKeys(this.#writing, id, change);
    // A key can be revoked on a full disk, too.
    return change.add.length === 0 ? this.#file.step(work) : this.#file.growingStep(work);
  }

  async changeAway(id: string, change: ScriptChange): Promise<AwayResult> {
    const work = (): AwayResult =>
      sessionIn(this.#writing, id) === null
        ? { outcome: "no-session" }
        : changeAway(this.#writing, id, change);
    // A script can be sent away on a full disk, too: few are.
    return this.#file.step(work);
  }

  async pause(id: string, isPaused: boolean, reason: string): Promise<TermedRecord[] | null> {
    const sql = "UPDATE sessions SET paused = ? WHERE id = ?";
    return this.#file.step(() => {
      if (this.#writing.run(sql, [isPaused ? 1 : 0, id]) === 0) return null;
      return isPaused ? recallAllOf(this.#writing, id, "all", reason) : [];
    });
  }

  async keepMaze(id: string, text: string): Promise<boolean> {
    const sql = "INSERT INTO mazes (robot, text) VALUES (?, ?) ON CONFLICT DO UPDATE SET text = ?2";
    return this.#file.growingStep(() => {
      if (sessionIn(this.#writing, id) === null) return false;
      return this.#writing.run(sql, [id, text]) > 0;
    });
  }

  async maze(id: string): Promise<string | null> {
    const [row] = this.#file.reading.all("SELECT text FROM mazes WHERE robot = ?", [id]);
    return row === undefined ? null : String(row["text"]);
  }

  async keyTimes(id: string): Promise<KeyTimes[]> {
    return keyTimesIn(this.#file.reading, id);
  }

  async touch(id: string, now: number, keys: readonly KeyUse[]): Promise<void> {
    const sql = "UPDATE sessions SET last_used_at = max(last_used_at, ?) WHERE id = ?";
    await this.#file.step(() => {
      this.#writing.run(sql, [now, id]);
      noteKeyUses(this.#writing, id, keys);
    });
  }

  async remove(id: string): Promise<boolean> {
    return this.#file.forget(
      () => this.#writing.run("DELETE FROM sessions WHERE id = ?", [id]) > 0,
      (removed) => removed,
    );
  }

  async removeExpired(before: { lastUsedAt: number; createdAt: number }): Promise<string[]> {
    const sql = "DELETE FROM sessions WHERE last_used_at < ? OR created_at < ? RETURNING id";
    const rows = await this.#file.forget(
      () => this.#writing.all(sql, [before.lastUsedAt, before.createdAt]),
      ({ length }) => length > 0,
    );
    return rows.map((row) => String(row["id"]));
  }

  async add(id: string, command: NewCommand): Promise<AddResult> {
    const text = JSON.stringify(command.command);
    const isStop = text === STOP;
    const work = (): AddResult => {
      const { driver, script, key, acceptedAt, ttl, deadline, replace, lease } = command;
      const standing = standingIn(this.#writing, id, { driver, script });
      if (standing === null) return { outcome: "no-session" };
      if (standing.isKey === 0) return { outcome: "revoked" };
      if (standing.isAway === 1) return { outcome: "sent-away" };
      const earlier =
        key === null ? undefined : recordsIn(this.#writing, BY_KEY, [id, driver, key])[0];
      if (earlier !== undefined) {
        const same = JSON.stringify(earlier.command) === text;
        return { outcome: same ? "duplicate" : "conflict", record: earlier };
      }
      if (standing.paused === 1 && !isStop) return { outcome: "paused" };
      if (deadline <= acceptedAt) return { outcome: "late" };
      const seq = standing.lastSeq + 1;
      const ended = isStop || replace ? overtake(this.#writing, id, { seq, isStop }) : [];
      if (!isStop && countIn(this.#writing, id, "accepted") >= command.maxWaiting)
        return { outcome: "full" };
      this.#writing.run("UPDATE sessions SET last_seq = ? WHERE id = ?", [seq, id]);
      const ms = lease === null ? null : Math.round(lease);
      const terms = [Math.round(ttl), Math.round(deadline), replace ? 1 : 0, ms];
      this.#writing.run(
        `INSERT INTO commands
           (robot, seq, driver, script, key, command, state, is_open, accepted_at,
            ttl, deadline, replaces, lease)
         VALUES (?, ?, ?, ?, ?, ?, 'accepted', 1, ?, ?, ?, ?, ?)`,
        [id, seq, driver, script, key, text, acceptedAt, ...terms],
      );
      if (seq > command.keep) {
        this.#writing.run(
          `DELETE FROM commands WHERE robot = ? AND seq <= ?
           AND is_open = 0`,
          [id, seq - command.keep],
        );
      }
      return { outcome: "stored", record: acceptedRecord(seq, command), ended };
    };
    // A robot can be stopped on a full disk, too.
    return isStop ? this.#file.step(work) : this.#file.growingStep(work);
  }

  async deliver(id: string, epoch: number, window: number, now: number): Promise<TermedRecord[]> {
    return this.#file.step(() => deliver(this.#writing, id, { epoch, window, now }));
  }

  async expire(id: string, now: number): Promise<{ ended: TermedRecord[]; next: number | null }> {
    const waits = `robot = ?2 AND state = 'accepted' AND ${IS_OPEN}`;
    return this.#file.step(() => ({
      ended: termedIn(
        this.#writing,
        `UPDATE ${OPEN_COMMANDS} SET state = 'expired', is_open = 0, reason = printf('older than %g s', ttl / 1000.0)
         WHERE ${waits} AND ${IS_LATE} RETURNING ${TERMED}`,
        [now, id],
      ),
      next: numberIn(
        this.#writing,
        `SELECT min(deadline) AS found FROM ${OPEN_COMMANDS}
         WHERE robot = ? AND state = 'accepted' AND ${IS_OPEN}`,
        [id],
      ),
    }));
  }

  async cancel(id: string, seq: number, by: { driver: string; reason: string }) {
    return this.#file.step((): CancelResult => {
      const [found] = termedIn(
        this.#writing,
        `SELECT ${TERMED} FROM commands WHERE robot = ? AND seq = ?`,
        [id, seq],
      );
      if (found === undefined) return { outcome: "no-command" };
      const { record, driver } = found;
      if (driver !== by.driver) return { outcome: "not-yours" };
      if (hasEnded(record.state)) return { outcome: "over", record };
      if (record.state !== "accepted") {
        this.#writing.run(
          "UPDATE commands SET recalled = coalesce(recalled, ?) WHERE robot = ? AND seq = ?",
          [by.reason, id, seq],
        );
        return { outcome: "delivered", record };
      }
      const [termed] = termedIn(
        this.#writing,
        `UPDATE commands SET state = 'cancelled', is_open = 0, reason = ?
         WHERE robot = ? AND seq = ? RETURNING ${TERMED}`,
        [by.reason, id, seq],
      );
      if (termed === undefined) throw new Error("SQLite did not return the cancelled command");
      return { outcome: "cancelled", termed };
    });
  }

  async start(id: string, epoch: number, seq: number): Promise<CommandRecord | null> {
    return this.#file.step(() => begin(this.#writing, id, { epoch, seq }));
  }

  async end(id: string, epoch: number, ending: Ending): Promise<EndResult> {
    return this.#file.step((): EndResult => {
      const isNewest = epochOf(this.#writing, id) === epoch;
      const record = isNewest ? end(this.#writing, id, ending) : null;
      if (record !== null) return { outcome: "ended", record };
      return { outcome: "over", record: recordOf(this.#writing, id, ending.seq) };
    });
  }

  async abandon(id: string, epoch: number, reason: string): Promise<CommandRecord[]> {
    return this.#file.step(() => {
      const raised = "UPDATE sessions SET epoch = epoch + 1 WHERE id = ? AND epoch = ?";
      if (this.#writing.run(raised, [id, epoch]) === 0) return [];
      return recordsIn(
        this.#writing,
        `UPDATE ${OPEN_COMMANDS} SET state = 'cancelled', is_open = 0, reason = ?
         WHERE robot = ? AND state IN ('delivered', 'started') AND ${IS_OPEN}
         RETURNING ${RECORD}`,
        [reason, id],
      );
    });
  }

  async takeOver(id: string, page: PageState) {
    return this.#file.step(() => {
      const session = sessionIn(this.#writing, id);
      if (session === null) return null;
      const epoch = session.epoch + 1;
      // A page that knows of later commands than this file saw a store that lost its newest rows.
      this.#writing.run(
        "UPDATE sessions SET epoch = ?, page = ?, last_seq = max(last_seq, ?) WHERE id = ?",
        [epoch, page.page ?? "", page.lastApplied, id],
      );
      const isSettled = page.settled !== null && page.settled >= session.epoch;
      return { epoch, ...meetPage(this.#writing, id, { ...page, isSettled }) };
    });
  }

  async command(id: string, seq: number): Promise<CommandRecord | null> {
    return recordOf(this.#file.reading, id, seq);
  }

  async commandsAfter(id: string, seq: number, limit: number): Promise<CommandRecord[]> {
    const sql = `SELECT ${RECORD} FROM commands WHERE robot = ? AND seq > ? ORDER BY seq LIMIT ?`;
    return recordsIn(this.#file.reading, sql, [id, seq, limit]);
  }

  async openCommands(id: string): Promise<CommandRecord[]> {
    const sql = `SELECT ${RECORD} FROM ${OPEN_COMMANDS} WHERE robot = ? AND ${IS_OPEN} ORDER BY seq`;
    return recordsIn(this.#writing, sql, [id]);
  }

  async recalled(id: string): Promise<{ seq: number; reason: string }[]> {
    const sql = `SELECT seq, recalled FROM ${OPEN_COMMANDS}
      WHERE robot = ? AND state IN ('delivered', 'started') AND ${IS_OPEN} AND recalled IS NOT NULL
      ORDER BY seq`;
    const rows = this.#writing.all(sql, [id]);
    return rows.map((row) => ({ seq: Number(row["seq"]), reason: String(row["recalled"]) }));
  }

  async check(): Promise<"ok" | "full"> {
    return this.#file.check();
  }

  async close(): Promise<void> {
    this.#file.close();
  }

  get #writing(): Statements {
    return this.#file.writing;
  }
}

/** What decides whether a command is taken. */
interface Standing {
  lastSeq: number;
  paused: 0 | 1;
  /** whether who sends it has a key of the robot, and was sent away */
  isKey: 0 | 1;
  isAway: 0 | 1;
}

function standingIn(
  statements: Statements,
  id: string,
  { driver, script }: Pick<NewCommand, "driver" | "script">,
): Standing | null {
  const [row] = statements.all(STANDING, [id, driver, script]);
  return (row as Standing | undefined) ?? null;
}

function acceptedRecord(seq: number, { key, command, acceptedAt }: NewCommand): CommandRecord {
  return {
    seq,
    key,
    action: command.action,
    command,
    state: "accepted",
    reason: null,
    acceptedAt: new Date(acceptedAt).toISOString(),
    pose: null,
    distance: null,
    duplicate: false,
  };
}

function sessionIn(statements: Statements, id: string): z.infer<typeof sessionRow> | null {
  const [row] = statements.all("SELECT * FROM sessions WHERE id = ?", [id]);
  return row === undefined ? null : sessionRow.parse(row);
}
