/**
 * Tables of the SQLite stores, and the pragmas that their guarantees need. The table of robots is
 * named `sessions`, as in the first version of the schema.
 */
import { DatabaseSync } from "node:sqlite";

const SESSIONS = `
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
  WHERE state IN ('accepted', 'delivered', 'started');
`;

const DOCUMENTS = `
CREATE TABLE documents (
  id TEXT PRIMARY KEY,
  hash TEXT NOT NULL UNIQUE,
  text TEXT NOT NULL,
  last_used_at INTEGER NOT NULL
) STRICT;
CREATE INDEX documents_by_use ON documents (last_used_at);
CREATE TABLE document_keys (
  document TEXT NOT NULL REFERENCES documents (id) ON DELETE CASCADE,
  hash TEXT NOT NULL,
  PRIMARY KEY (document, hash)
) STRICT, WITHOUT ROWID;
`;

// Commands from before deadlines get the current default ttl.
const TERMS = `
ALTER TABLE commands ADD COLUMN ttl INTEGER NOT NULL DEFAULT 10000;
ALTER TABLE commands ADD COLUMN deadline INTEGER NOT NULL DEFAULT 0;
ALTER TABLE commands ADD COLUMN replaces INTEGER NOT NULL DEFAULT 0;
ALTER TABLE commands ADD COLUMN lease INTEGER;
UPDATE commands SET deadline = accepted_at + ttl;
`;

// Why a command that the robot has was cancelled.
const RECALLED = `
ALTER TABLE commands ADD COLUMN recalled TEXT;
`;

const SCRIPTS = `
ALTER TABLE commands ADD COLUMN script TEXT;
CREATE TABLE away (
  robot TEXT NOT NULL REFERENCES sessions (id) ON DELETE CASCADE,
  id TEXT NOT NULL,
  driver TEXT NOT NULL,
  name TEXT,
  client TEXT NOT NULL,
  PRIMARY KEY (robot, id)
) STRICT, WITHOUT ROWID;
`;

const PAUSE = `
ALTER TABLE sessions ADD COLUMN paused INTEGER NOT NULL DEFAULT 0;
`;

const MAZES = `
CREATE TABLE mazes (
  robot TEXT PRIMARY KEY REFERENCES sessions (id) ON DELETE CASCADE,
  text TEXT NOT NULL
) STRICT;
`;

const PAIRINGS = `
CREATE TABLE pairings (
  robot TEXT PRIMARY KEY REFERENCES sessions (id) ON DELETE CASCADE,
  code TEXT NOT NULL UNIQUE,
  ends_at INTEGER NOT NULL,
  state TEXT NOT NULL,
  key TEXT UNIQUE,
  name TEXT,
  client TEXT
) STRICT, WITHOUT ROWID;
CREATE INDEX pairings_by_end ON pairings (ends_at);
`;

// The id by which a page identifies itself when it returns.
const PAGE_NAME = `
ALTER TABLE sessions ADD COLUMN page TEXT NOT NULL DEFAULT '';
`;

// The creation time of older keys is unknown. They get that of their robot.
const KEY_TIMES = `
ALTER TABLE keys ADD COLUMN made_at INTEGER NOT NULL DEFAULT 0;
ALTER TABLE keys ADD COLUMN last_used_at INTEGER;
UPDATE keys SET made_at = (SELECT created_at FROM sessions WHERE id = robot);
`;

// Rows in order of time: rows that change together are adjacent, whatever their robot, so a commit
// writes few pages. `is_open` exists for its index. An index on the state would be written on each
// change of state. A list of states would create a temporary table for each query.
const COMMANDS_BY_TIME = `
ALTER TABLE commands RENAME TO commands_before;
DROP INDEX commands_by_key;
DROP INDEX commands_open;
CREATE TABLE commands (
  n INTEGER PRIMARY KEY,
  robot TEXT NOT NULL REFERENCES sessions (id) ON DELETE CASCADE,
  seq INTEGER NOT NULL,
  driver TEXT NOT NULL,
  script TEXT,
  key TEXT,
  command TEXT NOT NULL,
  state TEXT NOT NULL,
  is_open INTEGER NOT NULL
    CHECK (is_open = (state = 'accepted' OR state = 'delivered' OR state = 'started')),
  reason TEXT,
  recalled TEXT,
  accepted_at INTEGER NOT NULL,
  ttl INTEGER NOT NULL,
  deadline INTEGER NOT NULL,
  replaces INTEGER NOT NULL,
  lease INTEGER,
  pose TEXT,
  distance REAL,
  epoch INTEGER
) STRICT;
INSERT INTO commands
    (robot, seq, driver, script, key, command, state, is_open, reason, recalled,
     accepted_at, ttl, deadline, replaces, lease, pose, distance, epoch)
  SELECT robot, seq, driver, script, key, command, state,
     state IN ('accepted', 'delivered', 'started'), reason, recalled,
     accepted_at, ttl, deadline, replaces, lease, pose, distance, epoch
  FROM commands_before ORDER BY accepted_at, robot, seq;
DROP TABLE commands_before;
CREATE UNIQUE INDEX commands_by_seq ON commands (robot, seq);
CREATE UNIQUE INDEX commands_by_key ON commands (robot, driver, key) WHERE key IS NOT NULL;
CREATE INDEX commands_open ON commands (robot, seq) WHERE is_open = 1;
`;

