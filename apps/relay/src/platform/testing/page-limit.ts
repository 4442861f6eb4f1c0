/** Simulated full disk: SQLite's own page limit. */
import { DatabaseSync } from "node:sqlite";
import { onTestFinished, vi } from "vitest";

const PLENTY = 100_000;

/**
 * Limits the size of the database that `open` opens first.
 * @param open any function that opens it
 */
export async function withPageLimit<T>(open: () => T | Promise<T>) {
  const exec = vi.spyOn(DatabaseSync.prototype, "exec");
  onTestFinished(() => exec.mockRestore());
  const opened = await open();
  const at = exec.mock.calls.findIndex(([sql]) => sql.includes("journal_mode = WAL"));
  const db = exec.mock.contexts[at];
  if (!(db instanceof DatabaseSync)) throw new Error("no database was opened");
  const limit = (pages: number): void => db.exec(`PRAGMA max_page_count = ${pages}`);
  const size = (): number => Number(db.prepare("PRAGMA page_count").get()?.["page_count"]);
  return {
    opened,
    /** @param spare number of pages that stay free */
    fill: (spare = 0) => limit(size() + spare),
    makeRoom: () => limit(PLENTY),
  };
}
