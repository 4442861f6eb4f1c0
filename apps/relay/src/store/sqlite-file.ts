/**
 * One SQLite file that several stores share: how it is read, how it is written, and what happens when
 * its disk is full.
 *
 * Reads have a connection of their own, so that nobody is told of a step that is not on disk yet. On a
 * full disk the ballast is given up: what ends or deletes something still works, what is new is refused
 * until there is as much room again.
 */
import type { DatabaseSync } from "node:sqlite";
import { BallastFile, type Ballast } from "./ballast.ts";
import { openIntactDatabase, preparePrivateFile } from "./database-file.ts";
import { isDiskFull, StoreFull, takeRoom } from "./disk-full.ts";
import { FileLock } from "./file-lock.ts";
import { GroupCommit, type Memory } from "./group-commit.ts";
import { InlineJournal } from "./journal.ts";
import type { Entry } from "./journal-writer.ts";
import { openForReading } from "./sqlite-schema.ts";
import { AdaptiveJournal } from "./adaptive-journal.ts";
import { Statements } from "./statements.ts";
import { ThreadedJournal } from "./threaded-journal.ts";

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
      "The disk is full, so the database could not be migrated to this version. Nothing was changed. " +
        "Free twice the size of the database in DATA_DIR, then start again.",
      { cause: error },
    );
  }
}

export interface SqliteFileParts {
  /** default: a file beside the database */
  ballast?: Ballast;
  /** ms for another relay that has it to end */
  waitMs?: number;
  /** much of the journal is written on a thread of its own */
  isThreaded?: boolean;
  /** receives where a damaged database was moved to; a new one is open then */
  setAside?: (to: string) => void;
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
  #memory: Memory | null = null;
  #isFull: boolean;
  /** whether there is room again: what is asked for meanwhile comes after the step that asked for that */
  #finding: Promise<boolean> | null = null;
  #lookedAt = -Infinity;
  #closed: Promise<void> | null = null;

