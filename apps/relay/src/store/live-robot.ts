/**
 * A robot whose current commands are in memory, so that the usual steps of a command need no
 * tables. It holds the open commands, and the ended commands that no table holds yet.
 */
import { hasEnded } from "@corridor/protocol";
import type { CommandRow } from "../robots/commands/command-row.ts";
import { KeyIndex } from "../robots/commands/key-index.ts";

/** Looking up a key in the tables takes as long as all other work of the store for a command. */
const MOST_LEFT = 1_000;

/** Session state that determines which commands are accepted. */
export interface Standing {
  epoch: number;
  lastSeq: number;
  isPaused: boolean;
  /** hashes */
  keys: ReadonlySet<string>;
  /** ids of blocked scripts */
  away: ReadonlySet<string>;
}

export class LiveRobot {
  readonly standing: Standing;
  readonly #keep: (row: CommandRow, forgotten: number) => number;
  readonly #open = new Map<number, CommandRow>();
  readonly #ended = new Map<number, CommandRow>();
  readonly #byKey = new KeyIndex<CommandRow>();
  /** newest entry of each command whose current row is not in the tables, by seq */
  readonly #unsettled = new Map<number, number>();
  /** keys of ended commands that only the tables hold; null: not all are known */
  #left: KeyIndex<true> | null;
  #forgotten = 0;
  /**
   * entry that records the last deletion; Infinity: the next entry; 0: the tables have applied it
   */
  #forgottenAt = 0;
  #delivered = 0;
  readonly #waiting = { overtaking: 0, others: 0 };

  /**
   * @param open the open commands in the tables, in order
   * @param keep receives each row that a step has changed, and the seq up to which ended commands
   *   are deleted with it (0: none). @returns the number of its entry
   */
  constructor(
    standing: Standing,
    open: readonly CommandRow[],
    keep: (row: CommandRow, forgotten: number) => number,
  ) {
    this.standing = standing;
    this.#keep = keep;
    this.#left = standing.lastSeq > open.length ? null : new KeyIndex();
    for (const row of open) this.#place(row);
  }

  /** Open commands in order, without those that end during the iteration. */
  get open(): Iterable<CommandRow> {
    return this.#open.values();
  }

  /** Every command before this seq has ended. */
  get openFrom(): number {
    const [first] = this.#open.keys();
    return first ?? this.standing.lastSeq + 1;
  }

  /** Whether the tables hold every row and no command is open. */
  get isAtRest(): boolean {
    return this.#open.size === 0 && this.#unsettled.size === 0;
  }

  /** Number of ended commands that are not in the tables yet. */
  get endedCount(): number {
    return this.#ended.size;
  }

  /**
   * Ended commands in the tables up to this seq count as deleted. Those that ended later are in
   * memory.
   */
  get forgotten(): number {
    return this.#forgotten;
  }

  /** Ended commands up to this seq must be deleted from the tables; 0: none. */
  get toForget(): number {
    return this.#forgottenAt === 0 ? 0 : this.#forgotten;
  }

  row(seq: number): CommandRow | null {
    return this.#open.get(seq) ?? this.#ended.get(seq) ?? null;
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

  /**
   * Whether the page has as many commands as it may have, and no waiting command bypasses the
   * limit.
   */
  hasAll(window: number): boolean {
    return this.#delivered >= window && this.#waiting.overtaking === 0;
  }

  /** Number of delivered commands, without those that bypass the queue. */
  get deliveredCount(): number {
    return this.#delivered;
  }

  /** Whether the tables may hold a command with this key that is not in memory. */
  mayHaveLeft(driver: string, key: string): boolean {
    return this.#left === null || this.#left.get(driver, key) === true;
  }

  /** Changes or adds a row, in a step. */
  change(row: CommandRow, change: Partial<CommandRow> = {}): CommandRow {
    if (this.#open.has(row.seq)) this.#count(row, -1);
    Object.assign(row, change);
    const forgotten = this.#forgottenAt === Infinity ? this.#forgotten : 0;
    this.#put(row, this.#keep(row, forgotten));
    return row;
  }

  /** Restores a row from the journal. */
  restore({ row, forgotten }: { row: CommandRow; forgotten: number }, entry: number): void {
    this.forget(forgotten);
    const before = this.#open.get(row.seq);
    if (before !== undefined) this.#count(before, -1);
    this.#put(row, entry);
  }

  /** Deletes the commands up to this seq that have ended by now. The next change records it. */
  forget(seq: number): void {
    if (seq <= this.#forgotten) return;
    this.#forgotten = seq;
    this.#forgottenAt = Infinity;
    for (const row of this.#ended.values()) if (row.seq <= seq) this.#drop(row);
  }

  /** The newest entry of each row that the tables lack, and the seq of each deleted command. */
  unsettled(): { rows: number[]; gone: number[] } {
    const rows: number[] = [];
    const gone: number[] = [];
    for (const [seq, entry] of this.#unsettled)
      if (this.row(seq) === null) gone.push(seq);
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
      const row = this.#ended.get(seq);
      // Lookups ignore ended rows in the tables up to `#forgotten`, so a row below it stays in
      // memory.
      if (row !== undefined && seq > this.#forgotten) this.#leave(row);
    }
    if (this.#forgottenAt <= upTo) this.#forgottenAt = 0;
  }

  #leave(row: CommandRow): void {
    if (row.key !== null) this.#left?.set(row.driver, row.key, true);
    if ((this.#left?.size ?? 0) > MOST_LEFT) this.#left = null;
    this.#drop(row);
  }

  #put(row: CommandRow, entry: number): void {
    this.#place(row);
    this.#unsettled.set(row.seq, entry);
    if (this.#forgottenAt === Infinity) this.#forgottenAt = entry;
    this.standing.lastSeq = Math.max(this.standing.lastSeq, row.seq);
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
    if (state === "delivered" && !overtakes) this.#delivered += by;
    if (state === "accepted") this.#waiting[overtakes ? "overtaking" : "others"] += by;
  }

  #drop(row: CommandRow): void {
    this.#ended.delete(row.seq);
    const { driver, key } = row;
    // Another command may have reused the key of a deleted one.
    if (key !== null && this.#byKey.get(driver, key) === row) this.#byKey.delete(driver, key);
  }
}
