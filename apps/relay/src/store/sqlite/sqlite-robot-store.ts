/**
 * The default store: one SQLite file, with the SQLite that is built into Node.
 *
 * Steps are synchronous, so each one ends before any other code runs. Its result is returned once
 * its group is on disk. Steps are short. Changes of commands happen in memory and are appended to a
 * journal (`LiveRobots`). All other steps read rows of one robot by index. Only the deletion of
 * expired robots, once a minute, reads all robots, but not their commands.
 */
import type { CommandRecord, Ending, RecallCause } from "@corridor/protocol";
import { z } from "zod";
import { recordOfRow } from "../../commands/command-row.ts";
import { changeBlocked, changeKeys } from "../../commands/permissions.ts";
import * as machine from "../../commands/state-machine.ts";
import type { LiveRobot } from "./live-robot.ts";
import { LiveRobots, LONG } from "./live-robots.ts";
import {
  type AddResult,
  type BlockResult,
  type CancelResult,
  type EndResult,
  type KeyChange,
  type KeysResult,
  type KeyTimes,
  type KeyUse,
  type NewCommand,
  type PageState,
  type ScriptChange,
  type RobotStore,
  type StoredRobot,
  type TermedRecord,
} from "../port.ts";
import { blockedScriptsIn, setBlockedScripts } from "./sqlite-blocked-scripts.ts";
import { SqliteFile } from "./file/sqlite-file.ts";
import { addKeys, keysIn, keyTimesIn, noteKeyUses, removeKeys } from "./sqlite-keys.ts";
import type { Statements } from "./file/statements.ts";

const robotRow = z.object({
  id: z.string(),
  epoch: z.int(),
  page: z.string(),
  last_seq: z.int(),
  created_at: z.int(),
  last_used_at: z.int(),
  paused: z.int(),
});

export class SqliteRobotStore implements RobotStore {
  readonly #file: SqliteFile;
  readonly #live: LiveRobots;

  /**
   * @param file a file or its path; closing the store closes the file
   * @param journal length in entries at which checkpoints start
   */
  constructor(file: SqliteFile | string, journal = LONG) {
    this.#file = typeof file === "string" ? new SqliteFile(file) : file;
    this.#live = new LiveRobots(this.#file.writing, (entry) => this.#file.append(entry), journal);
    this.#file.remember(this.#live);
    // A relay that was killed during a deletion leaves orphans. If this fails, the next deletion
    // retries it.
    if (this.#live.hasOrphans) this.#deleteOrphans().catch(() => undefined);
  }

  async create({
    id,
    createdAt,
    keys,
  }: Omit<StoredRobot, "epoch" | "page" | "lastUsedAt" | "blocked" | "isPaused">) {
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
    };
  }

  async changeKeys(id: string, change: KeyChange): Promise<KeysResult> {
    const work = (): KeysResult =>
      this.#of<KeysResult>(id, { outcome: "no-robot" }, ({ commands }) => {
        const before = {
          keys: keysIn(this.#writing, id),
          blocked: blockedScriptsIn(this.#writing, id),
        };
        const changed = changeKeys(commands, before, change);
        if (changed === null) return { outcome: "full" };
        const { keys, blocked, revoked, ended } = changed;
        removeKeys(this.#writing, id, revoked);
        addKeys(this.#writing, id, change.add, change.now);
        if (blocked.length < before.blocked.length) setBlockedScripts(this.#writing, id, blocked);
        return { outcome: "changed", keys, ended };
      });
    // Keys can be revoked on a full disk.
    return change.add.length === 0 ? this.#file.step(work) : this.#file.growingStep(work);
  }

  async changeBlocked(id: string, change: ScriptChange): Promise<BlockResult> {
    // Scripts can be blocked on a full disk: their number is limited.
    return this.#file.step(() =>
      this.#of<BlockResult>(id, { outcome: "no-robot" }, ({ commands }) => {
        const changed = changeBlocked(commands, blockedScriptsIn(this.#writing, id), change);
        if (changed === null) return { outcome: "full" };
        setBlockedScripts(this.#writing, id, changed.blocked);
        return { outcome: "changed", ...changed, blocked: blockedScriptsIn(this.#writing, id) };
      }),
    );
  }

  async pause(id: string, isPaused: boolean): Promise<TermedRecord[] | null> {
    const sql = "UPDATE sessions SET paused = ? WHERE id = ?";
    return this.#file.step(() =>
      this.#of<TermedRecord[] | null>(id, null, ({ commands }) => {
        this.#writing.run(sql, [isPaused ? 1 : 0, id]);
        return machine.pause(commands, isPaused);
      }),
    );
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

  add(id: string, command: NewCommand): Promise<AddResult> {
    const work = (): AddResult =>
      this.#of<AddResult>(id, { outcome: "no-robot" }, (robot) =>
        machine.add(robot.commands, command, (driver, key) => robot.withKey(driver, key)),
      );
    // Robots can be stopped on a full disk.
    return command.command.action === "stop"
      ? this.#file.step(work, "memory")
      : this.#file.growingStep(work, "memory");
  }

  deliver(id: string, epoch: number, window: number, now: number): Promise<TermedRecord[]> {
    return this.#decide<TermedRecord[]>(id, [], ({ commands }) =>
      machine.deliver(commands, { epoch, window, now }),
    );
  }

  hasAll(id: string, window: number): boolean {
    return this.#file.isPrompt && this.#live.peek(id)?.commands.hasAll(window) === true;
  }

  expire(
    id: string,
    now: number,
    isAbsent?: boolean,
  ): Promise<{ ended: TermedRecord[]; next: number | null }> {
    return this.#decide(id, { ended: [], next: null }, ({ commands }) =>
      machine.expire(commands, now, isAbsent),
    );
  }

