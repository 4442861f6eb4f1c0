/** The thread that writes the journal: see `ThreadedJournal`. */
import { parentPort, workerData } from "node:worker_threads";
import { JournalWriter, type Entry, type Compaction } from "./journal.ts";
import { openForWriting } from "./sqlite-schema.ts";

/** null: the thread must end */
export type Order = { entries: Flat; compaction: Compaction | null } | null;

/** Flattened entries, because nested arrays take longer to transfer. */
type Flat = readonly Entry[number][];

export interface Answer {
  lost: Failure | null;
  compactionError: Failure | null;
}

interface Failure {
  message: string;
  /** error code of SQLite; null for other errors */
  errcode: number | null;
}

const db = openForWriting(String(workerData));
const writer = new JournalWriter(db);

parentPort?.on("message", (order: Order) => {
  if (order === null) {
    db.close();
    parentPort?.close();
    return;
  }
  parentPort?.postMessage(done(order));
});

function done({ entries, compaction }: NonNullable<Order>): Answer {
  try {
    return { lost: null, compactionError: failureOf(writer.write(entriesIn(entries), compaction)) };
  } catch (error) {
    return { lost: failureOf(error), compactionError: null };
  }
}

function entriesIn(flat: Flat): Entry[] {
  const entries: Entry[] = [];
  for (let at = 0; at < flat.length; at += 3) entries.push(flat.slice(at, at + 3) as Entry);
  return entries;
}

function failureOf(error: unknown): Failure | null {
  if (error === null) return null;
  if (!(error instanceof Error))
    return { message: "The thrown value is not an Error.", errcode: null };
  const errcode = "errcode" in error && typeof error.errcode === "number" ? error.errcode : null;
  return { message: error.message, errcode };
}
