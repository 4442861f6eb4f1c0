/**
 * The robots whose commands are in memory, and the journal that stores the changes of these
 * commands.
 *
 * A command changes four times within a second or two. Each change in the tables would write pages
 * of several indexes, in a different place for each robot. The journal is written only at its end,
 * so a commit with changes of many robots writes a few pages. A checkpoint copies the current rows
 * of a robot to the tables later, once the journal is long. The robot that has waited longest is
 * first. Entries that the tables lack are read again when the file is opened and after a rollback.
 *
 * `open`, `done`, `remove` and `deleteOrphans` must be called in steps of the file. No other code may
 * change commands in the tables.
 */
import type { CommandRow, AdmissionState } from "../../commands/robot-commands.ts";
import { entryOf, rowIn, rowsIn, type Checkpoint, type Compaction } from "./file/journal.ts";
import { EntryOwners } from "./entry-owners.ts";
import type { Memory } from "./file/group-commit.ts";
import { LiveRobot } from "./live-robot.ts";
import type { SqliteFile } from "./file/sqlite-file.ts";
import type { Statements } from "./file/statements.ts";

/** Journal length in entries at which checkpoints start: about 5 MB. */
export const LONG = 16_384;
/** Factor by which the journal may exceed that length while it is never idle. */
const MUCH_LONGER = 4;
/**
 * Limit for the ended commands of one robot in memory. Reads of its commands iterate over all of
 * them.
 */
const MOST_ENDED = 256;
/**
 * Rows per checkpoint, rounded up to whole robots. A small number keeps delays short and fits on a
 * full disk. The number grows if a slow disk lets more entries arrive at a time.
 */
const ROWS_AT_A_TIME = 64;
/** Entries to delete at a time. Usually more than are added, so that the journal does not grow. */
const ENTRIES_AT_A_TIME = 256;

const OPEN_ROWS =
  "SELECT entry FROM commands WHERE robot = ? AND seq >= ? AND is_open = 1 ORDER BY seq";

/** The file of the journal; `writing` is rolled back together with its step. */
type JournalFile = Pick<SqliteFile, "writing" | "append">;

interface RobotRow {
  epoch: number;
  last_seq: number;
  paused: 0 | 1;
  may_reset: 0 | 1;
  open_from: number;
}

export class LiveRobots implements Memory {
  readonly #file: JournalFile;
  readonly #statements: Statements;
  readonly #long: number;
  readonly #live = new Map<string, LiveRobot>();
  /** first entry of each robot with entries that the tables lack, in order of these entries */
  readonly #unsettled = new Map<string, number>();
  readonly #owners = new EntryOwners();
  /** number of the next entry */
  #next = 1;
  /** robots with too many ended commands in memory */
  readonly #crowded = new Set<string>();
  /** entries of deleted robots */
  #orphans: number[] = [];
  /** robots whose commands cannot be read: the error, and the entries to retain */
  readonly #unreadable = new Map<string, { error: unknown; entries: number[] }>();
  /** memory is invalid and must be restored */
  #isRolledBack = true;

  /**
   * @param file receives the changes in the current step
   * @param long journal length in entries at which checkpoints start
   */
  constructor(file: JournalFile, long: number) {
    this.#file = file;
    this.#statements = file.writing;
    this.#long = long;
    this.#restore();
  }

  /** Called after a rollback that may have made memory invalid. */
  rolledBack(): void {
    this.#isRolledBack = true;
  }

  /** The robot in its current state, outside of a step; null if that requires a read. */
  peek(id: string): LiveRobot | null {
    return this.#isRolledBack ? null : (this.#live.get(id) ?? null);
  }

