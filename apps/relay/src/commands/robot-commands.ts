/**
 * A robot's commands in memory, which the state machine changes: all open commands, and those ended
 * ones that a store has not released. A store is notified of each change, and stores it.
 */
import { hasEnded, type CommandState } from "@corridor/protocol";
import type { CommandRow } from "./command-row.ts";
import { KeyIndex } from "./key-index.ts";

/** Robot state that determines which commands are accepted. */
export interface AccessState {
  epoch: number;
  lastSeq: number;
  isPaused: boolean;
  /** whether scripts may reset the robot */
  mayReset: boolean;
  /** hashes */
  keys: ReadonlySet<string>;
  /** ids of blocked scripts */
  blocked: ReadonlySet<string>;
}

/** @param before state before the change; null: the command is new */
export type OnChange = (row: CommandRow, before: CommandState | null) => void;

export class RobotCommands {
  readonly accessState: AccessState;
  readonly #onChange: OnChange;
  readonly #open = new Map<number, CommandRow>();
  readonly #ended = new Map<number, CommandRow>();
  readonly #byKey = new KeyIndex<CommandRow>();
  #deletedUpTo = 0;
  #delivered = 0;
  readonly #waiting = { overtaking: 0, others: 0 };

  /** @param open the open commands, in order */
  constructor(accessState: AccessState, open: readonly CommandRow[], onChange: OnChange) {
    this.accessState = accessState;
    this.#onChange = onChange;
    for (const row of open) this.#place(row);
  }

  /** Open commands in order, without those that end during the iteration. */
  get open(): Iterable<CommandRow> {
    return this.#open.values();
  }

  get openCount(): number {
    return this.#open.size;
  }

  /** Every command before this seq has ended. */
  get openFrom(): number {
    const [first] = this.#open.keys();
    return first ?? this.accessState.lastSeq + 1;
  }

  /** Number of ended commands in memory. */
  get endedCount(): number {
    return this.#ended.size;
  }

  /** Commands up to this seq that had ended at the last `deleteEnded` count as deleted. */
  get deletedUpTo(): number {
    return this.#deletedUpTo;
  }

  row(seq: number): CommandRow | null {
    return this.#open.get(seq) ?? this.#ended.get(seq) ?? null;
  }

  endedRow(seq: number): CommandRow | null {
    return this.#ended.get(seq) ?? null;
  }

  /** All commands in memory, in order. */
  rows(): CommandRow[] {
    return [...this.#ended.values(), ...this.#open.values()].toSorted((a, b) => a.seq - b.seq);
  }

  /** @returns the command in memory with this key */
  withKey(driver: string, key: string): CommandRow | null {
    return this.#byKey.get(driver, key) ?? null;
  }

  /** Number of accepted commands, without those that bypass the queue. */
  get waitingCount(): number {
    return this.#waiting.others;
  }

  /** Number of delivered commands, without those that bypass the queue. */
  get deliveredCount(): number {
    return this.#delivered;
  }

  /**
   * Whether the page has as many commands as it may have, and no waiting command bypasses the
   * limit.
   */
  hasAll(window: number): boolean {
    return this.#delivered >= window && this.#waiting.overtaking === 0;
  }

  /** Adds a command. */
  add(row: CommandRow): CommandRow {
    this.#put(row);
    this.#onChange(row, null);
    return row;
  }

  /** Changes an open command, or shortens an ended one. */
  change(row: CommandRow, change: Partial<CommandRow>): CommandRow {
    const before = row.state;
    this.#count(row, -1);
    Object.assign(row, change);
    this.#put(row);
    this.#onChange(row, before);
    return row;
  }

  /** Sets a command to a state that is stored already. */
  restore(row: CommandRow): void {
    const before = this.#open.get(row.seq);
    if (before !== undefined) this.#count(before, -1);
    this.#put(row);
  }

  /** Deletes the commands up to this seq that have ended by now. */
  deleteEnded(seq: number): void {
    if (seq <= this.#deletedUpTo) return;
    this.#deletedUpTo = seq;
    for (const row of this.#ended.values()) if (row.seq <= seq) this.release(row);
  }

  /** Removes an ended command from memory. */
  release(row: CommandRow): void {
    this.#ended.delete(row.seq);
    const { driver, key } = row;
    // Another command may have reused the key of a deleted one.
    if (key !== null && this.#byKey.get(driver, key) === row) this.#byKey.delete(driver, key);
  }

  #put(row: CommandRow): void {
    this.#place(row);
    this.accessState.lastSeq = Math.max(this.accessState.lastSeq, row.seq);
  }

  #place(row: CommandRow): void {
    if (row.key !== null) this.#byKey.set(row.driver, row.key, row);
    if (!hasEnded(row.state)) {
      this.#open.set(row.seq, row);
      this.#count(row, 1);
      return;
    }
    this.#open.delete(row.seq);
    this.#ended.set(row.seq, row);
  }

  #count({ state, overtakes }: CommandRow, by: 1 | -1): void {
    if (state === "delivered" && overtakes === null) this.#delivered += by;
    if (state === "accepted") this.#waiting[overtakes === null ? "others" : "overtaking"] += by;
  }
}
