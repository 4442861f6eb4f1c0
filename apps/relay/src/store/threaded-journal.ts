/**
 * Writes the journal on a thread of its own: a commit waits for the disk there, and the relay goes on meanwhile
 * with what is the next commit.
 */
import { Worker } from "node:worker_threads";
import type { Journal, Told } from "./journal.ts";
import type { Entry, Tidying } from "./journal-writer.ts";
import type { Answer, Order } from "./journal-thread.ts";

export class ThreadedJournal implements Journal {
  readonly #path: string;
  /** null: it has ended, and is started again with the next entries */
  #thread: Worker | null;
  #told: Told | null = null;

  /** @param path of a database that is there, of the newest schema */
  constructor(path: string) {
    this.#path = path;
    this.#thread = this.#start();
  }

  write(entries: readonly Entry[], tidying: Tidying | null, told: Told): void {
    this.#told = told;
    try {
      this.#thread ??= this.#start();
      // A process that has nothing else to do stays for the answer, and for nothing else.
      this.#thread.ref();
      this.#thread.postMessage({ entries: entries.flat(), tidying } satisfies Order);
    } catch (error) {
      // The machine has no thread for it, say. Later, since whoever is told may write again at once.
      setImmediate(() => this.#tell(error, null));
    }
  }

  async close(): Promise<void> {
    const thread = this.#thread;
    if (thread === null) return;
    // Not by `once` of node:events, which is thrown an error of the thread: it has ended all the same.
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
    thread.on("message", ({ lost, untidied }: Answer) => {
      thread.unref();
      this.#tell(lost && errorOf(lost), untidied && errorOf(untidied));
    });
    thread.on("error", (error) => {
      failed = error;
    });
    thread.on("exit", (code) => {
      this.#thread = null;
      // Its connection is closed by now: whoever is told can read what is on disk.
      this.#tell(failed ?? new Error(`The journal thread exited with code ${code}.`), null);
    });
    return thread;
  }

  #tell(lost: unknown, untidied: unknown): void {
    const told = this.#told;
    this.#told = null;
    told?.(lost, untidied);
  }
}

/** An error as it was before it came from the thread, which loses what is not an error's own. */
function errorOf({ message, errcode }: NonNullable<Answer["lost"]>): Error {
  return Object.assign(new Error(message), { errcode });
}
