/** The thread that writes the journal: see `ThreadedJournal`. */
import { parentPort, workerData } from "node:worker_threads";
import { JournalWriter, type Entry, type Tidying } from "./journal-writer.ts";
import { openForWriting } from "./sqlite-schema.ts";

/** null: there is nothing more to write */
export type Order = { entries: Flat; tidying: Tidying | null } | null;

/** Entries, one after the other: lists in a list take longer to be handed over. */
type Flat = readonly Entry[number][];

export interface Answer {
  lost: Failure | null;
  untidied: Failure | null;
}

interface Failure {
  message: string;
  /** of SQLite; null: it is no error of that */
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

function done({ entries, tidying }: NonNullable<Order>): Answer {
  try {
    return { lost: null, untidied: failureOf(writer.write(entriesIn(entries), tidying)) };
  } catch (error) {
    return { lost: failureOf(error), untidied: null };
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
