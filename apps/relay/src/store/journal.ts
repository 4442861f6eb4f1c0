/** Who writes the journal, and where: with whoever calls, or on a thread of its own. */
import type { DatabaseSync } from "node:sqlite";
import { JournalWriter, type Entry, type Tidying } from "./journal-writer.ts";

/**
 * What became of writing.
 * @param lost why nothing of it is on disk; null: it is
 * @param untidied why it was not tidied all the same; null: it was
 */
export type Told = (lost: unknown, untidied: unknown) => void;

export interface Journal {
  /**
   * Writes entries for good, and tidies with them where that can be done. Nobody else may write to the database
   * until it is told what became of that, and then it may have been told before this returns.
   */
  write(entries: readonly Entry[], tidying: Tidying | null, told: Told): void;
  close(): Promise<void>;
}

/** Writes by the connection, and on the thread, of whoever calls. */
export class InlineJournal implements Journal {
  readonly #writer: JournalWriter;

  constructor(db: DatabaseSync) {
    this.#writer = new JournalWriter(db);
  }

  write(entries: readonly Entry[], tidying: Tidying | null, told: Told): void {
    let untidied: unknown;
    try {
      untidied = this.#writer.write(entries, tidying);
    } catch (error) {
      return told(error, null);
    }
    told(null, untidied);
  }

  async close(): Promise<void> {}
}
