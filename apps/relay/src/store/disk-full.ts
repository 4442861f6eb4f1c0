/** A disk without room, as SQLite tells it, and how to find out whether it has some again. */
import type { DatabaseSync } from "node:sqlite";

const SQLITE_FULL = 13;

export function isDiskFull(error: unknown): boolean {
  return error instanceof Error && "errcode" in error && error.errcode === SQLITE_FULL;
}

/**
 * Takes some room in the file and gives it back, for good each time: what is only begun and undone
 * never gets as far as the disk.
 * @throws the error of SQLite when there is no room
 */
export function takeRoom(db: DatabaseSync): void {
  db.exec(
    "CREATE TABLE room (bytes BLOB); INSERT INTO room VALUES (zeroblob(16384)); DROP TABLE room",
  );
}
