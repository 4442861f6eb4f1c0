/**
 * The default store: one SQLite file, with the SQLite that is built into Node.
 *
 * Steps are synchronous, so each one ends before any other code runs. Its result is returned once
 * its group is on disk. Steps are short. Changes of commands happen in memory and are appended to a
 * journal (`LiveRobots`). All other steps read rows of one robot by index. Only the deletion of
 * expired robots, once a minute, reads all robots, but not their commands. After a rollback, the
 * next step reads the journal of all robots again.
 */
import type { CommandRecord } from "@corridor/protocol";
import { z } from "zod";
import { recordOfRow, type RobotCommands } from "../../commands/robot-commands.ts";
import { shownRecordIn } from "../../commands/stored-conditions.ts";
import type { RobotStep } from "../../commands/robot-step.ts";
import type { LiveRobot } from "./live-robot.ts";
import { LiveRobots, LONG } from "./live-robots.ts";
import type { KeyTimes, KeyUse, NewRobot, RobotStore, StoredRobot } from "../robot-store.ts";
import { blockedScriptsIn } from "./sqlite-blocked-scripts.ts";
import { SqliteFile } from "./file/sqlite-file.ts";
import { addKeys, keysIn, keyTimesIn, noteKeyUses } from "./sqlite-keys.ts";
import type { Statements } from "./file/statements.ts";

const robotRow = z.object({
  id: z.string(),
  epoch: z.int(),
  page: z.string(),
  last_seq: z.int(),
  created_at: z.int(),
  last_used_at: z.int(),
  paused: z.int(),
  may_reset: z.int(),
});

/** Reads may use all of a robot in memory. */
interface Applied<T> {
  apply(robot: LiveRobot): T;
}

export class SqliteRobotStore implements RobotStore {
  readonly #file: SqliteFile;
  readonly #live: LiveRobots;

