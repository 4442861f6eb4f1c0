/** Tables of the SQLite stores, and the pragmas that their promises rest on. */
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

// A command from before there were deadlines gets what one without a wish gets now.
const TERMS = `
ALTER TABLE commands ADD COLUMN ttl INTEGER NOT NULL DEFAULT 10000;
ALTER TABLE commands ADD COLUMN deadline INTEGER NOT NULL DEFAULT 0;
ALTER TABLE commands ADD COLUMN replaces INTEGER NOT NULL DEFAULT 0;
ALTER TABLE commands ADD COLUMN lease INTEGER;
UPDATE commands SET deadline = accepted_at + ttl;
`;

// Why a command was taken back that the robot has.
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

// By which a page is known when it comes back.
const PAGE_NAME = `
ALTER TABLE sessions ADD COLUMN page TEXT NOT NULL DEFAULT '';
`;

// A key from before there were times is as old as its robot, for all that is known.
const KEY_TIMES = `
ALTER TABLE keys ADD COLUMN made_at INTEGER NOT NULL DEFAULT 0;
ALTER TABLE keys ADD COLUMN last_used_at INTEGER;
UPDATE keys SET made_at = (SELECT created_at FROM sessions WHERE id = robot);
`;

// Rows in the order of time: what changes together, of whatever robots, stands together, and a commit
// writes few pages. `is_open` is there for its index, which a change of state would write as well otherwise,
// and which would make a table of its own for the list of states, each time.
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

// What became of commands since their rows were brought into the tables; `settled`: up to which entry those are.
const JOURNAL = `
CREATE TABLE journal (
  id INTEGER PRIMARY KEY,
  robot TEXT NOT NULL,
  entry TEXT NOT NULL
) STRICT;
ALTER TABLE sessions ADD COLUMN settled INTEGER NOT NULL DEFAULT 0;
`;

// A row is its entry, as the journal had it: it is moved, and nobody takes it apart and puts it together again.
// What is asked for stands in the indexes, read from the entry. No index of what has not ended, which each command
// would be written to and deleted from: `open_from` says before which number a robot's have ended, in the tables. A state that nobody knows is open: it is read, not deleted.
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

// FULL: an acknowledged command survives a power cut. secure_delete: deleted means gone from the file.
const PROMISES = `
  PRAGMA journal_mode = WAL;
  PRAGMA synchronous = FULL;
  PRAGMA foreign_keys = ON;
  PRAGMA secure_delete = ON;
  PRAGMA busy_timeout = 2000;
`;

// A document from before there were short codes keeps its id; stored again, the same text gets a code.
const SHORT_CODES = `
UPDATE documents SET hash = 'before:' || hash;
`;

/** What each version added to the one before it: the first leads from an empty file to version 1. */
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
];

/**
 * Opens a database, made when it is missing.
 * @param newest version that it is brought to, for tests: as an earlier Corridor left it
 * @throws as `prepareDatabase` does
 */
export function openDatabase(file: string, newest = STEPS.length): DatabaseSync {
  const db = new DatabaseSync(file);
  prepareDatabase(db, newest);
  return db;
}

/** Opens another connection to a prepared database, which promises as much. */
export function openForWriting(file: string): DatabaseSync {
  const db = new DatabaseSync(file);
  db.exec(PROMISES);
  return db;
}

/** Opens another connection to a prepared database: it sees what is committed, and changes nothing. */
export function openForReading(file: string): DatabaseSync {
  return new DatabaseSync(file, { readOnly: true });
}

/**
 * Brings an open database to the schema of this version.
 * @throws Error when the file was written by a newer version
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
  for (let next = version; next < newest; next++) {
    db.exec(`BEGIN IMMEDIATE; ${STEPS[next] ?? ""} PRAGMA user_version = ${next + 1}; COMMIT;`);
  }
}