// Changes of commands since the last checkpoint. `settled`: the entry up to which the tables hold a
// robot's rows.
const JOURNAL = `
CREATE TABLE journal (
  id INTEGER PRIMARY KEY,
  robot TEXT NOT NULL,
  entry TEXT NOT NULL
) STRICT;
ALTER TABLE sessions ADD COLUMN settled INTEGER NOT NULL DEFAULT 0;
`;

// A row is its journal entry, so that a checkpoint moves it without parsing. Queries use indexes on
// columns that are generated from the entry. There is no index of open commands, which each command
// would be added to and deleted from. Instead, every command of a robot in the tables before
// `open_from` has ended. Unknown states count as open, so that they are read and not deleted.
const COMMANDS_AS_ENTRIES = `
ALTER TABLE sessions ADD COLUMN open_from INTEGER NOT NULL DEFAULT 0;
UPDATE sessions SET open_from = coalesce(
  (SELECT min(seq) FROM commands INDEXED BY commands_open WHERE robot = id AND is_open = 1), last_seq + 1);
ALTER TABLE commands RENAME TO commands_before;
DROP INDEX commands_by_seq;
DROP INDEX commands_by_key;
DROP INDEX commands_open;
CREATE TABLE commands (
  n INTEGER PRIMARY KEY,
  robot TEXT NOT NULL REFERENCES sessions (id) ON DELETE CASCADE,
  entry TEXT NOT NULL,
  seq INTEGER NOT NULL AS (entry ->> 0),
  driver TEXT NOT NULL AS (entry ->> 1),
  key TEXT AS (entry ->> 3),
  command TEXT NOT NULL AS (entry ->> 4),
  replaces INTEGER NOT NULL AS (entry ->> 8),
  is_open INTEGER NOT NULL AS
    (entry ->> 10 NOT IN ('completed', 'collided', 'cancelled', 'superseded', 'expired'))
) STRICT;
INSERT INTO commands (robot, entry)
  SELECT robot, json_array(seq, driver, script, key, command, accepted_at, ttl, deadline, replaces, lease,
    state, reason, recalled, pose, distance, epoch, 0)
  FROM commands_before ORDER BY n;
DROP TABLE commands_before;
CREATE UNIQUE INDEX commands_by_seq ON commands (robot, seq);
CREATE UNIQUE INDEX commands_by_key ON commands (robot, driver, key) WHERE key IS NOT NULL;
`;

// FULL: an acknowledged command survives a power failure. secure_delete: deleted data is erased
// from the file.
const PROMISES = `
  PRAGMA journal_mode = WAL;
  PRAGMA synchronous = FULL;
  PRAGMA foreign_keys = ON;
  PRAGMA secure_delete = ON;
  PRAGMA busy_timeout = 2000;
`;

// Documents from before short codes keep their ids. Storing the same text again creates a code.
const SHORT_CODES = `
UPDATE documents SET hash = 'before:' || hash;
`;

const BLOCKED_SCRIPTS = `
ALTER TABLE away RENAME TO blocked_scripts;
`;

