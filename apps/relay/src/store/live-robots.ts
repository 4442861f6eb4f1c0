/**
 * The robots whose commands are at hand, and the journal that keeps what becomes of these.
 *
 * A command changes four times in a second or two, and each change in the tables writes pages of several
 * indexes, of which every robot has its own. The journal is written at its end alone, and a commit of many
 * robots' changes writes a few pages. Rows come into the tables later, a robot's all at once and as they are
 * by then: when the journal has grown long, the robot that has waited longest first. What the journal holds
 * beyond the tables is read again when the file is opened, and when steps were undone.
 *
 * All of it is to be called in one step of the file, and nobody else may change commands in the tables.
 */
import { hasEnded } from "@corridor/protocol";
import { columnsOf, ROW_COLUMNS, rowOf, type CommandRow } from "./command-row.ts";
import { LiveRobot, type Standing } from "./live-robot.ts";
import { numberIn, rowsIn } from "./sqlite-rows.ts";
import { IS_OPEN, OPEN_COMMANDS } from "./sqlite-schema.ts";
import type { Statements } from "./statements.ts";

/** Entries that the journal has before rows are brought into the tables: some 10 MB. */
export const LONG = 32_768;
/** What of one robot has ended and is at hand; what reads its commands goes through all of these. */
const MOST_ENDED = 256;
/** What is tidied at a time, so that nobody waits for it and a full disk has room for it. */
const ENTRIES_AT_A_TIME = 512;

const OPEN_ROWS = `SELECT ${ROW_COLUMNS} FROM ${OPEN_COMMANDS} WHERE robot = ? AND ${IS_OPEN} ORDER BY seq`;
const KEEP_ROW = `INSERT INTO commands (robot, is_open, ${ROW_COLUMNS})
  VALUES (?, ?, ${ROW_COLUMNS.replaceAll(/\w+/g, "?")})
  ON CONFLICT (robot, seq) DO UPDATE SET is_open = excluded.is_open, state = excluded.state,
    reason = excluded.reason, recalled = excluded.recalled, pose = excluded.pose,
    distance = excluded.distance, epoch = excluded.epoch`;
const FORGET = "DELETE FROM commands WHERE robot = ? AND seq <= ? AND is_open = 0";

/** The entries of a robot since its rows were in the tables. */
interface Unsettled {
  /** number of its first entry, and how many there are */
  first: number;
  entries: number;
}

export class LiveRobots {
  readonly #statements: Statements;
  readonly #long: number;
  readonly #live = new Map<string, LiveRobot>();
  /** in the order of their first entries */
  readonly #unsettled = new Map<string, Unsettled>();
  /** whose each entry of the journal is, in order */
  readonly #owners = new Map<number, string>();
  /** number of the next entry */
  #next = 1;
  /** those of which much has ended */
  readonly #crowded = new Set<string>();
  /** entries of robots that are gone */
  #orphans: number[] = [];
  /** why the commands of these cannot be read */
  readonly #broken = new Map<string, unknown>();
  /** what is at hand does not hold */
  #isUndone = true;

  /**
   * @param statements that are undone with the step that they are in
   * @param long entries that the journal has before rows are brought into the tables
   */
  constructor(statements: Statements, long: number) {
    this.#statements = statements;
    this.#long = long;
    this.#restore();
  }

  /** Steps were undone that may have changed what is at hand. */
  undone(): void {
    this.#isUndone = true;
  }

