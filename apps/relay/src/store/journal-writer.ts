/**
 * What is written of commands: entries at the end of the journal, and rows that are brought from there into the
 * tables. It needs to be told no more than numbers for the latter, so that whoever has the robots in memory can let
 * another thread do all of it.
 */
import type { DatabaseSync } from "node:sqlite";
import { Statements } from "./statements.ts";

/** In the order in which they are given: CROSS keeps SQLite from another. */
const KEEP_ROWS = `INSERT INTO commands (robot, entry)
  SELECT robot, entry FROM json_each(?) AS given CROSS JOIN journal ON journal.id = given.value WHERE true
  ON CONFLICT (robot, seq) DO UPDATE SET entry = excluded.entry`;
const FORGET_ENDED = "DELETE FROM commands WHERE robot = ? AND seq <= ? AND is_open = 0";
const FORGET_ONE = "DELETE FROM commands WHERE robot = ? AND seq = ?";

/** A row as a step has left it. */
export type Entry = [id: number, robot: string, text: string];

/** A robot's rows, to be brought into the tables. */
export interface Bringing {
  robot: string;
  /** numbers of the entries that have the rows as they are now */
  entries: number[];
  /** numbers of commands that are forgotten, which the tables may have as they were before they ended */
  gone: number[];
  /** number of the newest of its entries */
  upTo: number;
  lastSeq: number;
  /** before this number, all of it has ended */
  openFrom: number;
  /** what of it has ended up to this number is deleted, but for what comes in now; 0: nothing is */
  forgotten: number;
}

/** What is brought into the tables, and what of the journal is not needed any more. */
export interface Tidying {
  bringing: Bringing[];
  /** entries up to this one go, but for those of these robots */
  deleted: number;
  kept: string[];
}

export class JournalWriter {
  readonly #db: DatabaseSync;
  readonly #statements: Statements;

  constructor(db: DatabaseSync) {
    this.#db = db;
    this.#statements = new Statements(db);
  }

  /**
   * Writes entries for good, and tidies with them where that can be done.
   * @returns why it was not tidied; null where it was
   * @throws the error of SQLite when there is nothing of it on disk
   */
  write(entries: readonly Entry[], tidying: Tidying | null): unknown {
    if (tidying === null) {
      this.#commit(() => this.append(entries));
      return null;
    }
    try {
      this.#commit(() => {
        this.append(entries);
        this.#tidy(tidying);
      });
      return null;
    } catch (error) {
      // Nobody is refused a command for what can wait.
      this.#commit(() => this.append(entries));
      return error;
    }
  }

  /** In the transaction of whoever calls it. */
  append(entries: readonly Entry[]): void {
    const sql = "INSERT INTO journal (id, robot, entry) VALUES (?, ?, ?)";
    for (const entry of entries) this.#statements.run(sql, entry);
  }

  #tidy({ bringing, deleted, kept }: Tidying): void {
    for (const each of bringing) this.#bringIn(each);
    if (deleted === 0) return;
    const isKept = "robot IN (SELECT value FROM json_each(?))";
    const sql = `DELETE FROM journal WHERE id <= ? AND NOT ${isKept}`;
    this.#statements.run(sql, [deleted, JSON.stringify(kept)]);
  }

  #bringIn({ robot, entries, gone, upTo, lastSeq, openFrom, forgotten }: Bringing): void {
    // First, since another may have come with the key of one that is forgotten.
    if (forgotten > 0) this.#statements.run(FORGET_ENDED, [robot, forgotten]);
    for (const seq of gone) this.#statements.run(FORGET_ONE, [robot, seq]);
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
      // Some errors, a full disk's among them, have undone all of it already.
      if (this.#db.isTransaction) this.#statements.run("ROLLBACK");
      throw error;
    }
  }
}
