/**
 * A robot whose current commands are in memory, so that the usual steps of a command need no
 * tables. It holds the open commands, and the ended commands that no table holds yet. It finds all
 * other commands in the tables, and records which changes the tables lack. The rules are in
 * `commands`.
 *
 * All methods must be called within a step, except those of `commands` that only read.
 */
import { hasEnded, type CommandRecord } from "@corridor/protocol";
import {
  type CommandRow,
  RobotCommands,
  type AdmissionState,
  type Overtaking,
} from "../../commands/robot-commands.ts";
import { KeyIndex } from "../../commands/key-index.ts";
import { newestOvertaking } from "../../commands/page-transitions.ts";
import type {
  KeysChange,
  RobotState,
  SeqRange,
  Permissions,
  StoredScript,
} from "../../commands/robot-step.ts";
import { shownRecordIn } from "../../commands/stored-conditions.ts";
import { rowsIn } from "./file/journal.ts";
import type { Statements } from "./file/statements.ts";
import { blockedScriptsIn, setBlockedScripts } from "./sqlite-blocked-scripts.ts";
import { addKeys, keysIn, removeKeys } from "./sqlite-keys.ts";

const BY_KEY = "SELECT entry FROM commands WHERE robot = ? AND driver = ? AND key = ?";
const BY_SEQ = "SELECT entry FROM commands WHERE robot = ? AND seq = ?";
const AFTER = "SELECT entry FROM commands WHERE robot = ? AND seq > ? ORDER BY seq LIMIT ?";
const ENDED = "SELECT entry FROM commands WHERE robot = ? AND seq > ? AND seq <= ?";
const NEWEST =
  "SELECT max(seq) AS found FROM commands WHERE robot = ? AND seq > ? AND overtakes = ?";

/** Looking up a key in the tables takes as long as all other work of the store for a command. */
const MOST_LEFT = 1_000;

export interface LiveRobotParts {
  id: string;
  statements: Statements;
  admissionState: AdmissionState;
  /** the open commands in the tables, in order */
  open: readonly CommandRow[];
  /**
   * Adds a row that a step has changed to the journal, and the seq up to which ended commands are
   * deleted with it (0: none). @returns the number of its entry
   */
  append: (row: CommandRow, deletedTo: number) => number;
}

export class LiveRobot implements RobotState {
  readonly commands: RobotCommands;
  /** One relay owns the database. */
  readonly isHeldElsewhere = false;
  readonly #id: string;
  readonly #statements: Statements;
  /** newest entry of each command whose current row is not in the tables, by seq */
  readonly #unsettled = new Map<number, number>();
  /** keys of ended commands that only the tables hold; null: not all are known */
  #left: KeyIndex<true> | null;
  /** value of `commands.deletedUpTo` that an entry records, and that entry; 0: the tables have it */
  #recorded = 0;
  #recordedAt = 0;

  constructor({ id, statements, admissionState, open, append }: LiveRobotParts) {
    this.#id = id;
    this.#statements = statements;
    this.#left = admissionState.lastSeq > open.length ? null : new KeyIndex();
    this.commands = new RobotCommands(admissionState, open, (row) => {
      const { deletedUpTo } = this.commands;
      this.#note(row.seq, append(row, deletedUpTo > this.#recorded ? deletedUpTo : 0));
    });
  }