  /**
   * @param path of the database, made with its folder when it is missing
   * @throws DatabaseFileError when it cannot be read or written; Error when another relay has it, or a newer one
   *   wrote it
   */
  constructor(
    path: string,
    { ballast, waitMs, isThreaded = false, setAside }: SqliteFileParts = {},
  ) {
    preparePrivateFile(path);
    this.#ballast = ballast ?? new BallastFile(`${path}-ballast`);
    this.#lock = new FileLock(path, waitMs);
    try {
      this.#db = withRoom(
        () => openIntactDatabase(path, setAside ?? (() => undefined)),
        this.#ballast,
      );
      this.#readOnly = openForReading(path);
    } catch (error) {
      this.#lock.free();
      throw error;
    }
    const own = new InlineJournal(this.#db);
    this.#commits = new GroupCommit(this.#db, {
      journal: isThreaded ? new AdaptiveJournal(own, new ThreadedJournal(path)) : own,
      memory: this.#memoryWithRoom(),
    });
    this.writing = new Statements(this.#db);
    this.reading = new Statements(this.#readOnly);
    this.#isFull = !this.#ballast.hold();
  }

  /** What its steps have in memory. */
  remember(memory: Memory): void {
    this.#memory = memory;
  }

  /** What needs room waits while there is none. */
  #memoryWithRoom(): Memory {
    const isUntidy = (): boolean => !this.#isFull && this.#memory?.isUntidy === true;
    return {
      undone: () => this.#memory?.undone(),
      due: (...how) => (this.#isFull ? null : (this.#memory?.due(...how) ?? null)),
      get isUntidy() {
        return isUntidy();
      },
      tidied: (tidying, failed) => {
        this.#memory?.tidied(tidying, failed);
        this.#noteFull(failed);
      },
    };
  }

  /** Whether what is in memory is what the next step in memory would find. */
  get isPrompt(): boolean {
    return this.#finding === null && this.#commits.isPrompt;
  }

  /** Adds an entry to the journal, in a step. */
  append(entry: Entry): void {
    this.#commits.append(entry);
  }

  /**
   * One atomic step that ends, moves or deletes something. It may use the ballast's room.
   * @param kind memory: it changes no rows
   */
  step<T>(work: () => T, kind: "rows" | "memory" = "rows"): Promise<T> {
    if (this.#finding !== null) return this.#stepAfter(this.#finding, work, kind);
    return this.#commits.run(work, kind).catch((error: unknown) => {
      if (!isDiskFull(error)) throw error;
      // Once, whoever of its group was first to give the ballast up: the room is there for all of them.
      this.#noteFull(error);
      return this.#commits.run(work, kind);
    });
  }

  /**
   * One atomic step that adds something.
   * @param kind memory: it changes no rows
   * @throws StoreFull, or the error of SQLite, when the disk is full
   */
  growingStep<T>(work: () => T, kind: "rows" | "memory" = "rows"): Promise<T> {
    const grow = (): Promise<T> =>
      this.#commits.run(work, kind).catch((error: unknown) => {
        this.#noteFull(error);
        throw error;
      });
    if (!this.#isFull) return grow();
    return this.#findRoomFirst().then((hasRoom) => {
      if (hasRoom) return grow();
      throw new StoreFull();
    });
  }

  async #stepAfter<T>(
    finding: Promise<boolean>,
    work: () => T,
    kind: "rows" | "memory",
  ): Promise<T> {
    try {
      await finding;
    } catch {
      // Whoever asked for room is told.
    }
    return this.step(work, kind);
  }

  /** Finds room, with those behind it that are asked for meanwhile. */
  #findRoomFirst(): Promise<boolean> {
    if (this.#finding !== null) return this.#finding;
    const finding = this.#findRoom();
    this.#finding = finding;
    void this.#letGo(finding);
    return finding;
  }

  /** To be the first that waits for it, so that those after it find it over. */
  async #letGo(finding: Promise<boolean>): Promise<void> {
    try {
      await finding;
    } catch {
      // Whoever asked for room is told.
    }
    this.#finding = null;
  }

  /**
   * A step that deletes. Deleted rows are overwritten in the pages; after this their copies are gone
   * from the log as well.
   * @param work returns how much was deleted
   */
  async forget<T>(work: () => T, hasDeleted: (result: T) => boolean): Promise<T> {
    const result = await this.step(work);
    if (hasDeleted(result)) await this.#emptyLog();
    return result;
  }

  /** The file itself may have to grow for what is in the log: on a full disk by the ballast's room. */
  async #emptyLog(): Promise<void> {
    const empty = (): Promise<void> =>
      this.#commits.alone(() => this.#db.exec("PRAGMA wal_checkpoint(TRUNCATE)"));
    try {
      await empty();
    } catch (error) {
      if (!isDiskFull(error)) throw error;
      this.#noteFull(error);
      await empty();
    }
  }

  /** Whether it can be written, found out by writing. @throws the error of SQLite when it does not answer */
  async check(): Promise<"ok" | "full"> {
    try {
      if (this.#isFull) return (await this.#findRoom(0)) ? "ok" : "full";
      await this.#commits.alone(() => takeRoom(this.#db));
      return "ok";
    } catch (error) {
      if (!isDiskFull(error)) throw error;
      this.#noteFull(error);
      return "full";
    }
  }

  /** Waits for all that was asked for, and is closed by then for whoever waits for it. */
  close(): Promise<void> {
    this.#closed ??= this.#close();
    return this.#closed;
  }

  async #close(): Promise<void> {
    try {
      await this.#commits.close();
    } finally {
      this.#readOnly.close();
      this.#db.close();
      this.#lock.free();
    }
  }

  #noteFull(error: unknown): void {
    if (!isDiskFull(error)) return;
    this.#isFull = true;
    this.#ballast.giveUp();
  }

  async #findRoom(everyMs = LOOK_MS): Promise<boolean> {
    const now = performance.now();
    if (now - this.#lookedAt < everyMs) return false;
    this.#lookedAt = now;
    if (!this.#ballast.hold()) return false;
    try {
      await this.#commits.alone(() => takeRoom(this.#db));
    } catch (error) {
      if (!isDiskFull(error)) throw error;
      this.#ballast.giveUp();
      return false;
    }
    this.#isFull = false;
    return true;
  }
}
