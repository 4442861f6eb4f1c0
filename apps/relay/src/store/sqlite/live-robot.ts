/**
 * A robot whose current commands are in memory, so that the usual steps of a command need no
 * tables. It holds the open commands, and the ended commands that no table holds yet. This class
 * records which changes the tables lack; the rules are in `commands`.
 */
import type { CommandRow } from "../../commands/command-row.ts";
import { KeyIndex } from "../../commands/key-index.ts";
import { RobotCommands, type AccessState } from "../../commands/robot-commands.ts";

/** Looking up a key in the tables takes as long as all other work of the store for a command. */
const MOST_LEFT = 1_000;

export class LiveRobot {
  readonly commands: RobotCommands;
  readonly #keep: (row: CommandRow, deletedTo: number) => number;
  /** newest entry of each command whose current row is not in the tables, by seq */
  readonly #unsettled = new Map<number, number>();
  /** keys of ended commands that only the tables hold; null: not all are known */
  #left: KeyIndex<true> | null;
  /** value of `commands.deletedUpTo` that an entry records, and that entry; 0: the tables have it */
  #recorded = 0;
  #recordedAt = 0;

  /**
   * @param open the open commands in the tables, in order
   * @param keep receives each row that a step has changed, and the seq up to which ended commands
   *   are deleted with it (0: none). @returns the number of its entry
   */
  constructor(
    accessState: AccessState,
    open: readonly CommandRow[],
    keep: (row: CommandRow, deletedTo: number) => number,
  ) {
    this.#keep = keep;
    this.#left = accessState.lastSeq > open.length ? null : new KeyIndex();
    this.commands = new RobotCommands(accessState, open, (row) => {
      const { deletedUpTo } = this.commands;
      this.#note(row.seq, this.#keep(row, deletedUpTo > this.#recorded ? deletedUpTo : 0));
    });
  }

  /** Whether the tables hold every row and no command is open. */
  get isAtRest(): boolean {
    return this.commands.openCount === 0 && this.#unsettled.size === 0;
  }

  /** Ended commands up to this seq must be deleted from the tables; 0: none. */
  get toDelete(): number {
    return this.#recordedAt === 0 ? 0 : this.#recorded;
  }

  /** Whether the tables may hold a command with this key that is not in memory. */
  mayHaveLeft(driver: string, key: string): boolean {
    return this.#left === null || this.#left.get(driver, key) === true;
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
