/** Detects a store without free space, and whether SQLite has free space again. */
import type { DatabaseSync } from "node:sqlite";

const SQLITE_FULL = 13;

/** The store accepts no new data until space is free. */
export class StoreFull extends Error {
  override readonly name = "StoreFull";
}

export function isDiskFull(error: unknown): boolean {
  if (error instanceof StoreFull) return true;
  return error instanceof Error && "errcode" in error && error.errcode === SQLITE_FULL;
}

/**
 * Allocates some space in the file and frees it again. Each call commits, because a transaction
 * that is rolled back never reaches the disk.
 * @throws the error of SQLite if there is no space
 */
export function reserveSpace(db: DatabaseSync): void {
  db.exec("BEGIN IMMEDIATE");
  try {
    db.exec(
      "CREATE TABLE room (bytes BLOB); INSERT INTO room VALUES (zeroblob(16384)); DROP TABLE room; COMMIT",
    );
  } finally {
    // SQLite may already have rolled back because the disk is full.
    if (db.isTransaction) db.exec("ROLLBACK");
  }
}
