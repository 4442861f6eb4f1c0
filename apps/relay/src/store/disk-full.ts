/** A store without room, as databases tell it, and how to find out whether SQLite has some again. */
import type { DatabaseSync } from "node:sqlite";

const SQLITE_FULL = 13;

/** Nothing new is stored until somebody makes room. */
export class StoreFull extends Error {
  override readonly name = "StoreFull";
}

export function isDiskFull(error: unknown): boolean {
  if (error instanceof StoreFull) return true;
  return error instanceof Error && "errcode" in error && error.errcode === SQLITE_FULL;
}

/**
 * Takes some room in the file and gives it back, for good each time: what is only begun and undone
 * never gets as far as the disk.
 * @throws the error of SQLite when there is no room
 */
export function takeRoom(db: DatabaseSync): void {
  db.exec("BEGIN IMMEDIATE");
  try {
    db.exec(
      "CREATE TABLE room (bytes BLOB); INSERT INTO room VALUES (zeroblob(16384)); DROP TABLE room; COMMIT",
    );
  } finally {
    // A full disk may have rolled back already; then there is nothing left to undo.
    if (db.isTransaction) db.exec("ROLLBACK");
  }
}
