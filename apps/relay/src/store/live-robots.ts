/**
 * The robots whose commands are at hand, and the journal that keeps what becomes of these.
 *
 * A command changes four times in a second or two, and each change in the tables writes pages of several
 * indexes, of which every robot has its own. The journal is written at its end alone, and a commit of many
 * robots' changes writes a few pages. Rows come into the tables later, a robot's all at once and as they are
 * by then: when the journal has grown long, the robot that has waited longest first. What the journal holds
 * beyond the tables is read again when the file is opened, and when steps were undone.
 *
 * All of it is to be called in steps of the file, but for `peek`, `due` and `tidied`, and nobody else may change commands
 * in the tables.
 */
import { entryOf, rowIn, type CommandRow } from "./command-row.ts";
import { EntryOwners } from "./entry-owners.ts";
import type { Memory } from "./group-commit.ts";
import type { Bringing, Entry, Tidying } from "./journal-writer.ts";
import { LiveRobot, type Standing } from "./live-robot.ts";
import { numberIn, rowsIn } from "./sqlite-rows.ts";
import type { Statements } from "./statements.ts";

/** Entries that the journal has before rows are brought into the tables: some 5 MB. */
export const LONG = 16_384;
/** Where there is always something else to write, it may get so many times as long. */
const MUCH_LONGER = 4;
/** What of one robot has ended and is at hand; what reads its commands goes through all of these. */
const MOST_ENDED = 256;
/**
 * Rows that are brought in at a time, of whole robots, so that nobody waits for it and a full disk has room for it; more
 * where a slow disk lets more entries come at a time.
 */
const ROWS_AT_A_TIME = 64;
/** Entries that are deleted at a time: more than come with them, as a rule, so that the journal gets no longer. */
const ENTRIES_AT_A_TIME = 256;

const OPEN_ROWS =
  "SELECT entry FROM commands WHERE robot = ? AND seq >= ? AND is_open = 1 ORDER BY seq";

interface SessionRow {
  epoch: number;
  last_seq: number;
  paused: 0 | 1;
  open_from: number;
}

export class LiveRobots implements Memory {
  readonly #statements: Statements;
  readonly #append: (entry: Entry) => void;
  readonly #long: number;
  readonly #live = new Map<string, LiveRobot>();
  /** number of the first entry of each that has some that the tables do not have, in the order of these */
  readonly #unsettled = new Map<string, number>();
  /** the same of those that are being brought into the tables */
  readonly #bringing = new Map<string, number>();
  readonly #owners = new EntryOwners();
  /** number of the next entry */
  #next = 1;
  /** those of which much has ended */
  readonly #crowded = new Set<string>();
  /** entries of robots that are gone */
  #orphans: number[] = [];
  /** why the commands of these cannot be read, and their entries, which stay */
  readonly #broken = new Map<string, { error: unknown; entries: number[] }>();
  /** what is at hand does not hold */
  #isUndone = true;

  /**
   * @param statements that are undone with the step that they are in
   * @param append writes an entry with the step that it is in
   * @param long entries that the journal has before rows are brought into the tables
   */
  constructor(statements: Statements, append: (entry: Entry) => void, long: number) {
    this.#statements = statements;
    this.#append = append;
    this.#long = long;
    this.#restore();
  }

  /** Steps were undone that may have changed what is at hand. */
  undone(): void {
    this.#isUndone = true;
  }

  /** The robot as it is at this moment, outside of a step; null: that is not known without reading. */
  peek(id: string): LiveRobot | null {
    return this.#isUndone ? null : (this.#live.get(id) ?? null);
  }

