/**
 * Group commit: many steps of the SQLite stores share one commit. The result of each step is
 * returned only after the commit.
 *
 * Two kinds of steps share groups. A memory step decides about commands in memory and adds entries
 * to the journal. While the journal writes one group, steps of the next group run. A rows step
 * changes rows and needs exclusive access to the database. It waits until no write is in progress.
 * Its group is one transaction of this connection, which includes the journal entries. Steps run in
 * order of arrival, so steps behind a waiting one wait too.
 *
 * A group ends with the turn of the event loop, after 50 steps (32 for an idle journal), or after 5
 * ms, whichever is first. It is written after the previous group, and includes the steps that
 * arrived meanwhile. So a single step does not wait for others. Always waiting for 5 ms would limit
 * a sequential client to 230 steps a second instead of 21,000.
 *
 * A step that throws is rolled back alone. If rows were changed, the whole group is rolled back and
 * the earlier steps run again. This is rare, while a savepoint would add a cost to every step. If
 * one of the repeated steps throws, all of them fail.
 */
import type { DatabaseSync } from "node:sqlite";
import {
  InlineJournal,
  JournalWriter,
  type Journal,
  type Entry,
  type Compaction,
} from "./journal.ts";
import { Statements } from "./statements.ts";

const MOST_STEPS = 50;
/** An idle journal receives this many steps at once, and writes them while the next steps run. */
const ENOUGH_STEPS = 32;
const LONGEST_MS = 5;
/** The journal is idle if it received nothing for this time. */
const IDLE_MS = 10;

/** rows: needs the database. memory: adds entries. alone: runs outside of a transaction. */
type Kind = "rows" | "memory" | "alone";

interface Step {
  kind: Kind;
  /** runs the step; may run again after a rollback */
  work: () => void;
  /** called once the group is on disk, or has failed */
  stored: () => void;
  lost: (error: unknown) => void;
}

interface Group {
  startedAt: number;
  steps: Step[];
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
  /** whether an idle journal would have something to compact */
  readonly needsCompaction: boolean;
  /** Called after a compaction. @param failed the error; null if it succeeded */
  compacted(compaction: Compaction, failed: unknown): void;
}

export interface GroupCommitParts {
  memory?: Memory;
  journal?: Journal;
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
  readonly #own: JournalWriter;
  readonly #journal: Journal;
  readonly #memory: Memory;
  readonly #now: () => number;
  /** steps that have run and are not being written yet */
  #open: Group | null = null;
  /** the group that the journal is writing */
  #writing: Group | null = null;
  /** steps that have not run */
  #waiting: Step[] = [];
  /** number of steps in `#waiting` that have run; removing each one would shift all others */
  #doneOfWaiting = 0;
  /** number of groups that the journal received */
  #sent = 0;
  #timer: NodeJS.Timeout | null = null;
  #isClosed = false;
  #isGoingOn = false;
  /** memory is poisoned: a step that threw left partial changes */
  #isBroken = false;

  constructor(
    db: DatabaseSync,
    {
      memory = NO_MEMORY,
      journal = new InlineJournal(db),
      now = () => performance.now(),
    }: GroupCommitParts = {},
  ) {
    this.#db = db;
    this.#statements = new Statements(db);
    this.#own = new JournalWriter(db);
    this.#memory = memory;
    this.#journal = journal;
    this.#now = now;
  }

  /**
   * Runs one atomic step. If it throws, it has no effect, and other steps are not affected.
   * @param step may run again after a rollback; it must change only the database and the memory
   *   that belongs to it
   * @param kind memory: it changes no rows
   * @returns its result once it is on disk
   */
  run<T>(step: () => T, kind: "rows" | "memory" = "rows"): Promise<T> {
    return this.#take(step, kind);
  }

  /** Runs work outside of a transaction. All earlier steps are on disk by then. */
  alone<T>(work: () => T): Promise<T> {
    return this.#take(work, "alone");
  }

  /** Whether a memory step would run immediately and see the current memory. */
  get isPrompt(): boolean {
    return this.#next === null && !this.#isBroken;
  }

  /** Adds an entry to the journal. Must be called within a step. */
  append(entry: Entry): void {
    if (this.#open === null) throw new Error("append() was called outside of a step.");
    this.#open.entries.push(entry);
  }

  /** Waits for all steps. Later steps are rejected. */
  async close(): Promise<void> {
    const done = this.alone(() => undefined);
    this.#isClosed = true;
    if (this.#timer !== null) clearTimeout(this.#timer);
    await done;
    await this.#journal.close();
  }

  #take<T>(work: () => T, kind: Kind): Promise<T> {
    if (this.#isClosed) return Promise.reject(new Error("The store is closed."));
    return new Promise((resolve, reject) => {
      let result: T;
      const step: Step = {
        kind,
        work: () => {
          result = work();
        },
        stored: () => resolve(result),
        lost: reject,
      };
      if (this.#next === null && this.#mayDo(kind)) this.#do(step);
      else this.#waiting.push(step);
    });
  }

  #mayDo(kind: Kind): boolean {
    return !this.#isBroken && (kind === "memory" || this.#writing === null);
  }

  #do(step: Step): void {
    if (step.kind === "alone") return this.#doAlone(step);
    const group = this.#open ?? this.#begin();
    const entries = group.entries.length;
    try {
      if (step.kind === "rows") this.#openTransaction(group);
    } catch (error) {
      return step.lost(error);
    }
    try {
      step.work();
    } catch (error) {
      step.lost(error);
      return group.isTransaction ? this.#undoNewest(group, error) : this.#fail(group, entries);
    }
    group.steps.push(step);
    if (
      group.steps.length >= (group.isTransaction ? MOST_STEPS : ENOUGH_STEPS) ||
      this.#now() - group.startedAt >= LONGEST_MS
    )
      this.#flush();
  }

  #doAlone(step: Step): void {
    const group = this.#open;
    if (group !== null) this.#commit(group);
    try {
      step.work();
    } catch (error) {
      return step.lost(error);
    }
    step.stored();
  }

