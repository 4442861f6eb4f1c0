/** How the SQLite stores write: all of a change or nothing of it, and what is deleted is gone from the files. */
import type { DatabaseSync } from "node:sqlite";

/** @throws what the work throws; nothing of it is kept then */
export function inTransaction<T>(db: DatabaseSync, work: () => T): T {
  db.exec("BEGIN IMMEDIATE");
  try {
    const result = work();
    db.exec("COMMIT");
    return result;
  } catch (error) {
    // A full disk may have rolled back already; then there is nothing left to undo.
    if (db.isTransaction) db.exec("ROLLBACK");
    throw error;
  }
}

/** Deleted rows were overwritten in the pages; this takes their copies out of the log as well. */
export function forgetDeleted(db: DatabaseSync): void {
  db.exec("PRAGMA wal_checkpoint(TRUNCATE)");
}
