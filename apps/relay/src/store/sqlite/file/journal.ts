/** Interface of the journal, and an implementation that writes synchronously. */
import type { DatabaseSync } from "node:sqlite";
import { JournalWriter, type Entry, type Compaction } from "./journal-writer.ts";

/**
 * Receives the result of a write.
 * @param lost the error if nothing was written, or null
 * @param compactionError the error if only the compaction failed, or null
 */
export type Written = (lost: unknown, compactionError: unknown) => void;

export interface Journal {
  /**
   * Commits entries, together with a compaction if possible. No other write to the database may
   * start before `written` is called, which can happen before this method returns.
   */
  write(entries: readonly Entry[], compaction: Compaction | null, written: Written): void;
  close(): Promise<void>;
}

/** Writes on the caller's thread and connection. */
export class InlineJournal implements Journal {
  readonly #writer: JournalWriter;

  constructor(db: DatabaseSync) {
    this.#writer = new JournalWriter(db);
  }

  write(entries: readonly Entry[], compaction: Compaction | null, written: Written): void {
    let compactionError: unknown;
    try {
      compactionError = this.#writer.write(entries, compaction);
    } catch (error) {
      return written(error, null);
    }
    written(null, compactionError);
  }

  async close(): Promise<void> {}
}
