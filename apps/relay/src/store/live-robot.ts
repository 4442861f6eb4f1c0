/**
 * A robot whose commands are at hand: in memory as they are, so that what every command goes through needs no
 * tables. It holds what has not ended, and what has ended and is in no table yet.
 */
import { hasEnded } from "@corridor/protocol";
import type { CommandRow } from "./command-row.ts";
import { KeyIndex } from "./key-index.ts";

/** To look for a key in the tables takes as long as all else that a command needs of its store. */
const MOST_LEFT = 1_000;

/** What of its session counts for its commands. */
export interface Standing {
  epoch: number;
  lastSeq: number;
  isPaused: boolean;
  /** hashes */
  keys: ReadonlySet<string>;
  /** ids of scripts */
  away: ReadonlySet<string>;
}

export class LiveRobot {
  readonly standing: Standing;
  readonly #keep: (row: CommandRow, forgotten: number) => number;
  readonly #open = new Map<number, CommandRow>();
  readonly #ended = new Map<number, CommandRow>();
  readonly #byKey = new KeyIndex<CommandRow>();
  /** numbers of those that the tables do not have as they are, with the newest entry of each */
  readonly #unsettled = new Map<number, number>();
  /** keys of those that have ended and are in the tables alone; null: not all are known */
  #left: KeyIndex<true> | null;
  #forgotten = 0;
  /** entry since which the tables have some that are forgotten; Infinity: the next one; 0: they have none */
  #forgottenAt = 0;
  #delivered = 0;
  readonly #waiting = { overtaking: 0, others: 0 };

  /**
   * @param open what has not ended, as the tables have it, in order
   * @param keep is told each row that a step has changed, and up to which number what has ended is forgotten
   *   with that; 0: nothing is. @returns number of its entry
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

  /** What has not ended, in order; what ends meanwhile is left out. */
  get open(): Iterable<CommandRow> {
    return this.#open.values();
  }

  /** Before this number, all of it has ended. */
  get openFrom(): number {
    const [first] = this.#open.keys();
    return first ?? this.standing.lastSeq + 1;
  }

  /** The tables have all of it, and nothing is open. */
  get isAtRest(): boolean {
    return this.#open.size === 0 && this.#unsettled.size === 0;
  }

  /** How many have ended and are in no table yet. */
  get endedCount(): number {
    return this.#ended.size;
  }

  /** Up to this number it is as if the tables had none that have ended: what ended later is at hand. */
  get forgotten(): number {
    return this.#forgotten;
  }

  /** Up to this number what has ended is to be deleted from the tables; 0: that was done. */
  get toForget(): number {
    return this.#forgottenAt === 0 ? 0 : this.#forgotten;
  }

  row(seq: number): CommandRow | null {
    return this.#open.get(seq) ?? this.#ended.get(seq) ?? null;
  }

  /** All that is at hand, in order. */
  rows(): CommandRow[] {
    return [...this.#ended.values(), ...this.#open.values()].toSorted((a, b) => a.seq - b.seq);
  }

  /** @returns what came with this key, of what is at hand */
  withKey(driver: string, key: string): CommandRow | null {
    return this.#byKey.get(driver, key) ?? null;
  }

  /** How many wait, without those that overtake. */
  get waitingCount(): number {
    return this.#waiting.others;
  }

  /** Whether the page has as many as it may have, and nothing waits that it may have all the same. */
  hasAll(window: number): boolean {
    return this.#delivered >= window && this.#waiting.overtaking === 0;
  }

  /** How many are delivered, without those that overtake. */
  get deliveredCount(): number {
    return this.#delivered;
  }

  /** Whether the tables may have a command with this key that is not at hand. */
  mayHaveLeft(driver: string, key: string): boolean {
    return this.#left === null || this.#left.get(driver, key) === true;
  }

  /** A step changes one of its rows, or adds one. */
  change(row: CommandRow, change: Partial<CommandRow> = {}): CommandRow {
    if (this.#open.has(row.seq)) this.#count(row, -1);
    Object.assign(row, change);
    const forgotten = this.#forgottenAt === Infinity ? this.#forgotten : 0;
    this.#put(row, this.#keep(row, forgotten));
    return row;
  }

  /** A row as a step has left it that was kept before. */
  restore({ row, forgotten }: { row: CommandRow; forgotten: number }, entry: number): void {
    this.forget(forgotten);
    const before = this.#open.get(row.seq);
    if (before !== undefined) this.#count(before, -1);
    this.#put(row, entry);
  }

  /** Forgets what has ended by now, up to this number; it is kept with the next change. */
  forget(seq: number): void {
    if (seq <= this.#forgotten) return;
    this.#forgotten = seq;
    this.#forgottenAt = Infinity;
    for (const row of this.#ended.values()) if (row.seq <= seq) this.#drop(row);
  }

  /** The newest entry of each that the tables do not have as it is, and the numbers of what is forgotten instead. */
  unsettled(): { rows: number[]; gone: number[] } {
    const rows: number[] = [];
    const gone: number[] = [];
    for (const [seq, entry] of this.#unsettled)
      if (this.row(seq) === null) gone.push(seq);
      else rows.push(entry);
    return { rows, gone };
  }

  /** The tables have all of it up to this entry now, and what has ended is found there. */
  settled(upTo: number): void {
    for (const [seq, entry] of this.#unsettled) {
      if (entry > upTo) continue;
      this.#unsettled.delete(seq);
      const row = this.#ended.get(seq);
      // In the tables nobody looks for one that ended when those around it were forgotten already.
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
    // Once it is forgotten, another may have come with its key.
    if (key !== null && this.#byKey.get(driver, key) === row) this.#byKey.delete(driver, key);
  }
}
