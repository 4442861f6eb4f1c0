/**
 * A robot whose commands are at hand: in memory as they are, so that what every command goes through needs no
 * tables. It holds what has not ended, and what has ended and is in no table yet.
 */
import { hasEnded } from "@corridor/protocol";
import type { CommandRow } from "./command-row.ts";

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
  readonly #keep: (row: CommandRow) => void;
  readonly #open = new Map<number, CommandRow>();
  readonly #ended = new Map<number, CommandRow>();
  readonly #byKey = new Map<string, CommandRow>();
  /** numbers of those that the tables do not have as they are */
  readonly #unsettled = new Set<number>();
  #hasLeft: boolean;

  /**
   * @param open what has not ended, as the tables have it, in order
   * @param keep is told each row that a step has changed
   */
  constructor(standing: Standing, open: readonly CommandRow[], keep: (row: CommandRow) => void) {
    this.standing = standing;
    this.#keep = keep;
    this.#hasLeft = standing.lastSeq > open.length;
    for (const row of open) this.#place(row);
  }

  /** What has not ended, in order; what ends meanwhile is left out. */
  get open(): Iterable<CommandRow> {
    return this.#open.values();
  }

  /** The tables have all of it, and nothing is open. */
  get isAtRest(): boolean {
    return this.#open.size === 0 && this.#unsettled.size === 0;
  }

  /** How many have ended and are in no table yet. */
  get endedCount(): number {
    return this.#ended.size;
  }

  /** Whether the tables may have commands that are not at hand. */
  get hasLeft(): boolean {
    return this.#hasLeft;
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
    return this.#byKey.get(keyOf(driver, key)) ?? null;
  }

  /** A step changes one of its rows, or adds one. */
  change(row: CommandRow, change: Partial<CommandRow> = {}): CommandRow {
    Object.assign(row, change);
    this.put(row);
    this.#keep(row);
    return row;
  }

  /** A row as a step has left it that was kept before. */
  put(row: CommandRow): void {
    this.#place(row);
    this.#unsettled.add(row.seq);
    this.standing.lastSeq = Math.max(this.standing.lastSeq, row.seq);
  }

  /** What the tables do not have as it is. */
  unsettled(): CommandRow[] {
    return [...this.#unsettled].flatMap((seq) => this.row(seq) ?? []);
  }

  /** The tables have it all now, and what has ended is found there. */
  settled(): void {
    this.#unsettled.clear();
    this.#hasLeft ||= this.#ended.size > 0;
    for (const row of this.#ended.values())
      if (row.key !== null) this.#byKey.delete(keyOf(row.driver, row.key));
    this.#ended.clear();
  }

  /** Whether something up to this number has ended and is in no table yet. */
  holdsEnded(seq: number): boolean {
    for (const ended of this.#ended.keys()) if (ended <= seq) return true;
    return false;
  }

  #place(row: CommandRow): void {
    const isOver = hasEnded(row.state);
    (isOver ? this.#ended : this.#open).set(row.seq, row);
    if (isOver) this.#open.delete(row.seq);
    if (row.key !== null) this.#byKey.set(keyOf(row.driver, row.key), row);
  }
}

/** A hash has no space. */
function keyOf(driver: string, key: string): string {
  return `${driver} ${key}`;
}