  /** The command in memory or in the tables. */
  row(seq: number): CommandRow | null {
    const known = this.commands.row(seq);
    if (known !== null || seq <= this.commands.deletedUpTo) return known;
    return rowsIn(this.#statements, BY_SEQ, [this.#id, seq])[0] ?? null;
  }

  /** The command with this idempotency key. */
  withKey(driver: string, key: string): CommandRow | null {
    const inMemory = this.commands.withKey(driver, key);
    if (inMemory !== null || !this.#mayHaveLeft(driver, key)) return inMemory;
    const [row] = rowsIn(this.#statements, BY_KEY, [this.#id, driver, key]);
    return row === undefined || row.seq <= this.commands.deletedUpTo ? null : row;
  }

  /** Commands with a higher seq, in order. */
  recordsAfter(seq: number, limit: number): CommandRecord[] {
    const after = Math.max(seq, this.commands.deletedUpTo);
    const inTables = rowsIn(this.#statements, AFTER, [this.#id, after, limit]);
    const bySeq = new Map(inTables.map((row) => [row.seq, row]));
    for (const row of this.commands.rows()) if (row.seq > seq) bySeq.set(row.seq, row);
    const rows = [...bySeq.values()].toSorted((a, b) => a.seq - b.seq);
    return rows.slice(0, limit).map((row) => shownRecordIn(this.commands, row));
  }

  ended({ after, upTo }: SeqRange): CommandRow[] {
    const from = Math.max(after, this.commands.deletedUpTo);
    const inTables = rowsIn(this.#statements, ENDED, [this.#id, from, upTo]);
    const known = inTables.map((row) => this.commands.row(row.seq) ?? row);
    const isMeant = ({ seq }: CommandRow): boolean => seq > from && seq <= upTo;
    const rows = new Set([...known, ...this.commands.rows().filter(isMeant)]);
    return [...rows].filter(({ state }) => hasEnded(state));
  }

  newest(overtakes: Overtaking, after: number): number | null {
    const from = Math.max(after, this.commands.deletedUpTo);
    const inTables = this.#statements.number(NEWEST, [this.#id, from, overtakes]);
    const inMemory = newestOvertaking(this.commands.rows(), overtakes, after);
    return inMemory === null ? inTables : Math.max(inTables ?? inMemory, inMemory);
  }

  get permissions(): Permissions {
    return {
      keys: keysIn(this.#statements, this.#id),
      blocked: blockedScriptsIn(this.#statements, this.#id),
    };
  }

  setKeys({ added, revoked, now }: KeysChange): void {
    removeKeys(this.#statements, this.#id, revoked);
    addKeys(this.#statements, this.#id, added, now);
  }

  setBlocked(blocked: readonly StoredScript[]): void {
    setBlockedScripts(this.#statements, this.#id, blocked);
  }

  setPage(name: string): void {
    this.#statements.run("UPDATE sessions SET page = ? WHERE id = ?", [name, this.#id]);
  }

  /** Stores what a step has changed. @param before the state before the step */
  storeAdmissionState(before: Omit<AdmissionState, "keys" | "blocked">): void {
    const { epoch, lastSeq, isPaused, mayReset } = this.commands.admissionState;
    // The journal contains the seqs of new commands.
    const seq = lastSeq === before.lastSeq ? 0 : lastSeq;
    const isPermitted = isPaused === before.isPaused && mayReset === before.mayReset;
    if (seq === 0 && epoch === before.epoch && isPermitted) return;
    this.#statements.run(
      "UPDATE sessions SET epoch = ?, paused = ?, may_reset = ?, last_seq = max(last_seq, ?) WHERE id = ?",
      [epoch, isPaused ? 1 : 0, mayReset ? 1 : 0, seq, this.#id],
    );
  }

  /** Whether the tables hold every row and no command is open. */
  get isAtRest(): boolean {
    return this.commands.openCount === 0 && this.#unsettled.size === 0;
  }

  /** Ended commands up to this seq must be deleted from the tables; 0: none. */
  get toDelete(): number {
    return this.#recordedAt === 0 ? 0 : this.#recorded;
  }

  /** Restores a row from the journal. */
  restore({ row, deletedTo }: { row: CommandRow; deletedTo: number }, entry: number): void {
    this.commands.deleteEnded(deletedTo);
    this.commands.restore(row);
    this.#note(row.seq, entry);
  }

  /** The newest entry of each row that the tables lack, and the seq of each deleted command. */
  unsettled(): { rows: number[]; gone: number[] } {
    const rows: number[] = [];
    const gone: number[] = [];
    for (const [seq, entry] of this.#unsettled)
      if (this.commands.row(seq) === null) gone.push(seq);
      else rows.push(entry);
    return { rows, gone };
  }

  /**
   * Called once the tables hold all entries up to this one. Releases ended commands from memory.
   */
  settled(upTo: number): void {
    for (const [seq, entry] of this.#unsettled) {
      if (entry > upTo) continue;
      this.#unsettled.delete(seq);
      const row = this.commands.endedRow(seq);
      // Lookups ignore ended rows in the tables up to `deletedUpTo`, so a row below it stays in
      // memory.
      if (row !== null && seq > this.commands.deletedUpTo) this.#leave(row);
    }
    if (this.#recordedAt <= upTo) this.#recordedAt = 0;
  }

  /** Whether the tables may hold a command with this key that is not in memory. */
  #mayHaveLeft(driver: string, key: string): boolean {
    return this.#left === null || this.#left.get(driver, key) === true;
  }

  #leave(row: CommandRow): void {
    if (row.key !== null) this.#left?.set(row.driver, row.key, true);
    if ((this.#left?.size ?? 0) > MOST_LEFT) this.#left = null;
    this.commands.release(row);
  }

  #note(seq: number, entry: number): void {
    this.#unsettled.set(seq, entry);
    if (this.commands.deletedUpTo <= this.#recorded) return;
    this.#recorded = this.commands.deletedUpTo;
    this.#recordedAt = entry;
  }
}