// An entry contains what the rules say of its command: how it overtakes, and whether it is open.
// Queries use these values, so that no rule is repeated here. Older entries get them from the rules
// of their time. Damaged ones stay, because the check of the texts follows.
const RULES_IN_ENTRIES = `
UPDATE commands SET entry = json_insert(entry, '$[16]', 0,
  '$[17]', CASE WHEN command = '{"action":"stop"}' THEN 'stop' WHEN replaces = 1 THEN 'replace' END,
  '$[18]', is_open);
UPDATE journal SET entry = json_insert(entry, '$[16]', 0,
  '$[17]', CASE WHEN entry ->> 4 = '{"action":"stop"}' THEN 'stop' WHEN entry ->> 8 = 1 THEN 'replace' END,
  '$[18]', entry ->> 10 NOT IN ('completed', 'collided', 'cancelled', 'superseded', 'expired'))
  WHERE json_valid(entry);
ALTER TABLE commands DROP COLUMN command;
ALTER TABLE commands DROP COLUMN replaces;
ALTER TABLE commands DROP COLUMN is_open;
ALTER TABLE commands ADD COLUMN overtakes TEXT AS (entry ->> 17);
ALTER TABLE commands ADD COLUMN is_open INTEGER NOT NULL AS (entry ->> 18);
`;

// Classes. Rows and records are JSON, which the store does not interpret.
const CLASSES = `
CREATE TABLE classes (
  id TEXT PRIMARY KEY,
  version INTEGER NOT NULL,
  row TEXT NOT NULL,
  lesson TEXT NOT NULL,
  created_at INTEGER NOT NULL,
  last_used_at INTEGER NOT NULL
) STRICT, WITHOUT ROWID;
CREATE INDEX classes_by_use ON classes (last_used_at);
CREATE TABLE class_codes (
  hash TEXT PRIMARY KEY,
  class TEXT NOT NULL REFERENCES classes (id) ON DELETE CASCADE,
  student INTEGER,
  ends_at INTEGER
) STRICT, WITHOUT ROWID;
CREATE INDEX class_codes_by_class ON class_codes (class);
CREATE TABLE students (
  class TEXT NOT NULL REFERENCES classes (id) ON DELETE CASCADE,
  student INTEGER NOT NULL,
  row TEXT NOT NULL,
  program TEXT,
  PRIMARY KEY (class, student)
) STRICT, WITHOUT ROWID;
CREATE TABLE progress (
  class TEXT NOT NULL,
  student INTEGER NOT NULL,
  seq INTEGER NOT NULL,
  text TEXT NOT NULL,
  PRIMARY KEY (class, student, seq),
  FOREIGN KEY (class, student) REFERENCES students (class, student) ON DELETE CASCADE
) STRICT, WITHOUT ROWID;
`;

const KEY_USE = `
ALTER TABLE keys ADD COLUMN use TEXT;
`;

// Whether scripts may reset the robot.
const SCRIPT_RESET = `
ALTER TABLE sessions ADD COLUMN may_reset INTEGER NOT NULL DEFAULT 1;
`;

/** The migration for each version. The first one creates version 1 from an empty file. */
const STEPS: readonly string[] = [
  SESSIONS,
  DOCUMENTS,
  TERMS,
  RECALLED,
  SCRIPTS,
  PAUSE,
  MAZES,
  PAIRINGS,
  PAGE_NAME,
  KEY_TIMES,
  COMMANDS_BY_TIME,
  JOURNAL,
  COMMANDS_AS_ENTRIES,
  SHORT_CODES,
  BLOCKED_SCRIPTS,
  RULES_IN_ENTRIES,
  CLASSES,
  KEY_USE,
  SCRIPT_RESET,
];

/**
 * Opens a database and creates it if it is missing.
 * @param newest schema version to migrate to; tests use earlier ones
 * @throws as `prepareDatabase` does
 */
export function openDatabase(file: string, newest = STEPS.length): DatabaseSync {
  const db = new DatabaseSync(file);
  prepareDatabase(db, newest);
  return db;
}

/** Opens a read-only connection to a prepared database. It sees committed data only. */
export function openForReading(file: string): DatabaseSync {
  return new DatabaseSync(file, { readOnly: true });
}

/**
 * Migrates an open database to the current schema.
 * @throws Error if a newer version wrote the file
 */
export function prepareDatabase(db: DatabaseSync, newest: number = STEPS.length): void {
  db.exec(PROMISES);
  const version = Number(db.prepare("PRAGMA user_version").get()?.["user_version"] ?? 0);
  if (version > newest) {
    throw new Error(
      `The database was written by a newer Corridor (schema ${version}, this version supports ${newest}). ` +
        "Update Corridor, or set DATA_DIR to another folder.",
    );
  }
  if (version === newest) return;
  const steps = STEPS.slice(version, newest).join("");
  db.exec(`BEGIN IMMEDIATE; ${steps} PRAGMA user_version = ${newest}; COMMIT;`);
}
