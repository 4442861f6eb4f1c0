/**
 * Many steps of the SQLite stores, one commit: the disk is asked to keep them all at once, and each is
 * answered only after that.
 *
 * A group ends with the turn of the event loop in which it began, after 128 steps, or after 5 ms, whatever
 * comes first. So a lone step waits for nobody, and what arrives while the disk works is the next group.
 * To wait the 5 ms in any case would let one who sends one by one do 230 steps a second, not 21,000.
 *
 * A step that throws is undone alone: the group is rolled back, and the steps before it are done once more.
 * That is rare, and a savepoint around each step costs each of them. Should one of those fail then, all of them do.
 */
import type { DatabaseSync } from "node:sqlite";
import { Statements } from "./statements.ts";

/** Some 64 commands: each is stored in one, and in another it is looked what its robot may have. */
const MOST_STEPS = 128;
const LONGEST_MS = 5;

interface Group {
  begunAt: number;
  steps: Step[];
}

interface Step {
  /** does it, or does it once more after it was undone */
  work: () => void;
  /** what follows once the group is on disk, or is not */
  kept: () => void;
  lost: (error: unknown) => void;
}

export class GroupCommit {
  readonly #db: DatabaseSync;
  readonly #statements: Statements;
  readonly #now: () => number;
  readonly #undone: () => void;
  #group: Group | null = null;

  /**
   * @param undone is called when steps are undone, before anything else is done
   * @param now ms by a clock that is never set back
   */
  constructor(
    db: DatabaseSync,
    undone: () => void = () => undefined,
    now: () => number = () => performance.now(),
  ) {
    this.#db = db;
    this.#undone = undone;
    this.#now = now;
    this.#statements = new Statements(db);
  }

  /**
   * One atomic step: all of it or, when it throws, nothing, whatever becomes of the others.
   * @param step may be called more than once, with what it did before undone: it changes the database alone
   * @returns its result once it is on disk
   */
  run<T>(step: () => T): Promise<T> {
    return new Promise((resolve, reject) => {
      let group: Group;
      let result: T;
      const work = (): void => {
        result = step();
      };
      try {
        group = this.#group ?? this.#begin();
      } catch (error) {
        return reject(error);
      }
      try {
        work();
      } catch (error) {
        reject(error);
        return this.#undoNewest(error);
      }
      group.steps.push({ work, kept: () => resolve(result), lost: reject });
      const isLong = this.#now() - group.begunAt >= LONGEST_MS;
      if (group.steps.length >= MOST_STEPS || isLong) this.flush();
    });
  }

  /** Work that has to be outside of a transaction: what is open is committed before. */
  alone<T>(work: () => T): T {
    this.flush();
    return work();
  }

  /** Commits what is open. Whether that failed is told to those who wait for it. */
  flush(): void {
    if (this.#group === null) return;
    try {
      this.#statements.run("COMMIT");
    } catch (error) {
      this.#rollBack();
      return this.#end((each) => each.lost(error));
    }
    this.#end((each) => each.kept());
  }

  #begin(): Group {
    this.#statements.run("BEGIN IMMEDIATE");
    const group: Group = { begunAt: this.#now(), steps: [] };
    this.#group = group;
    setImmediate(() => {
      if (this.#group === group) this.flush();
    });
    return group;
  }

  /** Undoes what a step did before it threw, and keeps what the others of its group have done. */
  #undoNewest(error: unknown): void {
    // Some errors, a full disk's among them, have undone the whole group.
    const isGone = !this.#db.isTransaction;
    try {
      this.#rollBack();
      if (isGone) return this.#end((each) => each.lost(error));
      this.#statements.run("BEGIN IMMEDIATE");
      for (const { work } of this.#group?.steps ?? []) work();
    } catch (again) {
      this.#rollBack();
      this.#end((each) => each.lost(again));
    }
  }

  #rollBack(): void {
    this.#undone();
    if (this.#db.isTransaction) this.#statements.run("ROLLBACK");
  }

  #end(tell: (step: Step) => void): void {
    const steps = this.#group?.steps ?? [];
    this.#group = null;
    for (const each of steps) tell(each);
  }
}