  /**
   * @param file a file or its path; closing the store closes the file
   * @param journal length in entries at which checkpoints start
   */
  constructor(file: SqliteFile | string, journal = LONG) {
    this.#file = typeof file === "string" ? new SqliteFile(file) : file;
    this.#live = new LiveRobots(this.#file, journal);
    this.#file.remember(this.#live);
    // A relay that was killed during a deletion leaves orphans. If this fails, the next deletion
    // retries it.
    if (this.#live.hasOrphans) this.#deleteOrphans().catch(() => undefined);
  }

  async create({ id, createdAt, keys }: NewRobot): Promise<void> {
    await this.#file.growingStep(() => {
      this.#writing.run("INSERT INTO sessions (id, created_at, last_used_at) VALUES (?, ?, ?)", [
        id,
        createdAt,
        createdAt,
      ]);
      addKeys(this.#writing, id, keys, createdAt);
    });
  }

  async find(id: string): Promise<StoredRobot | null> {
    const { reading } = this.#file;
    const row = robotIn(reading, id);
    if (row === null) return null;
    return {
      id,
      epoch: row.epoch,
      page: row.page,
      createdAt: row.created_at,
      lastUsedAt: row.last_used_at,
      keys: keysIn(reading, id),
      blocked: blockedScriptsIn(reading, id),
      isPaused: row.paused === 1,
      mayReset: row.may_reset === 1,
    };
  }

  commit<T>(id: string, step: RobotStep<T>): Promise<T> {
    const kind = step.changesRobot === true ? "rows" : "memory";
    const work = (): T => this.#of(id, step);
    return step.needsSpace === true
      ? this.#file.growingStep(work, kind)
      : this.#file.step(work, kind);
  }

  current(id: string): Pick<RobotCommands, "isWindowFull"> | null {
    return this.#file.isWaiting ? null : (this.#live.peek(id)?.commands ?? null);
  }

  async storeMaze(id: string, text: string): Promise<boolean> {
    const sql = "INSERT INTO mazes (robot, text) VALUES (?, ?) ON CONFLICT DO UPDATE SET text = ?2";
    return this.#file.growingStep(() => {
      if (robotIn(this.#writing, id) === null) return false;
      return this.#writing.run(sql, [id, text]) > 0;
    });
  }

  async maze(id: string): Promise<string | null> {
    const [row] = this.#file.reading.all("SELECT text FROM mazes WHERE robot = ?", [id]);
    return row === undefined ? null : String(row["text"]);
  }

  async keyTimes(id: string): Promise<KeyTimes[]> {
    return keyTimesIn(this.#file.reading, id);
  }

  async touch(id: string, now: number, keys: readonly KeyUse[]): Promise<void> {
    const sql = "UPDATE sessions SET last_used_at = max(last_used_at, ?) WHERE id = ?";
    await this.#file.step(() => {
      this.#writing.run(sql, [now, id]);
      noteKeyUses(this.#writing, id, keys);
    });
  }

  async remove(id: string): Promise<boolean> {
    const isGone = await this.#file.remove(
      () => {
        const removed = this.#writing.run("DELETE FROM sessions WHERE id = ?", [id]) > 0;
        if (removed) this.#live.remove([id]);
        return removed;
      },
      (removed) => removed,
    );
    if (isGone) await this.#deleteOrphans();
    return isGone;
  }

  async removeExpired(before: { lastUsedAt: number; createdAt: number }): Promise<string[]> {
    const sql = "DELETE FROM sessions WHERE last_used_at < ? OR created_at < ? RETURNING id";
    const gone = await this.#file.remove(
      () => {
        const rows = this.#writing.all(sql, [before.lastUsedAt, before.createdAt]);
        const ids = rows.map((row) => String(row["id"]));
        if (ids.length > 0) this.#live.remove(ids);
        return ids;
      },
      ({ length }) => length > 0,
    );
    if (gone.length > 0) await this.#deleteOrphans();
    return gone;
  }

  // Memory may be ahead of the disk. Reads of commands are steps too, so that they return only
  // stored changes.

  command(id: string, seq: number): Promise<CommandRecord | null> {
    return this.#read(id, null, (robot) => {
      const row = robot.row(seq);
      return row && shownRecordIn(robot.commands, row);
    });
  }

  commandsAfter(id: string, seq: number, limit: number): Promise<CommandRecord[]> {
    return this.#read<CommandRecord[]>(id, [], (robot) => robot.recordsAfter(seq, limit));
  }

  openCommands(id: string): Promise<CommandRecord[]> {
    return this.#read(id, [], ({ commands }) => [...commands.open].map(recordOfRow));
  }

  async check(): Promise<"ok" | "full"> {
    return this.#file.check();
  }

  async close(): Promise<void> {
    await this.#file.close();
  }

  get #writing(): Statements {
    return this.#file.writing;
  }

  /** Reads commands. @param none result if there is no such robot */
  #read<T>(id: string, none: T, apply: (robot: LiveRobot) => T): Promise<T> {
    return this.#file.step(() => this.#of(id, { none, apply }), "memory");
  }

  /** Applies a step to a robot. */
  #of<T>(id: string, step: Pick<RobotStep<T>, "none" | "changesRobot"> & Applied<T>): T {
    const robot = this.#live.open(id);
    if (robot === null) return step.none;
    const before = step.changesRobot === true ? { ...robot.commands.admissionState } : null;
    const result = step.apply(robot);
    if (before !== null) robot.storeAdmissionState(before);
    this.#live.done(id, robot);
    return result;
  }

  /**
   * Deletes the journal entries of deleted robots in batches. Runs at least once, so that a
   * concurrent deletion has finished when this returns.
   */
  async #deleteOrphans(): Promise<void> {
    do {
      await this.#file.remove(
        () => this.#live.deleteOrphans(),
        () => true,
      );
    } while (this.#live.hasOrphans);
  }
}

function robotIn(statements: Statements, id: string): z.infer<typeof robotRow> | null {
  const [row] = statements.all("SELECT * FROM sessions WHERE id = ?", [id]);
  return row === undefined ? null : robotRow.parse(row);
}