  #begin(): Group {
    const group = this.#newGroup();
    this.#open = group;
    setImmediate(() => {
      if (this.#open === group) this.#flush();
    });
    return group;
  }

  #newGroup(): Group {
    return { startedAt: this.#now(), steps: [], entries: [], isTransaction: false };
  }

  #openTransaction(group: Group): void {
    if (group.isTransaction) return;
    this.#statements.run("BEGIN IMMEDIATE");
    group.isTransaction = true;
  }

  /** Handles an error of a step that changes no rows. Its entries are not written. */
  #fail(group: Group, entries: number): void {
    if (group.entries.length === entries) return;
    group.entries.length = entries;
    this.#isBroken = true;
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

  /** Writes the open group unless a write is in progress. */
  #flush(): void {
    const group = this.#open;
    if (group === null || this.#writing !== null) return;
    if (group.isTransaction) {
      this.#commit(group);
      // Sends an empty group, so that overdue compaction also runs if every group changes rows.
      this.#send(this.#newGroup());
    } else this.#send(group);
    this.#goOn();
  }

  /** Commits a group through this connection. */
  #commit(group: Group): void {
    try {
      this.#openTransaction(group);
      this.#own.append(group.entries);
      this.#statements.run("COMMIT");
    } catch (error) {
      this.#rollBack(group);
      return this.#lose(group, error);
    }
    this.#open = null;
    for (const { stored } of group.steps) stored();
  }

  /** Writes a group through the journal. */
  #send(group: Group, isIdle = false): void {
    this.#open = null;
    this.#sent += 1;
    // Poisoned memory must not reach the tables, because the failed step has no entries.
    const compaction = this.#isBroken ? null : this.#memory.due(group.entries.length, isIdle);
    if (group.entries.length === 0 && compaction === null) {
      for (const { stored } of group.steps) stored();
      return;
    }
    this.#writing = group;
    this.#journal.write(group.entries, compaction, (lost, compactionError) => {
      this.#writing = null;
      if (compaction !== null) this.#memory.compacted(compaction, lost ?? compactionError);
      if (lost === null) for (const { stored } of group.steps) stored();
      else this.#undoSince(group, lost);
      // A failed compaction is retried with the next write, not in a loop.
      const isWell = lost === null && compactionError === null;
      this.#goOn(isWell);
      if (isIdle && isWell) this.#compactMore();
    });
  }

  /** Fails a group, and runs all later steps again, because they saw its results. */
  #undoSince(group: Group, error: unknown): void {
    this.#waiting = [...(this.#open?.steps ?? []), ...this.#waiting.slice(this.#doneOfWaiting)];
    this.#doneOfWaiting = 0;
    this.#open = null;
    this.#isBroken = false;
    this.#memory.rolledBack();
    for (const { lost } of group.steps) lost(error);
  }

  #lose(group: Group, error: unknown): void {
    this.#open = null;
    for (const { lost } of group.steps) lost(error);
  }

  /**
   * Continues after a write: runs waiting steps, and writes finished steps if no write is in
   * progress.
   */
  #goOn(mayCompact = true): void {
    if (mayCompact && this.#memory.needsCompaction) this.#compactSoon();
    // The running loop handles the work of nested calls. Recursion could be thousands of calls deep
    // behind a slow disk.
    if (this.#isGoingOn) return;
    this.#isGoingOn = true;
    try {
      while (this.#hasMore()) {
        this.#doWaiting();
        this.#flush();
      }
    } finally {
      this.#isGoingOn = false;
    }
  }

  #hasMore(): boolean {
    if (this.#writing === null && (this.#open !== null || this.#isBroken)) return true;
    return this.#next !== null && this.#mayDo(this.#next.kind);
  }

  /** The first step that has not run. */
  get #next(): Step | null {
    return this.#waiting[this.#doneOfWaiting] ?? null;
  }

  #doWaiting(): void {
    if (this.#isBroken && this.#writing === null && this.#open === null) {
      this.#isBroken = false;
      this.#memory.rolledBack();
    }
    for (let next = this.#next; next !== null && this.#mayDo(next.kind); next = this.#next) {
      this.#doneOfWaiting += 1;
      if (this.#next === null) {
        this.#waiting = [];
        this.#doneOfWaiting = 0;
      }
      this.#do(next);
    }
  }

  /** Schedules compaction for when the journal is idle. */
  #compactSoon(): void {
    if (this.#timer !== null || this.#isClosed) return;
    const sent = this.#sent;
    this.#timer = setTimeout(() => {
      this.#timer = null;
      if (this.#isIdleSince(sent)) this.#send(this.#newGroup(), true);
      else if (this.#memory.needsCompaction) this.#compactSoon();
    }, IDLE_MS).unref();
  }

  /** Continues compaction without a delay while there is nothing else to write. */
  #compactMore(): void {
    const sent = this.#sent;
    setImmediate(() => {
      if (this.#isClosed || !this.#memory.needsCompaction || !this.#isIdleSince(sent)) return;
      this.#send(this.#newGroup(), true);
    });
  }

  #isIdleSince(sent: number): boolean {
    return this.#sent === sent && this.#open === null && this.#writing === null;
  }
}
