/**
 * A group commit whose writes fail on request of the test. Its steps store their names in memory and
 * in the journal.
 */
import { join } from "node:path";
import type { DatabaseSync } from "node:sqlite";
import { onTestFinished } from "vitest";
import { testFolder } from "../../testing/test-relay.ts";
import { GroupCommit, type Memory } from "../sqlite/file/group-commit.ts";
import { JournalWriter, type Entry, type Compaction } from "../sqlite/file/journal.ts";
import { openDatabase } from "../sqlite/file/sqlite-schema.ts";

export const LOST = new Error("lost");
export const NOTHING: Compaction = { checkpoints: [], deleted: 0, unreadable: [] };

const namesOf = (entries: readonly Entry[]): string[] => entries.map(([, , text]) => text);

/** Writes to the database, except for the failures that a test asks for. */
class FailingJournal {
  readonly #writer: JournalWriter;
  /** result of the next write; null: it succeeds */
  fails: { lost?: Error; compactionError?: Error } | null = null;
  readonly writes: { names: string[]; compaction: Compaction | null }[] = [];
  readonly lostNames: string[] = [];

  constructor(db: DatabaseSync) {
    this.#writer = new JournalWriter(db);
  }

  write(entries: readonly Entry[], compaction: Compaction | null): unknown {
    this.writes.push({ names: namesOf(entries), compaction });
    const compactionError = this.fails?.compactionError;
    this.#lose(entries);
    this.#writer.write(entries, null);
    return compactionError ?? null;
  }

  append(entries: readonly Entry[]): void {
    this.#lose(entries);
    this.#writer.append(entries);
  }

  #lose(entries: readonly Entry[]): void {
    const lost = this.fails?.lost;
    this.fails = null;
    if (lost === undefined) return;
    this.lostNames.push(...namesOf(entries));
    throw lost;
  }
}

/** State in memory: the names of all steps that added an entry. */
function namesInMemory(db: DatabaseSync) {
  const sql = "SELECT entry FROM journal ORDER BY id";
  const onDisk = () =>
    db
      .prepare(sql)
      .all()
      .map(({ entry }) => String(entry));
  let names: string[] | null = null;
  const parts = { due: null as Compaction | null, needsCompaction: false };
  const compacted: unknown[] = [];
  const memory: Memory = {
    rolledBack: () => (names = null),
    due: () => parts.due,
    get needsCompaction() {
      return parts.needsCompaction;
    },
    compacted: (_, failed) => compacted.push(failed),
  };
  return { memory, parts, compacted, onDisk, names: () => (names ??= onDisk()) };
}

/** Runs steps by name. Each step appends its name and returns all names. */
export function withJournal() {
  const db = openDatabase(join(testFolder(), "corridor.sqlite"));
  onTestFinished(() => db.close());
  db.exec("CREATE TABLE rows (name TEXT PRIMARY KEY) STRICT");
  const { memory, parts, compacted, onDisk, names } = namesInMemory(db);
  const anew = () => {
    memory.rolledBack();
    const journal = new FailingJournal(db);
    return { journal, commits: new GroupCommit(db, { memory, journal, now: () => 0 }) };
  };
  const { journal, commits } = anew();
  const append = (name: string, to = commits): void => {
    names().push(name);
    to.append([names().length, "robot", name]);
  };
  const settled: string[] = [];
  const note = <T>(name: string, step: Promise<T>): Promise<T> => {
    const done = (how: string) => () => void settled.push(`${name} ${how}`);
    step.then(done("stored"), done("lost"));
    return step;
  };
  const step = (name: string, work = () => append(name)) =>
    note(
      name,
      commits.run(() => {
        work();
        return [...names()];
      }, "memory"),
    );
  const rows = (name: string) =>
    note(
      name,
      commits.run(() => {
        db.prepare("INSERT INTO rows VALUES (?)").run(name);
        append(name);
        return [...names()];
      }),
    );
  const hasRow = () =>
    db
      .prepare("SELECT name FROM rows")
      .all()
      .map(({ name }) => String(name));
  const steps = { append, step, rows };
  return { db, anew, journal, commits, ...steps, hasRow, settled, names, onDisk, parts, compacted };
}