  cancel(id: string, seq: number, driver: string) {
    return this.#decide<CancelResult>(id, { outcome: "no-command" }, (robot) =>
      machine.cancel(robot.commands, robot.row(seq), driver),
    );
  }

  start(id: string, epoch: number, seq: number): Promise<CommandRecord | null> {
    return this.#decide(id, null, ({ commands }) => machine.start(commands, epoch, seq));
  }

  end(id: string, epoch: number, ending: Ending): Promise<EndResult> {
    return this.#decide<EndResult>(id, { outcome: "over", record: null }, (robot) =>
      machine.end(robot.commands, epoch, ending, (seq) => robot.row(seq)),
    );
  }

  async abandon(id: string, epoch: number): Promise<CommandRecord[]> {
    return this.#file.step(() =>
      this.#of<CommandRecord[]>(id, [], ({ commands }) => {
        const ended = machine.abandon(commands, epoch);
        const { epoch: now } = commands.accessState;
        if (now > epoch) this.#writing.run("UPDATE sessions SET epoch = ? WHERE id = ?", [now, id]);
        return ended;
      }),
    );
  }

  async acquire(id: string, page: PageState) {
    return this.#file.step(() =>
      this.#of<Awaited<ReturnType<RobotStore["acquire"]>>>(id, null, (robot) => {
        const taken = machine.acquire(robot.commands, page, {
          row: (seq) => robot.row(seq),
          newest: (what, after) => robot.newestOvertaking(what, after),
        });
        this.#writing.run(
          "UPDATE sessions SET epoch = ?, page = ?, last_seq = max(last_seq, ?) WHERE id = ?",
          [taken.epoch, page.page ?? "", page.lastApplied, id],
        );
        return taken;
      }),
    );
  }

  // Memory may be ahead of the disk. Reads of commands are steps too, so that they return only
  // stored changes.

  command(id: string, seq: number): Promise<CommandRecord | null> {
    return this.#decide(id, null, (robot) => {
      const row = robot.row(seq);
      return row && recordOfRow(row);
    });
  }

  commandsAfter(id: string, seq: number, limit: number): Promise<CommandRecord[]> {
    return this.#decide<CommandRecord[]>(id, [], (robot) => robot.recordsAfter(seq, limit));
  }

  openCommands(id: string): Promise<CommandRecord[]> {
    return this.#decide(id, [], ({ commands }) => [...commands.open].map(recordOfRow));
  }

  recalled(id: string): Promise<{ seq: number; cause: RecallCause }[]> {
    return this.#decide<{ seq: number; cause: RecallCause }[]>(id, [], ({ commands }) =>
      machine.recalled(commands.open),
    );
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

  /** Runs a step that changes no rows. */
  #decide<T>(id: string, none: T, work: (robot: LiveRobot) => T): Promise<T> {
    return this.#file.step(() => this.#of(id, none, work), "memory");
  }

  /** Runs the work of a step on a robot. @param none result if there is no such robot */
  #of<T>(id: string, none: T, work: (robot: LiveRobot) => T): T {
    const robot = this.#live.open(id);
    if (robot === null) return none;
    const result = work(robot);
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
