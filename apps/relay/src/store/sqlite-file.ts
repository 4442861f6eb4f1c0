/**
 * One SQLite file that several stores share: how it is read, how it is written, and what happens when
 * its disk is full.
 *
 * Reads have a connection of their own, so that nobody is told of a step that is not on disk yet. On a
 * full disk the ballast is given up: what ends or deletes something still works, what is new is refused
 * until there is as much room again.
 */
import { mkdirSync } from "node:fs";
import { dirname } from "node:path";
import type { DatabaseSync } from "node:sqlite";
import { BallastFile, type Ballast } from "./ballast.ts";
import { isDiskFull, StoreFull, takeRoom } from "./disk-full.ts";
import { FileLock } from "./file-lock.ts";
import { GroupCommit } from "./group-commit.ts";
import { openDatabase, openForReading } from "./sqlite-schema.ts";
import { Statements } from "./statements.ts";

/** While the disk is full, it is looked at for room no more often. */
const LOOK_MS = 1_000;

/**
 * Opens a database; where the disk is too full for what a newer schema needs, once more with the ballast's room.
 * @throws Error that says how much room to make
 */
export function withRoom<T>(open: () => T, ballast: Ballast): T {
  try {
    return open();
  } catch (error) {
    if (!isDiskFull(error)) throw error;
    ballast.giveUp();
  }
  try {
    return open();
  } catch (error) {
    if (!isDiskFull(error)) throw error;
    throw new Error(
      "The disk is full. A newer Corridor writes its database anew when it starts for the first time: " +
        "make twice the room of the file in DATA_DIR, then start again. Nothing was changed.",
      { cause: error },
    );
  }
}

export class SqliteFile {
  readonly #lock: FileLock;
  readonly #db: DatabaseSync;
  readonly #readOnly: DatabaseSync;
  readonly #commits: GroupCommit;
  readonly #ballast: Ballast;
  /** for steps */
  readonly writing: Statements;
  /** for what only reads: sees what is on disk */
  readonly reading: Statements;
  readonly #undone: (() => void)[] = [];
  #isFull: boolean;
  #lookedAt = -Infinity;

  /**
   * @param path of the database, made with its folder when it is missing
   * @param ballast default: a file beside the database
   * @param waitMs for another relay that has it to end
   * @throws Error when another relay has it, or a newer one wrote it
   */
  constructor(
    path: string,
    ballast: Ballast = new BallastFile(`${path}-ballast`),
    waitMs?: number,
  ) {
    mkdirSync(dirname(path), { recursive: true });
    this.#lock = new FileLock(path, waitMs);
    try {
      this.#db = withRoom(() => openDatabase(path), ballast);
      this.#readOnly = openForReading(path);
    } catch (error) {
      this.#lock.free();
      throw error;
    }
    this.#commits = new GroupCommit(this.#db, () => {
      for (const tell of this.#undone) tell();
    });
    this.writing = new Statements(this.#db);
    this.reading = new Statements(this.#readOnly);
    this.#ballast = ballast;
    this.#isFull = !ballast.hold();
  }

  /** @param tell is called when steps are undone: what they left in memory does not hold */
  whenUndone(tell: () => void): void {
    this.#undone.push(tell);
  }

  /** One atomic step that ends, moves or deletes something. It may use the ballast's room. */
  async step<T>(work: () => T): Promise<T> {
    try {
      return await this.#commits.run(work);
    } catch (error) {
      if (!isDiskFull(error)) throw error;
      // Once, whoever of its group was first to give the ballast up: the room is there for all of them.
      this.#noteFull(error);
      return this.#commits.run(work);
    }
  }

  /**
   * One atomic step that adds something.
   * @throws StoreFull, or the error of SQLite, when the disk is full
   */
  async growingStep<T>(work: () => T): Promise<T> {
    if (this.#isFull && !this.#findRoom()) throw new StoreFull();
    try {
      return await this.#commits.run(work);
    } catch (error) {
      this.#noteFull(error);
      throw error;
    }
  }

  /**
   * A step that deletes. Deleted rows are overwritten in the pages; after this their copies are gone
   * from the log as well.
   * @param work returns how much was deleted
   */
  async forget<T>(work: () => T, hasDeleted: (result: T) => boolean): Promise<T> {
    const result = await this.step(work);
    if (hasDeleted(result)) this.#emptyLog();
    return result;
  }

  /** The file itself may have to grow for what is in the log: on a full disk by the ballast's room. */
  #emptyLog(): void {
    const empty = (): void =>
      this.#commits.alone(() => this.#db.exec("PRAGMA wal_checkpoint(TRUNCATE)"));
    try {
      empty();
    } catch (error) {
      if (!isDiskFull(error)) throw error;
      this.#noteFull(error);
      empty();
    }
  }

  /** Whether it can be written, found out by writing. @throws the error of SQLite when it does not answer */
  check(): "ok" | "full" {
    try {
      if (this.#isFull) return this.#findRoom(0) ? "ok" : "full";
      this.#commits.alone(() => takeRoom(this.#db));
      return "ok";
    } catch (error) {
      if (!isDiskFull(error)) throw error;
      this.#noteFull(error);
      return "full";
    }
  }

  close(): void {
    if (!this.#db.isOpen) return;
    this.#commits.flush();
    this.#readOnly.close();
    this.#db.close();
    this.#lock.free();
  }

  #noteFull(error: unknown): void {
    if (!isDiskFull(error)) return;
    this.#isFull = true;
    this.#ballast.giveUp();
  }

  #findRoom(everyMs = LOOK_MS): boolean {
    const now = performance.now();
    if (now - this.#lookedAt < everyMs) return false;
    this.#lookedAt = now;
    if (!this.#ballast.hold()) return false;
    try {
      this.#commits.alone(() => takeRoom(this.#db));
    } catch (error) {
      if (!isDiskFull(error)) throw error;
      this.#ballast.giveUp();
      return false;
    }
    this.#isFull = false;
    return true;
  }
}
