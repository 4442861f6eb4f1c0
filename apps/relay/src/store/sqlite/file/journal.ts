/**
 * The journal of commands: its interface, the choice between this thread and another one, and the
 * SQL that writes entries. A checkpoint copies rows from the journal to the tables. It only needs
 * numbers, so a thread without the robots in memory can write it (`ThreadedJournal`).
 */
import type { DatabaseSync } from "node:sqlite";
import { Statements } from "./statements.ts";

/** A row after a step. */
export type Entry = [id: number, robot: string, text: string];

/** The checkpoint of one robot. */
export interface Bringing {
  robot: string;
  /** numbers of the entries that hold the current rows */
  entries: number[];
  /** seq of deleted commands, which the tables may hold in an earlier state */
  gone: number[];
  /** number of the robot's newest entry */
  upTo: number;
  lastSeq: number;
  /** every command before this seq has ended */
  openFrom: number;
  /** ended commands up to this seq are deleted, except those in `entries`; 0: none */
  deletedTo: number;
}

/** Rows to copy to the tables, and journal entries to delete. */
export interface Compaction {
  bringing: Bringing[];
  /** entries up to this number are deleted, except those of the robots in `stored` */
  deleted: number;
  stored: string[];
}

/**
 * Receives the result of a write.
 * @param lost the error if nothing was written, or null
 * @param compactionError the error if only the compaction failed, or null
 */
export type Written = (lost: unknown, compactionError: unknown) => void;

export interface Journal {
  /**
   * Commits entries, together with a compaction if possible. No other write to the database may
   * start before `written` is called, which can happen before this method returns.
   */
  write(entries: readonly Entry[], compaction: Compaction | null, written: Written): void;
  close(): Promise<void>;
}

/**
 * Larger batches occur only under load. A small batch right after a large one usually has more
 * behind it.
 */
const FEW = 4;
/** A synchronous write blocks all other work for its duration. */
const SLOW_MS = 2;
/**
 * Slow writes in excess of fast ones before the thread takes over. A single slow write shows a busy
 * machine, which delays the thread too.
 */
const MANY_SLOW = 3;
/** Time after which synchronous writes are tried again. */
const TRY_AGAIN_MS = 10_000;

/**
 * Selects the faster of two journals for each write. On a fast disk, waking a thread and waiting
 * for its answer takes longer than writing a few entries. Small batches are therefore written
 * synchronously. Large batches, and all batches while the disk is slow, go to the thread.
 */
export class AdaptiveJournal implements Journal {
  readonly #own: Journal;
  readonly #thread: Journal;
  readonly #now: () => number;
  /** number of slow writes minus fast ones, at least 0 */
  #slow = 0;
  #slowUntil = -Infinity;
  /** number of entries in the previous write */
  #before = 0;

  /**
   * @param own writes before it returns
   * @param now ms of a monotonic clock
   */
  constructor(own: Journal, thread: Journal, now: () => number = () => performance.now()) {
    this.#own = own;
    this.#thread = thread;
    this.#now = now;
  }

  write(entries: readonly Entry[], compaction: Compaction | null, written: Written): void {
    const begun = this.#now();
    const isLittle = compaction === null && Math.max(entries.length, this.#before) <= FEW;
    this.#before = entries.length;
    const isOwn = isLittle && begun >= this.#slowUntil;
    (isOwn ? this.#own : this.#thread).write(entries, compaction, (...how) => {
      if (isOwn) this.#took(this.#now() - begun);
      written(...how);
    });
  }

  #took(ms: number): void {
    this.#slow = ms > SLOW_MS ? Math.min(this.#slow + 1, MANY_SLOW) : Math.max(this.#slow - 1, 0);
    if (this.#slow === MANY_SLOW) this.#slowUntil = this.#now() + TRY_AGAIN_MS;
  }

  async close(): Promise<void> {
    await this.#thread.close();
  }
}

/** Writes on the caller's thread and connection. */
export class InlineJournal implements Journal {
  readonly #writer: JournalWriter;

  constructor(db: DatabaseSync) {
    this.#writer = new JournalWriter(db);
  }

  write(entries: readonly Entry[], compaction: Compaction | null, written: Written): void {
    let compactionError: unknown;
    try {
      compactionError = this.#writer.write(entries, compaction);
    } catch (error) {
      return written(error, null);
    }
    written(null, compactionError);
  }

  async close(): Promise<void> {}
}

/** CROSS JOIN makes SQLite process the entries in the given order. */
const KEEP_ROWS = `INSERT INTO commands (robot, entry)
  SELECT robot, entry FROM json_each(?) AS given CROSS JOIN journal ON journal.id = given.value WHERE true
  ON CONFLICT (robot, seq) DO UPDATE SET entry = excluded.entry`;
const DELETE_ENDED = "DELETE FROM commands WHERE robot = ? AND seq <= ? AND is_open = 0";
const DELETE_ONE = "DELETE FROM commands WHERE robot = ? AND seq = ?";

/** Writes entries at the end of the journal, and what a checkpoint copies, to the database. */
export class JournalWriter {
  readonly #db: DatabaseSync;
  readonly #statements: Statements;

  constructor(db: DatabaseSync) {
    this.#db = db;
    this.#statements = new Statements(db);
  }

  /**
   * Commits entries, together with a compaction if possible.
   * @returns the error of the compaction, or null
   * @throws the error of SQLite if no entry was written
   */
  write(entries: readonly Entry[], compaction: Compaction | null): unknown {
    if (compaction === null) {
      this.#commit(() => this.append(entries));
      return null;
    }
    try {
      this.#commit(() => {
        this.append(entries);
        this.#compact(compaction);
      });
      return null;
    } catch (error) {
      // A failed compaction must not reject commands.
      this.#commit(() => this.append(entries));
      return error;
    }
  }

  /** Adds entries in the caller's transaction. */
  append(entries: readonly Entry[]): void {
    const sql = "INSERT INTO journal (id, robot, entry) VALUES (?, ?, ?)";
    for (const entry of entries) this.#statements.run(sql, entry);
  }

  #compact({ bringing, deleted, stored }: Compaction): void {
    for (const each of bringing) this.#bringIn(each);
    if (deleted === 0) return;
    const isStored = "robot IN (SELECT value FROM json_each(?))";
    const sql = `DELETE FROM journal WHERE id <= ? AND NOT ${isStored}`;
    this.#statements.run(sql, [deleted, JSON.stringify(stored)]);
  }

  #bringIn({ robot, entries, gone, upTo, lastSeq, openFrom, deletedTo }: Bringing): void {
    // Deletions come first, because another command may reuse the key of a deleted one.
    if (deletedTo > 0) this.#statements.run(DELETE_ENDED, [robot, deletedTo]);
    for (const seq of gone) this.#statements.run(DELETE_ONE, [robot, seq]);
    if (this.#statements.run(KEEP_ROWS, [JSON.stringify(entries)]) !== entries.length)
      throw new Error("The journal has fewer entries than the checkpoint needs.");
    const sql =
      "UPDATE sessions SET last_seq = max(last_seq, ?), open_from = ?, settled = ? WHERE id = ?";
    this.#statements.run(sql, [lastSeq, openFrom, upTo, robot]);
  }

  #commit(work: () => void): void {
    this.#statements.run("BEGIN IMMEDIATE");
    try {
      work();
      this.#statements.run("COMMIT");
    } catch (error) {
      // Some errors, such as a full disk, have already rolled back the transaction.
      if (this.#db.isTransaction) this.#statements.run("ROLLBACK");
      throw error;
    }
  }
}
