/** Interface of the journal, and an implementation that writes synchronously. */
import type { DatabaseSync } from "node:sqlite";
import { JournalWriter, type Entry, type Tidying } from "./journal-writer.ts";

/**
 * Receives the result of a write.
 * @param lost the error if nothing was written, or null
 * @param untidied the error if only the compaction failed, or null
 */
export type Told = (lost: unknown, untidied: unknown) => void;

export interface Journal {
  /**
   * Commits entries, together with a compaction if possible. No other write to the database may
   * start before `told` is called, which can happen before this method returns.
   */
  write(entries: readonly Entry[], tidying: Tidying | null, told: Told): void;
  close(): Promise<void>;
}

/** Writes on the caller's thread and connection. */
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