  /** @returns the robot with its commands at hand from now on; null: there is no such robot */
  open(id: string): LiveRobot | null {
    if (this.#isUndone) this.#restore();
    return this.#load(id);
  }

  /** The robot's keys, or the scripts that were sent away, are others now. */
  refresh(id: string, { standing }: LiveRobot): void {
    Object.assign(standing, this.#whoMay(id));
  }

  /** A step is done with the robot: what need not be at hand is let go. */
  done(id: string, robot: LiveRobot): void {
    if (robot.endedCount > MOST_ENDED) this.#crowded.add(id);
    this.#release(id, robot);
  }

  /** These robots are gone from the tables: their entries are no more than `orphans`. */
  remove(ids: readonly string[]): void {
    if (this.#isUndone) this.#restore();
    const gone = new Set(ids);
    for (const id of gone) {
      this.#orphan(this.#broken.get(id)?.entries ?? []);
      this.#live.delete(id);
      this.#unsettled.delete(id);
      this.#broken.delete(id);
    }
    this.#orphan(this.#owners.deleteOf(gone));
  }

  /** There may be more of them than a call can be given. */
  #orphan(entries: readonly number[]): void {
    for (const entry of entries) this.#orphans.push(entry);
  }

  /** Whether the journal still has entries of robots that are gone. */
  get hasOrphans(): boolean {
    return this.#orphans.length > 0;
  }

  /** Deletes some of them. */
  deleteOrphans(): void {
    // What was deleted may be there again, and the robot of these entries with it.
    if (this.#isUndone) this.#restore();
    for (const entry of this.#orphans.splice(-ENTRIES_AT_A_TIME))
      this.#statements.run("DELETE FROM journal WHERE id = ?", [entry]);
  }

  /** Whether there is something to tidy, for whoever has time. */
  get isUntidy(): boolean {
    return this.#owners.size > this.#long;
  }

  /**
   * What is to be written with the next entries; `tidied` has to be told of it before more is.
   * @param isIdle there is time; otherwise only what cannot wait is
   */
  due(entries: number, isIdle: boolean): Tidying | null {
    const isLong = this.#owners.size > this.#long * (isIdle ? 1 : MUCH_LONGER);
    if (this.#isUndone || (!isLong && this.#crowded.size === 0)) return null;
    const bringing: Bringing[] = [];
    let left = Math.max(ROWS_AT_A_TIME, 2 * entries);
    for (const id of this.#inTurn(isLong)) {
      this.#crowded.delete(id);
      const robot = this.#live.get(id);
      const first = this.#unsettled.get(id);
      if (robot === undefined || first === undefined) continue;
      this.#unsettled.delete(id);
      this.#bringing.set(id, first);
      const { lastSeq } = robot.standing;
      const { openFrom, toForget: forgotten } = robot;
      const { rows, gone } = robot.unsettled();
      const upTo = this.#next - 1;
      bringing.push({ robot: id, entries: rows, gone, upTo, lastSeq, openFrom, forgotten });
      left -= rows.length + gone.length;
      if (left <= 0) break;
    }
    const most = Math.max(ENTRIES_AT_A_TIME, 4 * entries);
    const deleted = isLong ? this.#settledEntries(most) : 0;
    if (bringing.length === 0 && deleted === 0) return null;
    return { bringing, deleted, kept: [...this.#broken.keys()] };
  }

  /** What was due is on disk, or nothing of it. @param failed why it is not */
  tidied({ bringing, deleted }: Tidying, failed: unknown): void {
    if (failed === null) {
      for (const { robot: id, upTo } of bringing) {
        const robot = this.#live.get(id);
        robot?.settled(upTo);
        if (robot !== undefined) this.#release(id, robot);
      }
      this.#owners.deleteUpTo(deleted);
    } else {
      const all = [...new Map([...this.#unsettled, ...this.#bringing])];
      this.#unsettled.clear();
      for (const [id, first] of all.toSorted(([, a], [, b]) => a - b))
        this.#unsettled.set(id, first);
    }
    this.#bringing.clear();
  }

  /** Robots in the order in which their rows are to be brought into the tables. */
  *#inTurn(isLong: boolean): Iterable<string> {
    yield* this.#crowded;
    if (isLong) yield* this.#unsettled.keys();
  }

  #load(id: string): LiveRobot | null {
    const known = this.#live.get(id);
    if (known !== undefined) return known;
    const broken = this.#broken.get(id);
    if (broken !== undefined) throw broken.error;
    const sql = "SELECT epoch, last_seq, paused, open_from FROM sessions WHERE id = ?";
    const [session] = this.#statements.all(sql, [id]) as unknown as SessionRow[];
    if (session === undefined) return null;
    const { epoch, last_seq: lastSeq, paused, open_from: openFrom } = session;
    const standing = { epoch, lastSeq, isPaused: paused === 1, ...this.#whoMay(id) };
    const open = rowsIn(this.#statements, OPEN_ROWS, [id, openFrom]);
    const robot = new LiveRobot(standing, open, (...kept) => this.#keep(id, ...kept));
    this.#live.set(id, robot);
    return robot;
  }

  /** Reads what the journal holds beyond the tables, in the place of all that is at hand. */
  #restore(): void {
    this.#live.clear();
    this.#unsettled.clear();
    this.#bringing.clear();
    this.#crowded.clear();
    this.#broken.clear();
    this.#orphans = [];
    this.#owners.clear();
    const settled = numberIn(this.#statements, "SELECT max(settled) AS found FROM sessions") ?? 0;
    // A number counts once for each robot, also when the journal is empty.
    this.#next = settled + 1;
    const entries = this.#statements.all(
      `SELECT journal.id, robot, settled, entry FROM journal LEFT JOIN sessions ON sessions.id = robot
       ORDER BY journal.id`,
    ) as unknown as { id: number; robot: string; settled: number | null; entry: string }[];
    for (const { id, robot, settled: until, entry } of entries) {
      this.#next = Math.max(this.#next, id + 1);
      if (until === null) this.#orphans.push(id);
      if (until === null || id <= until || this.#broken.has(robot)) continue;
      try {
        this.#load(robot)?.restore(rowIn(entry), id);
        this.#note(robot, id);
      } catch (error) {
        // One robot that cannot be read must not be the end of all others: it fails whenever it is asked for.
        this.#broken.set(robot, { error, entries: [] });
        this.#live.delete(robot);
        this.#unsettled.delete(robot);
      }
    }
    for (const { id, robot, settled: until } of entries) {
      if (until === null) continue;
      const broken = this.#broken.get(robot);
      // What the tables do not have of it stays, whatever becomes of the rest of the journal.
      if (broken !== undefined && id > until) broken.entries.push(id);
      else this.#owners.add(id, robot);
    }
    this.#isUndone = false;
  }

  #keep(id: string, row: CommandRow, forgotten: number): number {
    const entry = this.#next++;
    this.#append([entry, id, entryOf(row, forgotten)]);
    this.#owners.add(entry, id);
    this.#note(id, entry);
    return entry;
  }

  #note(id: string, entry: number): void {
    if (!this.#unsettled.has(id)) this.#unsettled.set(id, entry);
  }

  /** The newest of the oldest entries, of which the tables have all that they say. */
  #settledEntries(most: number): number {
    const [unsettled = this.#next] = this.#unsettled.values();
    return this.#owners.lastOfOldest(most, Math.min(unsettled, ...this.#bringing.values()));
  }

  #release(id: string, robot: LiveRobot): void {
    if (robot.isAtRest) this.#live.delete(id);
  }

  #whoMay(id: string): Pick<Standing, "keys" | "away"> {
    return {
      keys: this.#texts("SELECT hash FROM keys WHERE robot = ?", id),
      away: this.#texts("SELECT id FROM away WHERE robot = ?", id),
    };
  }

  #texts(sql: string, id: string): ReadonlySet<string> {
    return new Set(this.#statements.all(sql, [id]).map((row) => String(Object.values(row)[0])));
  }
}
