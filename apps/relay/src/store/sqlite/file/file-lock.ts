/**
 * Exclusive lock on a database. A relay holds the state of its robots in memory, and a second relay
 * would overwrite it. The lock is SQLite's own lock on an empty file beside the database. The
 * operating system releases it when the process ends, even after a crash.
 */
import { DatabaseSync } from "node:sqlite";
import { preparePrivateFile } from "./database-file.ts";

const SQLITE_BUSY = 5;
/** A relay that shuts down holds the lock until its last connection is closed. */
const WAIT_MS = 10_000;

export class FileLock {
  readonly #db: DatabaseSync;

  /**
   * @param waitMs time to wait for another relay to end; blocks this process
   * @throws Error with a solution if another relay holds the lock
   */
  constructor(path: string, waitMs = WAIT_MS) {
    preparePrivateFile(`${path}-lock`);
    this.#db = new DatabaseSync(`${path}-lock`, { timeout: waitMs });
    try {
      this.#db.exec("PRAGMA journal_mode = MEMORY; BEGIN EXCLUSIVE");
    } catch (error) {
      this.#db.close();
      if (!(error instanceof Error && "errcode" in error && error.errcode === SQLITE_BUSY))
        throw error;
      throw new Error(
        "Another Corridor uses this database. Stop it, set DATA_DIR to another folder, or set STORE_URL to a " +
          "Redis that several relays share.",
        { cause: error },
      );
    }
  }

  free(): void {
    this.#db.close();
  }
}
