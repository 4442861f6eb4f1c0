/**
 * One SQLite file that several stores share: reads, writes and the behaviour on a full disk.
 *
 * Reads have a separate connection, so that they never return changes that are not on disk yet. A
 * full disk releases the ballast. Steps that end or delete data then still work. Steps that add
 * data are rejected until the ballast can be reserved again.
 */
import type { DatabaseSync } from "node:sqlite";
import { BallastFile, type Ballast } from "./ballast.ts";
import { openIntactDatabase, preparePrivateFile } from "./database-file.ts";
import { isDiskFull, StoreFull, reserveSpace } from "../../../platform/errors/disk-full.ts";
import { FileLock } from "./file-lock.ts";
import { GroupCommit, type Memory, type StepKind } from "./group-commit.ts";
import type { Entry } from "./journal.ts";
import { openForReading } from "./sqlite-schema.ts";
import { Statements } from "./statements.ts";

/** Minimum time between checks for free space while the disk is full. */
const LOOK_MS = 1_000;

/**
 * Opens a database. If the disk is too full for a migration, it releases the ballast and tries
 * again.
 * @throws Error that states how much space to free
 */
export function withRoom<T>(open: () => T, ballast: Ballast): T {
  try {
    return open();
  } catch (error) {
    if (!isDiskFull(error)) throw error;
    ballast.release();
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
  /** ms to wait for another relay to release the database */
  waitMs?: number;
  /** receives the new path of a damaged database; a new database replaces it */
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
  /** for reads; returns committed data only */
  readonly reading: Statements;
  #memory: Memory | null = null;
  #isFull: boolean;
  /** pending check for free space; later steps run after the step that started it */
  #spaceCheck: Promise<boolean> | null = null;
  #lookedAt = -Infinity;
  #closed: Promise<void> | null = null;

  /**
   * @param path of the database; the file and its folder are created if missing
   * @throws DatabaseFileError if the file is not accessible; Error if another relay uses it or a
   *   newer version wrote it
   */
  constructor(path: string, { ballast, waitMs, setAside }: SqliteFileParts = {}) {
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
    this.#commits = new GroupCommit(this.#db, { memory: this.#memoryWithRoom() });
    this.writing = new Statements(this.#db);
    this.reading = new Statements(this.#readOnly);
    this.#isFull = !this.#ballast.hold();
  }

  /** Sets the state in memory that belongs to the steps. */
  remember(memory: Memory): void {
    this.#memory = memory;
  }

  /** Compaction needs space, so it waits while the disk is full. */
  #memoryWithRoom(): Memory {
    const needsCompaction = (): boolean => !this.#isFull && this.#memory?.needsCompaction === true;
    return {
      rolledBack: () => this.#memory?.rolledBack(),
      due: (...how) => (this.#isFull ? null : (this.#memory?.due(...how) ?? null)),
      get needsCompaction() {
        return needsCompaction();
      },
      compacted: (compaction, failed) => {
        this.#memory?.compacted(compaction, failed);
        this.#noteFull(failed);
      },
    };
  }

  /** Whether steps wait for a check of the free space. */
  get isWaiting(): boolean {
    return this.#spaceCheck !== null;
  }

  /** Adds an entry to the journal. Must be called within a step. */
  append(entry: Entry): void {
    this.#commits.append(entry);
  }

  /**
   * Runs one atomic step that ends, moves or deletes data. It may use the space of the ballast.
   * @param kind memory: it changes no rows
   */
  step<T>(work: () => T, kind: StepKind = "rows"): Promise<T> {
    if (this.#spaceCheck !== null) return this.#stepAfter(this.#spaceCheck, work, kind);
    return this.#commits.run(work, kind).catch((error: unknown) => {
      if (!isDiskFull(error)) throw error;
      // One retry is enough: the ballast is released for every step of the group.
      this.#noteFull(error);
      return this.#commits.run(work, kind);
    });
  }

  /**
   * Runs one atomic step that adds data.
   * @param kind memory: it changes no rows
   * @throws StoreFull, or the error of SQLite, if the disk is full
   */
  growingStep<T>(work: () => T, kind: StepKind = "rows"): Promise<T> {
    const grow = (): Promise<T> =>
      this.#commits.run(work, kind).catch((error: unknown) => {
        this.#noteFull(error);
        throw error;
      });
    if (!this.#isFull) return grow();
    return this.#sharedSpaceCheck().then((hasRoom) => {
      if (hasRoom) return grow();
      throw new StoreFull();
    });
  }

  async #stepAfter<T>(finding: Promise<boolean>, work: () => T, kind: StepKind): Promise<T> {
    try {
      await finding;
    } catch {
      // The caller that started the check receives the error.
    }
    return this.step(work, kind);
  }

  /** Checks for free space. Concurrent callers share one check. */
  #sharedSpaceCheck(): Promise<boolean> {
    if (this.#spaceCheck !== null) return this.#spaceCheck;
    const finding = this.#checkSpace();
    this.#spaceCheck = finding;
    void this.#releaseAfter(finding);
    return finding;
  }

  /**
   * Called before any other caller waits for the check, so that `#spaceCheck` is null when those
   * continue.
   */
  async #releaseAfter(finding: Promise<boolean>): Promise<void> {
    try {
      await finding;
    } catch {
      // The caller that started the check receives the error.
    }
    this.#spaceCheck = null;
  }

  /**
   * Runs a step that deletes data. SQLite overwrites deleted rows in the pages. This also removes
   * their copies from the write-ahead log.
   * @param hasDeleted whether the result of `work` shows a deletion
   */
  async remove<T>(work: () => T, hasDeleted: (result: T) => boolean): Promise<T> {
    const result = await this.step(work);
    if (hasDeleted(result)) await this.#emptyLog();
    return result;
  }

  /** A WAL checkpoint may enlarge the file. On a full disk it uses the space of the ballast. */
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

  /**
   * Checks whether the file is writable, by writing.
   * @throws the error of SQLite if it does not respond
   */
  async check(): Promise<"ok" | "full"> {
    try {
      if (this.#isFull) return (await this.#checkSpace(0)) ? "ok" : "full";
      await this.#commits.alone(() => reserveSpace(this.#db));
      return "ok";
    } catch (error) {
      if (!isDiskFull(error)) throw error;
      this.#noteFull(error);
      return "full";
    }
  }

  /** Waits for all steps. Every call resolves once the file is closed. */
  close(): Promise<void> {
    this.#closed ??= this.#close();
    return this.#closed;
  }

  async #close(): Promise<void> {
    try {
      this.#commits.close();
    } finally {
      this.#readOnly.close();
      this.#db.close();
      this.#lock.free();
    }
  }

  #noteFull(error: unknown): void {
    if (!isDiskFull(error)) return;
    this.#isFull = true;
    this.#ballast.release();
  }

  async #checkSpace(everyMs = LOOK_MS): Promise<boolean> {
    const now = performance.now();
    if (now - this.#lookedAt < everyMs) return false;
    this.#lookedAt = now;
    if (!this.#ballast.hold()) return false;
    try {
      await this.#commits.alone(() => reserveSpace(this.#db));
    } catch (error) {
      if (!isDiskFull(error)) throw error;
      this.#ballast.release();
      return false;
    }
    this.#isFull = false;
    return true;
  }
}
