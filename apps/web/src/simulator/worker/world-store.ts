/**
 * The worlds of this device's tabs, in IndexedDB: each has the inputs of the run, and the endings
 * of script commands in it. Both are written in one transaction, so neither is ever newer than the
 * other.
 *
 * A world has one writer. A page that restores it claims it, and later writes of the previous page
 * are rejected.
 */
import type { CommandJournal } from "@corridor/client/host";
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { RunUpdate } from "@corridor/recording";

const DATABASE = "corridor";
/** A tab that was closed this long ago is not opened again. */
const STORED_MS = 7 * 24 * 60 * 60 * 1000;

/** Endings of one robot's commands in a world. */
export interface WorldJournal extends CommandJournal {
  /** the robot's id at the relay */
  robot: string;
  /** the running command, and the units driven before it */
  running: { seq: number; distance: number } | null;
}

export interface StoredWorld {
  /** fields of a run document; another version of the page may have written them */
  run: Record<string, unknown>;
  /** when the run began, in ms since 1970 */
  startedAt: number;
  journal: WorldJournal | null;
}

export interface WorldStore {
  /**
   * Makes the caller the writer of a world.
   * @returns null without a world
   */
  claim(key: string, writer: string): Promise<StoredWorld | null>;
  /**
   * Appends to a world, or replaces it if the update starts again.
   * @returns "claimed" if another page is its writer, "gone" if there is nothing to append to
   */
  write(key: string, writer: string, entry: WorldEntry): Promise<"stored" | "claimed" | "gone">;
}

export interface WorldEntry {
  update: RunUpdate;
  /** when the run began, in ms since 1970 */
  startedAt: number;
  journal: WorldJournal | null;
  /** whether it must survive a power failure, too */
  isStrict: boolean;
}

/** The newest state of a world. */
interface Head {
  writer: string;
  /** when it was written, in ms since 1970 */
  at: number;
  /** number of parts */
  parts: number;
  ticks: number;
  digest: string;
  startedAt: number;
  journal: WorldJournal | null;
}

/** The content of one write, under the key [world, number]. */
interface Part {
  first: { maze: MazeDocument; program: ProgramDocument } | null;
  inputs: RunUpdate["inputs"];
}

/** @param now milliseconds since 1970 */
export async function openWorldStore(now: () => number): Promise<WorldStore> {
  const opening = indexedDB.open(DATABASE, 1);
  opening.onupgradeneeded = () => {
    opening.result.createObjectStore("heads");
    opening.result.createObjectStore("parts");
  };
  const database = await resultOf(opening);
  // A later version of the page may need another one.
  database.onversionchange = () => database.close();

  const begin = (isStrict: boolean) => {
    const transaction = database.transaction(["heads", "parts"], "readwrite", {
      durability: isStrict ? "strict" : "relaxed",
    });
    return {
      transaction,
      heads: transaction.objectStore("heads"),
      parts: transaction.objectStore("parts"),
    };
  };

  const deleteOld = async (): Promise<void> => {
    const { transaction, heads, parts } = begin(false);
    const cursor = heads.openCursor();
    cursor.onsuccess = () => {
      if (cursor.result === null) return;
      const { at } = cursor.result.value as Head;
      if (now() - at > STORED_MS) {
        parts.delete(partsOf(cursor.result.key));
        cursor.result.delete();
      }
      cursor.result.continue();
    };
    await doneOf(transaction);
  };
  // Later requests wait for it anyway.
  deleteOld().catch(() => undefined);

  return {
    async claim(key, writer) {
      const { transaction, heads, parts } = begin(true);
      const done = doneOf(transaction);
      const stored: { head?: Head; parts: Part[] } = { parts: [] };
      const head = heads.get(key);
      const all = parts.getAll(partsOf(key));
      head.onsuccess = () => {
        if (head.result === undefined) return;
        stored.head = head.result as Head;
        heads.put({ ...stored.head, writer }, key);
      };
      all.onsuccess = () => (stored.parts = all.result as Part[]);
      await done;
      const first = stored.parts[0]?.first;
      if (stored.head === undefined || first === undefined || first === null) return null;
      const { ticks, digest, startedAt, journal } = stored.head;
      const inputs = stored.parts.flatMap((part) => part.inputs);
      return { run: { ...first, ticks, digest, inputs }, startedAt, journal };
    },

    async write(key, writer, { update, startedAt, journal, isStrict }) {
      const { first, inputs, ticks, digest } = update;
      const { transaction, heads, parts } = begin(isStrict);
      const done = doneOf(transaction);
      let outcome: "stored" | "claimed" | "gone" = "stored";
      const before = heads.get(key);
      before.onsuccess = () => {
        const head = before.result as Head | undefined;
        if (head !== undefined && head.writer !== writer) outcome = "claimed";
        else if (head === undefined && first === null) outcome = "gone";
        else {
          let count = head?.parts ?? 0;
          if (first !== null) {
            parts.delete(partsOf(key));
            count = 0;
          }
          if (first !== null || inputs.length > 0) {
            parts.put({ first, inputs } satisfies Part, [key, count++]);
          }
          const written = { writer, at: now(), parts: count };
          heads.put({ ...written, ticks, digest, startedAt, journal } satisfies Head, key);
        }
        transaction.commit();
      };
      await done;
      return outcome;
    },
  };
}

/** All parts of a world. */
function partsOf(key: IDBValidKey): IDBKeyRange {
  return IDBKeyRange.bound([key, 0], [key, Infinity]);
}

function resultOf<Result>(request: IDBRequest<Result>): Promise<Result> {
  return new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error ?? new Error("the request failed"));
  });
}

function doneOf(transaction: IDBTransaction): Promise<void> {
  return new Promise((resolve, reject) => {
    const fail = (): void => reject(transaction.error ?? new Error("the transaction was aborted"));
    transaction.oncomplete = () => resolve();
    transaction.onerror = fail;
    transaction.onabort = fail;
  });
}
