/**
 * A database that one relay has for itself. What its robots do is in that relay's memory, and a second one would
 * write over it. SQLite's own lock on an empty file beside it tells: the system gives it free when its process
 * ends, however that came about.
 */
import { DatabaseSync } from "node:sqlite";
import { preparePrivateFile } from "./database-file.ts";

const SQLITE_BUSY = 5;
/** A relay that is on its way out has it until its last connection is closed. */
const WAIT_MS = 10_000;

export class FileLock {
  readonly #db: DatabaseSync;

  /**
   * @param waitMs for another relay to end; nothing else is done meanwhile
   * @throws Error that says what to do when another relay has the database
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
