/**
 * The journal of commands: the form of its entries, and its SQL. A checkpoint copies rows from the
 * journal to the tables. It only needs the numbers of entries, so their texts are not read again.
 */
import type { DatabaseSync, SQLInputValue } from "node:sqlite";
import { Statements } from "./statements.ts";
import { hasEnded, type CommandRecord, type CommandState } from "@corridor/protocol";
import { commandIn, type CommandRow, type Overtaking } from "../../../commands/robot-commands.ts";
import { recallCauseIn, type Reason } from "../../../commands/reasons.ts";

/** A row after a step. */
export type Entry = [id: number, robot: string, text: string];

/** The checkpoint of one robot. */
export interface Checkpoint {
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
  checkpoints: Checkpoint[];
  /** entries up to this number are deleted, except those of unreadable robots */
  deleted: number;
  /** ids of the robots whose commands cannot be read */
  unreadable: string[];
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

  #compact({ checkpoints, deleted, unreadable }: Compaction): void {
    for (const each of checkpoints) this.#copy(each);
    if (deleted === 0) return;
    const isUnreadable = "robot IN (SELECT value FROM json_each(?))";
    const sql = `DELETE FROM journal WHERE id <= ? AND NOT ${isUnreadable}`;
    this.#statements.run(sql, [deleted, JSON.stringify(unreadable)]);
  }

  #copy({ robot, entries, gone, upTo, lastSeq, openFrom, deletedTo }: Checkpoint): void {
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

/** Layout of a journal entry. The tables read the same positions, so they must not change. */
type Fields = [
  seq: number,
  driver: string,
  script: string | null,
  key: string | null,
  text: string,
  acceptedAt: number,
  ttl: number,
  deadline: number,
  replaces: 0 | 1,
  lease: number | null,
  state: CommandState,
  /** a string: the robot's sentence, or one that an earlier version of Corridor stored */
  reason: Reason | null,
  recalled: string | null,
  pose: string | null,
  distance: number | null,
  epoch: number | null,
  deletedTo: number,
  overtakes: Overtaking | null,
  /** for queries */
  isOpen: 0 | 1,
];

/**
 * Serialises a row for the journal and the tables.
 * @param deletedTo highest seq up to which this step deletes the robot's ended commands; 0: none
 */
export function entryOf(row: CommandRow, deletedTo: number): string {
  const { seq, driver, script, key, text, acceptedAt, ttl, deadline, replace, lease } = row;
  const { state, reason, recalled, pose, distance, epoch, overtakes } = row;
  const entry: Fields = [
    seq,
    driver,
    script,
    key,
    text,
    acceptedAt,
    ttl,
    deadline,
    replace ? 1 : 0,
    lease,
    state,
    reason,
    recalled,
    pose === null ? null : JSON.stringify(pose),
    distance,
    epoch,
    deletedTo,
    overtakes,
    hasEnded(state) ? 0 : 1,
  ];
  return JSON.stringify(entry);
}

/** @throws SyntaxError if the text is not an entry */
export function rowIn(entry: string): { row: CommandRow; deletedTo: number } {
  const [seq, driver, script, key, text, acceptedAt, ttl, deadline, replaces, lease, ...rest] =
    JSON.parse(entry) as Fields;
  const [state, reason, recalled, pose, distance, epoch, deletedTo, overtakes] = rest;
  const row: CommandRow = {
    seq,
    driver,
    script,
    key,
    ...commandIn(text),
    acceptedAt,
    ttl,
    deadline,
    replace: replaces === 1,
    lease,
    overtakes,
    state,
    reason,
    recalled: recallCauseIn(recalled),
    pose: pose === null ? null : (JSON.parse(pose) as CommandRecord["pose"]),
    distance,
    epoch,
  };
  return { row, deletedTo };
}

/** The rows in the column `entry` of a query. */
export function rowsIn(statements: Statements, sql: string, values: SQLInputValue[]): CommandRow[] {
  return statements.all(sql, values).map(({ entry }) => rowIn(String(entry)).row);
}
