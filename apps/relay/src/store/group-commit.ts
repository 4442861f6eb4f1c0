/**
 * Many steps of the SQLite stores, one commit: the disk is asked to keep them all at once, and each is
 * answered only after that.
 *
 * There are two kinds. What becomes of commands is decided in memory and kept by entries of the journal: while
 * that writes a group, the next one is done. A step that changes rows needs the database for itself: it waits
 * until nothing is being written, and its group is one transaction of this connection, entries and all. Steps
 * are done in the order in which they come, so those after one that waits wait with it.
 *
 * A group ends with the turn of the event loop in which it began, after 50 steps (32 for an idle journal), or after
 * 5 ms, whatever comes first, and is written once the one before it is: then it has what came meanwhile, however much
 * that is. So a lone step waits for nobody, and what arrives while the disk works is the next group. To wait the 5 ms
 * in any case would let one who sends one by one do 230 steps a second, not 21,000.
 *
 * A step that throws is undone alone. Where rows were changed, the group is rolled back, and the steps before it are
 * done once more: that is rare, and a savepoint around each step costs each of them. Should one of those fail
 * then, all of them do.
 */
import type { DatabaseSync } from "node:sqlite";
import { InlineJournal, type Journal } from "./journal.ts";
import { JournalWriter, type Entry, type Tidying } from "./journal-writer.ts";
import { Statements } from "./statements.ts";

const MOST_STEPS = 50;
/** A journal that has nothing to write is given so many at once, and writes them while the next are done. */
const ENOUGH_STEPS = 32;
const LONGEST_MS = 5;
/** Who was given nothing to write for so long is idle. */
const IDLE_MS = 10;

/** rows: needs the database. memory: adds entries. alone: outside of a transaction. */
type Kind = "rows" | "memory" | "alone";

interface Step {
  kind: Kind;
  /** does it, or does it once more after it was undone */
  work: () => void;
  /** what follows once the group is on disk, or is not */
  kept: () => void;
  lost: (error: unknown) => void;
}

interface Group {
  begunAt: number;
  steps: Step[];
  entries: Entry[];
  /** it has changed rows, or may have */
  isTransaction: boolean;
}

/** What is in memory beside the database. */
export interface Memory {
  /** steps were undone, and what is in memory may not hold: is called before anything else is done */
  undone(): void;
  /** what is to be tidied with so many entries. @param isIdle nothing else is to be written */
  due(entries: number, isIdle: boolean): Tidying | null;
  /** whether there would be something to tidy where nothing else is to be written */
  readonly isUntidy: boolean;
  /** @param failed why it was not; null: it was */
  tidied(tidying: Tidying, failed: unknown): void;
}

export interface GroupCommitParts {
  memory?: Memory;
  journal?: Journal;
  /** ms by a clock that is never set back */
  now?: () => number;
}

const NO_MEMORY: Memory = {
  undone: () => undefined,
  due: () => null,
  isUntidy: false,
  tidied: () => undefined,
};

export class GroupCommit {
  readonly #db: DatabaseSync;
  readonly #statements: Statements;
  readonly #own: JournalWriter;
  readonly #journal: Journal;
  readonly #memory: Memory;
  readonly #now: () => number;
  /** what is done and not on its way to the disk */
  #open: Group | null = null;
  /** what the journal writes at the moment */
  #writing: Group | null = null;
  /** what is to be done */
  #waiting: Step[] = [];
  /** how many of these are done: to take each away would move all others */
  #doneOfWaiting = 0;
  /** how many groups the journal was given */
  #sent = 0;
  #timer: NodeJS.Timeout | null = null;
  #isClosed = false;
  #isGoingOn = false;
  /** a step has left half of itself in memory */
  #isSpoiled = false;

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
   * One atomic step: all of it or, when it throws, nothing, whatever becomes of the others.
   * @param step may be called more than once, with what it did before undone: it changes the database, and
   *   memory beside it, alone
   * @param kind memory: it changes no rows
   * @returns its result once it is on disk
   */
  run<T>(step: () => T, kind: "rows" | "memory" = "rows"): Promise<T> {
    return this.#take(step, kind);
  }

  /** Work that has to be outside of a transaction: what was done before is on disk by then. */
  alone<T>(work: () => T): Promise<T> {
    return this.#take(work, "alone");
  }

  /** Whether a step in memory would be done at once: what is in memory is what it would find. */
  get isPrompt(): boolean {
    return this.#next === null && !this.#isSpoiled;
  }

