/**
 * Many steps of the SQLite stores, one commit: the disk is asked to keep them all at once, and each is
 * answered only after that.
 *
 * A group ends with the turn of the event loop in which it began, after 50 steps, or after 5 ms, whatever
 * comes first. So a lone step waits for nobody, and what arrives while the disk works is the next group.
 * To wait the 5 ms in any case would let one who sends one by one do 230 steps a second, not 21,000.
 */
import type { DatabaseSync } from "node:sqlite";
import { Statements } from "./statements.ts";

const MOST_STEPS = 50;
const LONGEST_MS = 5;

interface Group {
  begunAt: number;
  /** what follows for each step once the group is on disk, or is not */
  steps: { kept: () => void; lost: (error: unknown) => void }[];
}

export class GroupCommit {
  readonly #db: DatabaseSync;
  readonly #statements: Statements;
  readonly #now: () => number;
  #group: Group | null = null;

  /** @param now ms by a clock that is never set back */
  constructor(db: DatabaseSync, now: () => number = () => performance.now()) {
    this.#db = db;
    this.#now = now;
    this.#statements = new Statements(db);
  }

  /**
   * One atomic step: all of it or, when it throws, nothing, whatever becomes of the others.
   * @returns its result once it is on disk
   */
  run<T>(step: () => T): Promise<T> {
    return new Promise((resolve, reject) => {
      let group: Group;
      let result: T;
      try {
        group = this.#group ?? this.#begin();
        result = this.#inSavepoint(step);
      } catch (error) {
        // Some errors, a full disk's among them, undo the whole group.
        if (!this.#db.isTransaction) this.#end((each) => each.lost(error));
        return reject(error);
      }
      group.steps.push({ kept: () => resolve(result), lost: reject });
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
      if (this.#db.isTransaction) this.#statements.run("ROLLBACK");
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

  #inSavepoint<T>(step: () => T): T {
    this.#statements.run("SAVEPOINT step");
    try {
      const result = step();
      this.#statements.run("RELEASE step");
      return result;
    } catch (error) {
      if (this.#db.isTransaction) {
        this.#statements.run("ROLLBACK TO step");
        this.#statements.run("RELEASE step");
      }
      throw error;
    }
  }

  #end(tell: (step: Group["steps"][number]) => void): void {
    const steps = this.#group?.steps ?? [];
    this.#group = null;
    for (const each of steps) tell(each);
  }
}
