/**
 * Group commit: many steps of the SQLite stores share one commit. The result of each step is
 * returned only after the commit.
 *
 * A memory step decides about commands in memory and adds entries to the journal. A rows step
 * changes rows. Steps run in order of arrival; those of a group and their entries are one
 * transaction.
 *
 * A group ends with the turn of the event loop, after 50 steps, or after 5 ms, whichever is first.
 * So a single step does not wait for others. Always waiting for 5 ms would limit a sequential client
 * to 230 steps a second instead of 21,000.
 *
 * A step that throws is rolled back alone. If rows were changed, the whole group is rolled back and
 * the earlier steps run again. This is rare, while a savepoint would add a cost to every step. If
 * one of the repeated steps throws, all of them fail.
 */
import type { DatabaseSync } from "node:sqlite";
import { JournalWriter, type Entry, type Compaction } from "./journal.ts";
import { Statements } from "./statements.ts";

const MOST_STEPS = 50;
const LONGEST_MS = 5;
/** Compaction starts after no step arrived for this time. */
const IDLE_MS = 10;

/** rows: needs a transaction. memory: adds entries. */
export type StepKind = "rows" | "memory";

interface QueuedStep {
  kind: StepKind;
  /** runs the step; may run again after a rollback */
  work: () => void;
  /** called once the group is on disk, or has failed */
  stored: () => void;
  lost: (error: unknown) => void;
}

interface Group {
  startedAt: number;
  steps: QueuedStep[];
  entries: Entry[];
  /** whether it has changed rows, or may have */
  isTransaction: boolean;
}

/** State in memory that belongs to the database. */
export interface Memory {
  /** Called first after a rollback: the state in memory may be invalid. */
  rolledBack(): void;
  /** Compaction to write with a number of entries. @param isIdle nothing else is to be written */
  due(entries: number, isIdle: boolean): Compaction | null;
  /** whether there would be something to compact while nothing else is written */
  readonly needsCompaction: boolean;
  /** Called after a compaction. @param failed the error; null if it succeeded */
  compacted(compaction: Compaction, failed: unknown): void;
}

export interface GroupCommitParts {
  memory?: Memory;
  journal?: Pick<JournalWriter, "write" | "append">;
  /** ms of a monotonic clock */
  now?: () => number;
}

const NO_MEMORY: Memory = {
  rolledBack: () => undefined,
  due: () => null,
  needsCompaction: false,
  compacted: () => undefined,
};

export class GroupCommit {
  readonly #db: DatabaseSync;
  readonly #statements: Statements;
  readonly #journal: Pick<JournalWriter, "write" | "append">;
  readonly #memory: Memory;
  readonly #now: () => number;
  /** steps that have run and are not on disk */
  #open: Group | null = null;
  /** number of groups that were begun */
  #begun = 0;
  #timer: NodeJS.Timeout | null = null;
  #isClosed = false;

  constructor(
    db: DatabaseSync,
    {
      memory = NO_MEMORY,
      journal = new JournalWriter(db),
      now = () => performance.now(),
    }: GroupCommitParts = {},
  ) {
    this.#db = db;
    this.#statements = new Statements(db);
    this.#journal = journal;
    this.#memory = memory;
    this.#now = now;
  }

