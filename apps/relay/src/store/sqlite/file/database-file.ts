/**
 * The SQLite file on disk. It is private to the user of this process and checked before use. A
 * damaged file is renamed, so that the relay serves an intact database or none.
 */
import {
  chmodSync,
  closeSync,
  existsSync,
  mkdirSync,
  openSync,
  renameSync,
  statSync,
} from "node:fs";
import { dirname } from "node:path";
import { DatabaseSync } from "node:sqlite";
import { prepareDatabase } from "./sqlite-schema.ts";

/** SQLite's error codes: https://www.sqlite.org/rescode.html */
const SQLITE_ERROR = 1;
const SQLITE_PERM = 3;
const SQLITE_READONLY = 8;
const SQLITE_IOERR = 10;
const SQLITE_CORRUPT = 11;
const SQLITE_CANTOPEN = 14;
const SQLITE_CONSTRAINT = 19;
const SQLITE_NOTADB = 26;
const DAMAGED: ReadonlySet<number> = new Set([SQLITE_CORRUPT, SQLITE_NOTADB]);
/** Error codes of the integrity check if damaged text breaks a generated column. */
const DAMAGED_COLUMN: ReadonlySet<number> = new Set([SQLITE_ERROR, SQLITE_CONSTRAINT]);
const NO_ACCESS: ReadonlySet<number> = new Set([
  SQLITE_PERM,
  SQLITE_READONLY,
  SQLITE_IOERR,
  SQLITE_CANTOPEN,
]);
/**
 * Finds texts that are not JSON. The integrity check does not parse texts, and reads would fail
 * later.
 */
const DAMAGED_TEXT = `
  SELECT 1 FROM (
    SELECT entry AS text FROM journal UNION ALL SELECT entry FROM commands
    UNION ALL SELECT text FROM mazes UNION ALL SELECT text FROM documents
    UNION ALL SELECT row FROM classes UNION ALL SELECT lesson FROM classes
    UNION ALL SELECT row FROM students UNION ALL SELECT coalesce(program, '{}') FROM students
    UNION ALL SELECT text FROM progress
  ) WHERE NOT json_valid(text) LIMIT 1`;
/** Finds invalid JSON in the command and the pose, which are texts inside an entry. */
const DAMAGED_INSIDE = `
  SELECT 1 FROM (SELECT entry FROM journal UNION ALL SELECT entry FROM commands)
  WHERE NOT (json_valid(entry ->> 4) AND json_valid(coalesce(entry ->> 13, '{}'))) LIMIT 1`;
/** The lowest byte of an extended error code is its primary code. */
const PRIMARY_CODE = 0xff;

/** Read and write for the owner, nothing for others. SQLite gives -wal and -shm the same mode. */
const PRIVATE = 0o600;

/** The database cannot be used. The message names its path and the solution. */
export class DatabaseFileError extends Error {
  override readonly name = "DatabaseFileError";

  constructor(path: string, cause: unknown) {
    const reason = cause instanceof Error ? cause.message : String(cause);
    super(
      `The database ${path} cannot be opened: ${reason}. Give the user that runs Corridor permission to read and ` +
        "write this file and its folder, or set DATA_DIR to another folder.",
      { cause },
    );
  }
}

/**
 * Creates the file and its folder if they are missing, and removes all permissions of other users.
 * @throws DatabaseFileError
 */
export function preparePrivateFile(path: string): void {
  try {
    makeFolder(dirname(path));
    closeSync(openSync(path, "a", PRIVATE));
    for (const file of filesOf(path)) {
      if ((statSync(file).mode & 0o777) !== PRIVATE) chmodSync(file, PRIVATE);
    }
  } catch (error) {
    throw new DatabaseFileError(path, error);
  }
}

/**
 * Not `recursive`: with it, Node never returns if the system rejects a folder with ENOENT, as in
 * /proc.
 */
function makeFolder(path: string): void {
  if (existsSync(path)) return;
  const parent = dirname(path);
  if (parent !== path) makeFolder(parent);
  try {
    mkdirSync(path);
  } catch (error) {
    // Another relay that starts at the same time may have created it.
    if (!existsSync(path)) throw error;
  }
}

/**
 * Opens the database and migrates it to the newest schema. A damaged file is renamed and replaced
 * by a new one.
 * @param setAside receives the new path of a damaged file
 * @throws DatabaseFileError if the file is not accessible, or as `prepareDatabase` does
 */
export function openIntactDatabase(path: string, setAside: (to: string) => void): DatabaseSync {
  try {
    return open(path);
  } catch (error) {
    const code = primaryCode(error);
    if (NO_ACCESS.has(code)) throw new DatabaseFileError(path, error);
    if (!DAMAGED.has(code)) throw error;
  }
  const to = freePath(`${path}.damaged`);
  for (const file of filesOf(path)) renameSync(file, to + file.slice(path.length));
  setAside(to);
  preparePrivateFile(path);
  return open(path);
}

function open(path: string): DatabaseSync {
  const db = new DatabaseSync(path);
  try {
    const found = checkFile(db);
    if (found !== "ok") throw damaged(found);
    prepareDatabase(db);
    for (const damage of [DAMAGED_TEXT, DAMAGED_INSIDE])
      if (db.prepare(damage).get() !== undefined) throw damaged("a text is not JSON");
    return db;
  } catch (error) {
    db.close();
    throw error;
  }
}

/** @returns "ok" or a description of the damage */
function checkFile(db: DatabaseSync): string {
  try {
    return String(db.prepare("PRAGMA integrity_check(1)").get()?.["integrity_check"]);
  } catch (error) {
    if (DAMAGED_COLUMN.has(primaryCode(error))) throw damaged(String(error));
    throw error;
  }
}

function damaged(reason: string): Error {
  return Object.assign(new Error(reason), { errcode: SQLITE_CORRUPT });
}

function primaryCode(error: unknown): number {
  return error instanceof Error && "errcode" in error ? Number(error.errcode) & PRIMARY_CODE : 0;
}

/** The database and the files that SQLite creates beside it. */
function filesOf(path: string): string[] {
  return [path, `${path}-wal`, `${path}-shm`].filter((file) => existsSync(file));
}

function freePath(path: string): string {
  if (!existsSync(path)) return path;
  for (let count = 2; ; count++) {
    if (!existsSync(`${path}-${count}`)) return `${path}-${count}`;
  }
}
