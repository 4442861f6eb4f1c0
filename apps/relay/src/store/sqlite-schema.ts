/** Tables of the SQLite store, and the pragmas that its promises rest on. */
import type { DatabaseSync } from "node:sqlite";

const SCHEMA_VERSION = 1;

/**
 * The commands that have not ended: the table by their index, and the condition of that index. A query
 * needs both, word for word; otherwise SQLite reads through all commands that a robot ever had.
 */
export const OPEN_COMMANDS = "commands INDEXED BY commands_open";
export const IS_OPEN = "state IN ('accepted', 'delivered', 'started')";

const TABLES = `
CREATE TABLE sessions (
  id TEXT PRIMARY KEY,
  epoch INTEGER NOT NULL DEFAULT 0,
  last_seq INTEGER NOT NULL DEFAULT 0,
  created_at INTEGER NOT NULL,
  last_used_at INTEGER NOT NULL
) STRICT, WITHOUT ROWID;
CREATE INDEX sessions_by_use ON sessions (last_used_at);
CREATE TABLE keys (
  robot TEXT NOT NULL REFERENCES sessions (id) ON DELETE CASCADE,
  hash TEXT NOT NULL,
  kind TEXT NOT NULL,
  PRIMARY KEY (robot, hash)
) STRICT, WITHOUT ROWID;
CREATE TABLE commands (
  robot TEXT NOT NULL REFERENCES sessions (id) ON DELETE CASCADE,
  seq INTEGER NOT NULL,
  driver TEXT NOT NULL,
  key TEXT,
  command TEXT NOT NULL,
  state TEXT NOT NULL,
  reason TEXT,
  accepted_at INTEGER NOT NULL,
  pose TEXT,
  distance REAL,
  epoch INTEGER,
  PRIMARY KEY (robot, seq)
) STRICT, WITHOUT ROWID;
CREATE UNIQUE INDEX commands_by_key ON commands (robot, driver, key) WHERE key IS NOT NULL;
CREATE INDEX commands_open ON commands (robot, state, seq)
  WHERE ${IS_OPEN};
PRAGMA user_version = ${SCHEMA_VERSION};
`;

/**
 * Brings an open database to the schema of this version.
 * @throws Error when the file was written by a newer version
 */
export function prepareDatabase(db: DatabaseSync): void {
  // FULL: an acknowledged command survives a power cut. secure_delete: deleted means gone from the file.
  db.exec(`
    PRAGMA journal_mode = WAL;
    PRAGMA synchronous = FULL;
    PRAGMA foreign_keys = ON;
    PRAGMA secure_delete = ON;
    PRAGMA busy_timeout = 2000;
  `);
  const version = Number(db.prepare("PRAGMA user_version").get()?.["user_version"] ?? 0);
  if (version > SCHEMA_VERSION) {
    throw new Error(
      `The database was written by a newer Corridor (schema ${version}, this one knows ${SCHEMA_VERSION}). ` +
        "Update Corridor, or set DATA_DIR to another folder.",
    );
  }
  if (version === 0) db.exec(`BEGIN IMMEDIATE; ${TABLES} COMMIT;`);
}