  /**
   * Runs one atomic step. If it throws, it has no effect, and other steps are not affected.
   * @param step may run again after a rollback; it must change only the database and the memory
   *   that belongs to it
   * @param kind memory: it changes no rows
   * @returns its result once it is on disk
   */
  run<T>(step: () => T, kind: StepKind = "rows"): Promise<T> {
    if (this.#isClosed) return Promise.reject(closedError());
    return new Promise((resolve, reject) => {
      let result: T;
      this.#do({
        kind,
        work: () => {
          result = step();
        },
        stored: () => resolve(result),
        lost: reject,
      });
    });
  }

  /** Runs work outside of a transaction. All earlier steps are on disk by then. */
  async alone<T>(work: () => T): Promise<T> {
    if (this.#isClosed) throw closedError();
    this.#flush();
    return work();
  }

  /** Adds an entry to the journal. Must be called within a step. */
  append(entry: Entry): void {
    if (this.#open === null) throw new Error("append() was called outside of a step.");
    this.#open.entries.push(entry);
  }

  /** Writes all steps. Later steps are rejected. */
  close(): void {
    this.#flush();
    this.#isClosed = true;
    if (this.#timer !== null) clearTimeout(this.#timer);
  }

  #do(step: QueuedStep): void {
    const group = this.#open ?? this.#begin();
    const entries = group.entries.length;
    try {
      if (step.kind === "rows") this.#openTransaction(group);
      step.work();
    } catch (error) {
      step.lost(error);
      if (group.isTransaction) this.#undoNewest(group, error);
      else if (group.entries.length > entries) this.#undoEntries(group, entries);
      return;
    }
    group.steps.push(step);
    if (group.steps.length >= MOST_STEPS || this.#now() - group.startedAt >= LONGEST_MS)
      this.#flush();
  }

  #begin(): Group {
    const group: Group = {
      startedAt: this.#now(),
      steps: [],
      entries: [],
      isTransaction: false,
    };
    this.#open = group;
    this.#begun += 1;
    setImmediate(() => {
      if (this.#open === group) this.#flush();
    });
    return group;
  }

  #openTransaction(group: Group): void {
    if (group.isTransaction) return;
    this.#statements.run("BEGIN IMMEDIATE");
    group.isTransaction = true;
  }

  /** Drops the entries of a step that threw. Memory holds its changes, so it must be restored. */
  #undoEntries(group: Group, entries: number): void {
    group.entries.length = entries;
    this.#open = null;
    // Without a compaction, which would be computed from that memory.
    this.#write(group, null);
    this.#memory.rolledBack();
  }

  /** Rolls back a step that threw, and runs the earlier steps of its group again. */
  #undoNewest(group: Group, error: unknown): void {
    // Some errors, such as a full disk, have already rolled back the whole group.
    const isGone = !this.#db.isTransaction;
    this.#rollBack(group);
    if (isGone) return this.#lose(group, error);
    try {
      this.#openTransaction(group);
      for (const { work } of group.steps) work();
    } catch (again) {
      this.#rollBack(group);
      this.#lose(group, again);
    }
  }

  #rollBack(group: Group): void {
    if (this.#db.isTransaction) this.#statements.run("ROLLBACK");
    group.isTransaction = false;
    group.entries = [];
    this.#memory.rolledBack();
  }

  #lose(group: Group, error: unknown): void {
    this.#open = null;
    for (const { lost } of group.steps) lost(error);
  }

  /** Writes the open group, and a compaction if one is due. */
  #flush(isIdle = false): void {
    let group = this.#open;
    this.#open = null;
    if (group?.isTransaction === true) {
      this.#commit(group);
      // A failed compaction must not roll back rows, so it is written after them.
      group = null;
    }
    const compaction = this.#memory.due(group?.entries.length ?? 0, isIdle);
    const isWritten = this.#write(group, compaction);
    // A failed compaction is retried with the next write, not in a loop.
    if (!isWritten || !this.#memory.needsCompaction) return;
    if (isIdle) this.#compactMore();
    else this.#compactSoon();
  }

  /** Commits a group that has changed rows. */
  #commit(group: Group): void {
    try {
      this.#journal.append(group.entries);
      this.#statements.run("COMMIT");
    } catch (error) {
      this.#rollBack(group);
      return this.#lose(group, error);
    }
    for (const { stored } of group.steps) stored();
  }

  /** Commits the entries of a group and a compaction. @returns whether both are on disk */
  #write(group: Group | null, compaction: Compaction | null): boolean {
    const { entries, steps } = group ?? { entries: [], steps: [] };
    let compactionError: unknown = null;
    try {
      if (entries.length > 0 || compaction !== null)
        compactionError = this.#journal.write(entries, compaction);
    } catch (error) {
      if (compaction !== null) this.#memory.compacted(compaction, error);
      this.#memory.rolledBack();
      for (const { lost } of steps) lost(error);
      return false;
    }
    if (compaction !== null) this.#memory.compacted(compaction, compactionError);
    for (const { stored } of steps) stored();
    return compactionError === null;
  }

  /** Schedules compaction for when no steps arrive. */
  #compactSoon(): void {
    if (this.#timer !== null || this.#isClosed) return;
    const begun = this.#begun;
    this.#timer = setTimeout(() => {
      this.#timer = null;
      if (this.#begun === begun) this.#flush(true);
      else if (this.#memory.needsCompaction) this.#compactSoon();
    }, IDLE_MS).unref();
  }

  /** Continues compaction without a delay while no steps arrive. */
  #compactMore(): void {
    const begun = this.#begun;
    setImmediate(() => {
      if (this.#isClosed || !this.#memory.needsCompaction || this.#begun !== begun) return;
      this.#flush(true);
    });
  }
}

function closedError(): Error {
  return new Error("The store is closed.");
}
