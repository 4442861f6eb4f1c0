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

/** Entries that the journal has before rows are brought into the tables: some 20 MB. */
export const LONG = 65_536;
/** What of one robot has ended and is at hand; what reads its commands goes through all of these. */
const MOST_ENDED = 256;
/** Entries that are freed for each new one then: the journal gets no longer, and no step does much of it. */
const FREED = 2;
/** What has been freed is deleted once it is such a part of a long journal. */
const DELETED = 1 / 64;

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
  /** entries that are to be freed */
  #owed = 0;
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

  /** A step is done with the robot: what need not be at hand is let go, and a long journal made shorter. */
  done(id: string, robot: LiveRobot): void {
    if (robot.endedCount > MOST_ENDED) this.#bringIn(id, robot);
    this.#release(id, robot);
    while (this.#owed > 0 && this.#unsettled.size > 0) this.#freeOldest();
  }

  /** These robots are gone from the tables: nothing of them stays. */
  remove(ids: readonly string[]): void {
    if (this.#isUndone) this.#restore();
    const gone = new Set(ids);
    for (const id of gone) {
      this.#live.delete(id);
      this.#unsettled.delete(id);
    }
    for (const [entry, owner] of this.#owners) {
      if (!gone.has(owner)) continue;
      this.#statements.run("DELETE FROM journal WHERE id = ?", [entry]);
      this.#owners.delete(entry);
    }
  }

  #load(id: string): LiveRobot | null {
    const known = this.#live.get(id);
    if (known !== undefined) return known;
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
    this.#owed = 0;
    this.#owners.clear();
    const settled = numberIn(this.#statements, "SELECT max(settled) AS found FROM sessions") ?? 0;
    // A number counts once for each robot, also when the journal is empty.
    this.#next = settled + 1;
    const entries = this.#statements.all(
      `SELECT journal.id, robot, settled, entry FROM journal JOIN sessions ON sessions.id = robot
       ORDER BY journal.id`,
    ) as unknown as { id: number; robot: string; settled: number; entry: string }[];
    for (const { id, robot, settled: until, entry } of entries) {
      this.#owners.set(id, robot);
      this.#next = Math.max(this.#next, id + 1);
      if (id <= until) continue;
      this.#load(robot)?.put(rowOf(JSON.parse(entry) as unknown[]));
      this.#note(robot, id);
    }
    this.#isUndone = false;
  }

  #keep(id: string, row: CommandRow): void {
    const entry = this.#next++;
    const sql = "INSERT INTO journal (id, robot, entry) VALUES (?, ?, ?)";
    this.#statements.run(sql, [entry, id, JSON.stringify(columnsOf(row))]);
    this.#owners.set(entry, id);
    this.#note(id, entry);
    if (this.#owners.size > this.#long) this.#owed += FREED;
  }

  #note(id: string, entry: number): void {
    const unsettled = this.#unsettled.get(id);
    if (unsettled === undefined) this.#unsettled.set(id, { first: entry, entries: 1 });
    else unsettled.entries += 1;
  }

  #freeOldest(): void {
    const [oldest] = this.#unsettled;
    if (oldest === undefined) return;
    const [id, { entries }] = oldest;
    this.#owed -= entries;
    const robot = this.#live.get(id);
    if (robot === undefined) throw new Error("a robot with entries in the journal is not at hand");
    this.#bringIn(id, robot);
    this.#release(id, robot);
    const [next] = this.#unsettled.values();
    this.#deleteUntil(next?.first ?? this.#next);
  }

  #deleteUntil(first: number): void {
    const [oldest = first] = this.#owners.keys();
    if (first - oldest < this.#long * DELETED) return;
    this.#statements.run("DELETE FROM journal WHERE id < ?", [first]);
    for (const entry of this.#owners.keys()) {
      if (entry >= first) return;
      this.#owners.delete(entry);
    }
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
