/**
 * The SQL of the journal of commands. A checkpoint copies rows from the journal to the tables. It
 * only needs the numbers of entries, so their texts are not read again.
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
