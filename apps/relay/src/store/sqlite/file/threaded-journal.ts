/**
 * Writes the journal on a separate thread. The thread waits for the disk while the relay runs the
 * steps of the next commit.
 */
import { Worker } from "node:worker_threads";
import type { Journal, Written, Entry, Compaction } from "./journal.ts";
import type { Answer, Order } from "./journal-thread.ts";

export class ThreadedJournal implements Journal {
  readonly #path: string;
  /** null: the thread has ended; the next write starts a new one */
  #thread: Worker | null;
  #written: Written | null = null;

  /** @param path of an existing database with the newest schema */
  constructor(path: string) {
    this.#path = path;
    this.#thread = this.#start();
  }

  write(entries: readonly Entry[], compaction: Compaction | null, written: Written): void {
    this.#written = written;
    try {
      this.#thread ??= this.#start();
      // Keeps the process alive until the answer arrives, but not longer.
      this.#thread.ref();
      this.#thread.postMessage({ entries: entries.flat(), compaction } satisfies Order);
    } catch (error) {
      // The system may be unable to start a thread. Deferred, because the callback may write again
      // immediately.
      setImmediate(() => this.#notify(error, null));
    }
  }

  async close(): Promise<void> {
    const thread = this.#thread;
    if (thread === null) return;
    // Not `once` of node:events, which rejects if the thread fails. The thread ends in any case.
    const ended = new Promise((resolve) => thread.once("exit", resolve));
    thread.ref();
    thread.postMessage(null);
    await ended;
  }

  #start(): Worker {
    const thread = new Worker(new URL("journal-thread.ts", import.meta.url), {
      workerData: this.#path,
    });
    thread.unref();
    let failed: unknown = null;
    thread.on("message", ({ lost, compactionError }: Answer) => {
      thread.unref();
      this.#notify(lost && errorOf(lost), compactionError && errorOf(compactionError));
    });
    thread.on("error", (error) => {
      failed = error;
    });
    thread.on("exit", (code) => {
      this.#thread = null;
      // The thread's connection is closed by now, so the caller can read what is on disk.
      this.#notify(failed ?? new Error(`The journal thread exited with code ${code}.`), null);
    });
    return thread;
  }

  #notify(lost: unknown, compactionError: unknown): void {
    const written = this.#written;
    this.#written = null;
    written?.(lost, compactionError);
  }
}

/**
 * Restores an error from the thread, because a transferred error loses its additional properties.
 */
function errorOf({ message, errcode }: NonNullable<Answer["lost"]>): Error {
  return Object.assign(new Error(message), { errcode });
}