  /** @returns the robot, if its commands are at hand */
  get(id: string): LiveRobot | null {
    if (this.#isUndone) this.#restore();
    return this.#live.get(id) ?? null;
  }

  /** @returns the robot with its commands at hand from now on; null: there is no such robot */
  open(id: string): LiveRobot | null {
    return this.get(id) ?? this.#load(id);
  }

  /** The robot's keys, or the scripts that were sent away, are others now. */
  refresh(id: string, { standing }: LiveRobot): void {
    Object.assign(standing, this.#whoMay(id));
  }

  /** Deletes what of the robot has ended, up to this number. */
  forget(id: string, robot: LiveRobot, seq: number): void {
    if (robot.holdsEnded(seq)) this.#bringIn(id, robot);
    this.#statements.run(FORGET, [id, seq]);
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
      this.#live.delete(id);
      this.#unsettled.delete(id);
      this.#broken.delete(id);
    }
    for (const [entry, owner] of this.#owners) {
      if (!gone.has(owner)) continue;
      this.#orphans.push(entry);
      this.#owners.delete(entry);
    }
  }

  /** Whether the journal still has entries of robots that are gone. */
  get hasOrphans(): boolean {
    return this.#orphans.length > 0;
  }

  /** Deletes some of them. */
  deleteOrphans(): void {
    for (const entry of this.#orphans.splice(-ENTRIES_AT_A_TIME))
      this.#statements.run("DELETE FROM journal WHERE id = ?", [entry]);
  }

  /** Whether there is something to tidy. */
  get isUntidy(): boolean {
    return this.#owners.size > this.#long || this.#crowded.size > 0;
  }

  /** Brings some rows into the tables, and deletes some entries that are not needed any more. */
  tidy(): void {
    if (this.#isUndone) this.#restore();
    let left = ENTRIES_AT_A_TIME;
    for (const id of this.#inTurn()) {
      this.#crowded.delete(id);
      left -= this.#unsettled.get(id)?.entries ?? 0;
      const robot = this.#live.get(id);
      if (robot === undefined) continue;
      this.#bringIn(id, robot);
      this.#release(id, robot);
      if (left <= 0) break;
    }
    if (this.#owners.size > this.#long) this.#deleteSettled();
  }

  /** Robots in the order in which their rows are to be brought into the tables. */
  *#inTurn(): Iterable<string> {
    yield* this.#crowded;
    for (const id of this.#unsettled.keys()) {
      if (this.#owners.size <= this.#long) return;
      yield id;
    }
  }

  #load(id: string): LiveRobot | null {
    const known = this.#live.get(id);
    if (known !== undefined) return known;
    if (this.#broken.has(id)) throw this.#broken.get(id);
    const sql = "SELECT epoch, last_seq AS lastSeq, paused FROM sessions WHERE id = ?";
    const [session] = this.#statements.all(sql, [id]);
    if (session === undefined) return null;
    const { epoch, lastSeq, paused } = session as { epoch: number; lastSeq: number; paused: 0 | 1 };
    const standing = { epoch, lastSeq, isPaused: paused === 1, ...this.#whoMay(id) };
    const open = rowsIn(this.#statements, OPEN_ROWS, [id]);
    const robot = new LiveRobot(standing, open, (row) => this.#keep(id, row));
    this.#live.set(id, robot);
    return robot;
  }

  /** Reads what the journal holds beyond the tables, in the place of all that is at hand. */
  #restore(): void {
    this.#live.clear();
    this.#unsettled.clear();
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
      else this.#owners.set(id, robot);
      if (until === null || id <= until || this.#broken.has(robot)) continue;
      try {
        this.#load(robot)?.put(rowOf(JSON.parse(entry) as unknown[]));
        this.#note(robot, id);
      } catch (error) {
        // One robot that cannot be read must not be the end of all others: it fails whenever it is asked for.
        this.#broken.set(robot, error);
        this.#live.delete(robot);
        this.#unsettled.delete(robot);
      }
    }
    this.#isUndone = false;
  }

  #keep(id: string, row: CommandRow): void {
    const entry = this.#next++;
    const sql = "INSERT INTO journal (id, robot, entry) VALUES (?, ?, ?)";
    this.#statements.run(sql, [entry, id, JSON.stringify(columnsOf(row))]);
    this.#owners.set(entry, id);
    this.#note(id, entry);
  }

  #note(id: string, entry: number): void {
    const unsettled = this.#unsettled.get(id);
    if (unsettled === undefined) this.#unsettled.set(id, { first: entry, entries: 1 });
    else unsettled.entries += 1;
  }

  /** Deletes the oldest entries as far as the tables have what they say. */
  #deleteSettled(): void {
    const [oldest] = this.#unsettled.values();
    const first = oldest?.first ?? this.#next;
    let until = 0;
    let left = ENTRIES_AT_A_TIME;
    for (const entry of this.#owners.keys()) {
      if (entry >= first || left-- === 0) break;
      this.#owners.delete(entry);
      until = entry;
    }
    this.#statements.run("DELETE FROM journal WHERE id <= ?", [until]);
  }

  #bringIn(id: string, robot: LiveRobot): void {
    if (!this.#unsettled.delete(id)) return;
    for (const row of robot.unsettled()) {
      this.#statements.run(KEEP_ROW, [id, hasEnded(row.state) ? 0 : 1, ...columnsOf(row)]);
    }
    const sql = "UPDATE sessions SET last_seq = ?, settled = ? WHERE id = ?";
    this.#statements.run(sql, [robot.standing.lastSeq, this.#next - 1, id]);
    robot.settled();
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