  /** Adds an entry to the journal, in a step. */
  append(entry: Entry): void {
    if (this.#open === null) throw new Error("append() was called outside of a step.");
    this.#open.entries.push(entry);
  }

  /** Waits for all that was asked for; nothing is done any more after that. */
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
        kept: () => resolve(result),
        lost: reject,
      };
      if (this.#next === null && this.#mayDo(kind)) this.#do(step);
      else this.#waiting.push(step);
    });
  }

  #mayDo(kind: Kind): boolean {
    return !this.#isSpoiled && (kind === "memory" || this.#writing === null);
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
      return group.isTransaction ? this.#undoNewest(group, error) : this.#spoil(group, entries);
    }
    group.steps.push(step);
    if (
      group.steps.length >= (group.isTransaction ? MOST_STEPS : ENOUGH_STEPS) ||
      this.#now() - group.begunAt >= LONGEST_MS
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
    step.kept();
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
    return { begunAt: this.#now(), steps: [], entries: [], isTransaction: false };
  }

  #openTransaction(group: Group): void {
    if (group.isTransaction) return;
    this.#statements.run("BEGIN IMMEDIATE");
    group.isTransaction = true;
  }

  /** A step threw that changes no rows: none of its entries is written. */
  #spoil(group: Group, entries: number): void {
    if (group.entries.length === entries) return;
    group.entries.length = entries;
    this.#isSpoiled = true;
  }

  /** Undoes what a step did before it threw, and keeps what the others of its group have done. */
  #undoNewest(group: Group, error: unknown): void {
    // Some errors, a full disk's among them, have undone the whole group.
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
    this.#memory.undone();
  }

  /** Lets what is done go to the disk, as soon as that has done with what it writes. */
  #flush(): void {
    const group = this.#open;
    if (group === null || this.#writing !== null) return;
    if (group.isTransaction) {
      this.#commit(group);
      // What cannot wait any more is tidied also where each group changes rows.
      this.#send(this.#newGroup());
    } else this.#send(group);
    this.#goOn();
  }

  /** By this connection. */
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
    for (const { kept } of group.steps) kept();
  }

  /** By the journal. */
  #send(group: Group, isIdle = false): void {
    this.#open = null;
    this.#sent += 1;
    // Half of a step in memory is nothing to bring into tables: it has no entries.
    const tidying = this.#isSpoiled ? null : this.#memory.due(group.entries.length, isIdle);
    if (group.entries.length === 0 && tidying === null) {
      for (const { kept } of group.steps) kept();
      return;
    }
    this.#writing = group;
    this.#journal.write(group.entries, tidying, (lost, untidied) => {
      this.#writing = null;
      if (tidying !== null) this.#memory.tidied(tidying, lost ?? untidied);
      if (lost === null) for (const { kept } of group.steps) kept();
      else this.#undoSince(group, lost);
      // What could not be tidied now is tried again with what is written next, and not for ever meanwhile.
      const isWell = lost === null && untidied === null;
      this.#goOn(isWell);
      if (isIdle && isWell) this.#tidyOn();
    });
  }

  /** What was done since then was done with what is lost now: it is done once more. */
  #undoSince(group: Group, error: unknown): void {
    this.#waiting = [...(this.#open?.steps ?? []), ...this.#waiting.slice(this.#doneOfWaiting)];
    this.#doneOfWaiting = 0;
    this.#open = null;
    this.#isSpoiled = false;
    this.#memory.undone();
    for (const { lost } of group.steps) lost(error);
  }

  #lose(group: Group, error: unknown): void {
    this.#open = null;
    for (const { lost } of group.steps) lost(error);
  }

  /** Something is over: what waited for that is done, and what is done goes to the disk, as far as that is free. */
  #goOn(mayTidy = true): void {
    if (mayTidy && this.#memory.isUntidy) this.#tidySoon();
    // What this loop itself has led to is its next round, not a call within it: thousands may wait behind a slow disk.
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
    if (this.#writing === null && (this.#open !== null || this.#isSpoiled)) return true;
    return this.#next !== null && this.#mayDo(this.#next.kind);
  }

  /** The first that waits. */
  get #next(): Step | null {
    return this.#waiting[this.#doneOfWaiting] ?? null;
  }

  #doWaiting(): void {
    if (this.#isSpoiled && this.#writing === null && this.#open === null) {
      this.#isSpoiled = false;
      this.#memory.undone();
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

  /** Where nothing is to be written for a while, there is time to tidy. */
  #tidySoon(): void {
    if (this.#timer !== null || this.#isClosed) return;
    const sent = this.#sent;
    this.#timer = setTimeout(() => {
      this.#timer = null;
      if (this.#isIdleSince(sent)) this.#send(this.#newGroup(), true);
      else if (this.#memory.isUntidy) this.#tidySoon();
    }, IDLE_MS).unref();
  }

  /** As long as there still is nothing else to write, what is next is tidied without a pause. */
  #tidyOn(): void {
    const sent = this.#sent;
    setImmediate(() => {
      if (this.#isClosed || !this.#memory.isUntidy || !this.#isIdleSince(sent)) return;
      this.#send(this.#newGroup(), true);
    });
  }

  #isIdleSince(sent: number): boolean {
    return this.#sent === sent && this.#open === null && this.#writing === null;
  }
}