  /** Loads a robot's commands into memory. @returns null if there is no such robot */
  open(id: string): LiveRobot | null {
    if (this.#isRolledBack) this.#restore();
    return this.#load(id);
  }

  /** Called at the end of a step with the robot. Releases it from memory if possible. */
  done(id: string, robot: LiveRobot): void {
    if (robot.commands.endedCount > MOST_ENDED) this.#crowded.add(id);
    this.#release(id, robot);
  }

  /** Called after robots were deleted from the tables. Their entries become orphans. */
  remove(ids: readonly string[]): void {
    if (this.#isRolledBack) this.#restore();
    const gone = new Set(ids);
    for (const id of gone) {
      this.#orphan(this.#unreadable.get(id)?.entries ?? []);
      this.#live.delete(id);
      this.#unsettled.delete(id);
      this.#unreadable.delete(id);
    }
    this.#orphan(this.#owners.deleteOf(gone));
  }

  /** Not one call with all entries: there may be more of them than a call accepts. */
  #orphan(entries: readonly number[]): void {
    for (const entry of entries) this.#orphans.push(entry);
  }

  /** Whether the journal contains entries of deleted robots. */
  get hasOrphans(): boolean {
    return this.#orphans.length > 0;
  }

  /** Deletes a batch of orphaned entries. */
  deleteOrphans(): void {
    // A rollback may have restored the robot of these entries.
    if (this.#isRolledBack) this.#restore();
    for (const entry of this.#orphans.splice(-ENTRIES_AT_A_TIME))
      this.#statements.run("DELETE FROM journal WHERE id = ?", [entry]);
  }

  /** Whether an idle journal has something to compact. */
  get needsCompaction(): boolean {
    return this.#owners.size > this.#long;
  }

  /**
   * Compaction to write with the next entries. `compacted` must be called before the next write.
   * @param isIdle also compacts what could wait
   */
  due(entries: number, isIdle: boolean): Compaction | null {
    const isLong = this.#owners.size > this.#long * (isIdle ? 1 : MUCH_LONGER);
    if (this.#isRolledBack || (!isLong && this.#crowded.size === 0)) return null;
    const checkpoints: Checkpoint[] = [];
    const chosen = new Set<string>();
    let left = Math.max(ROWS_AT_A_TIME, 2 * entries);
    for (const id of this.#inTurn(isLong)) {
      this.#crowded.delete(id);
      const robot = this.#live.get(id);
      if (robot === undefined || !this.#unsettled.has(id) || chosen.has(id)) continue;
      chosen.add(id);
      const { openFrom, admissionState } = robot.commands;
      const { lastSeq } = admissionState;
      const { toDelete: deletedTo } = robot;
      const { rows, gone } = robot.unsettled();
      const upTo = this.#next - 1;
      checkpoints.push({ robot: id, entries: rows, gone, upTo, lastSeq, openFrom, deletedTo });
      left -= rows.length + gone.length;
      if (left <= 0) break;
    }
    const most = Math.max(ENTRIES_AT_A_TIME, 4 * entries);
    const deleted = isLong ? this.#settledEntries(most) : 0;
    if (checkpoints.length === 0 && deleted === 0) return null;
    return { checkpoints, deleted, unreadable: [...this.#unreadable.keys()] };
  }

  /** Called after a compaction. @param failed the error; null if it succeeded */
  compacted({ checkpoints, deleted }: Compaction, failed: unknown): void {
    if (failed !== null) return;
    for (const { robot: id, upTo } of checkpoints) {
      this.#unsettled.delete(id);
      const robot = this.#live.get(id);
      robot?.settled(upTo);
      if (robot !== undefined) this.#release(id, robot);
    }
    this.#owners.deleteUpTo(deleted);
  }

  /** Robots in the order of their checkpoints. */
  *#inTurn(isLong: boolean): Iterable<string> {
    yield* this.#crowded;
    if (isLong) yield* this.#unsettled.keys();
  }

  #load(id: string): LiveRobot | null {
    const known = this.#live.get(id);
    if (known !== undefined) return known;
    const unreadable = this.#unreadable.get(id);
    if (unreadable !== undefined) throw unreadable.error;
    const sql = "SELECT epoch, last_seq, paused, may_reset, open_from FROM sessions WHERE id = ?";
    const [row] = this.#statements.all(sql, [id]) as unknown as RobotRow[];
    if (row === undefined) return null;
    const { epoch, last_seq: lastSeq, open_from: openFrom } = row;
    const permitted = { isPaused: row.paused === 1, mayReset: row.may_reset === 1 };
    const admissionState = { epoch, lastSeq, ...permitted, ...this.#admissionStateOf(id) };
    const open = rowsIn(this.#statements, OPEN_ROWS, [id, openFrom]);
    const robot = new LiveRobot({
      id,
      statements: this.#statements,
      admissionState,
      open,
      append: (row, deletedTo) => this.#append(id, row, deletedTo),
    });
    this.#live.set(id, robot);
    return robot;
  }

  /** Replaces memory by the entries that the tables lack. */
  #restore(): void {
    this.#live.clear();
    this.#unsettled.clear();
    this.#crowded.clear();
    this.#unreadable.clear();
    this.#orphans = [];
    this.#owners.clear();
    const settled = this.#statements.number("SELECT max(settled) AS found FROM sessions") ?? 0;
    // New entries need numbers above every checkpoint, even if the journal is empty.
    this.#next = settled + 1;
    const entries = this.#statements.all(
      `SELECT journal.id, robot, settled, entry FROM journal LEFT JOIN sessions ON sessions.id = robot
       ORDER BY journal.id`,
    ) as unknown as { id: number; robot: string; settled: number | null; entry: string }[];
    for (const { id, robot, settled: until, entry } of entries) {
      this.#next = Math.max(this.#next, id + 1);
      if (until === null) this.#orphans.push(id);
      if (until === null || id <= until || this.#unreadable.has(robot)) continue;
      try {
        this.#load(robot)?.restore(rowIn(entry), id);
        this.#note(robot, id);
      } catch (error) {
        // An unreadable robot must not affect others. Each access to it throws this error.
        this.#unreadable.set(robot, { error, entries: [] });
        this.#live.delete(robot);
        this.#unsettled.delete(robot);
      }
    }
    for (const { id, robot, settled: until } of entries) {
      if (until === null) continue;
      const unreadable = this.#unreadable.get(robot);
      // Its entries that the tables lack are retained, whatever part of the journal is deleted.
      if (unreadable !== undefined && id > until) unreadable.entries.push(id);
      else this.#owners.add(id, robot);
    }
    this.#isRolledBack = false;
  }

  #append(id: string, row: CommandRow, deletedTo: number): number {
    const entry = this.#next++;
    this.#file.append([entry, id, entryOf(row, deletedTo)]);
    this.#owners.add(entry, id);
    this.#note(id, entry);
    return entry;
  }

  #note(id: string, entry: number): void {
    if (!this.#unsettled.has(id)) this.#unsettled.set(id, entry);
  }

  /** The newest of the oldest entries that the tables fully cover. */
  #settledEntries(most: number): number {
    const [unsettled = this.#next] = this.#unsettled.values();
    return this.#owners.lastOfOldest(most, unsettled);
  }

  #release(id: string, robot: LiveRobot): void {
    if (robot.isAtRest) this.#live.delete(id);
  }

  #admissionStateOf(id: string): Pick<AdmissionState, "keys" | "blocked"> {
    return {
      keys: this.#texts("SELECT hash FROM keys WHERE robot = ?", id),
      blocked: this.#texts("SELECT id FROM blocked_scripts WHERE robot = ?", id),
    };
  }

  #texts(sql: string, id: string): ReadonlySet<string> {
    return new Set(this.#statements.all(sql, [id]).map((row) => String(Object.values(row)[0])));
  }
}
