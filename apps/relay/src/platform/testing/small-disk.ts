/** Simulated full disks: with SQLite's own page limit, or with a real disk of a few MiB. */
import { spawnSync } from "node:child_process";
import { rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { DatabaseSync } from "node:sqlite";
import { onTestFinished, vi } from "vitest";
import { testFolder } from "../../testing/test-relay.ts";

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

/**
 * A separate disk in memory, removed after the test. Returns null without the permission to mount.
 */
export function realSmallDisk(mebibytes: number) {
  const folder = testFolder();
  if (!mount(folder, mebibytes)) return null;
  onTestFinished(() => void spawnSync("umount", [folder]));
  const filler = join(folder, "filler");
  return {
    folder,
    fill: () => {
      for (let size = mebibytes * 1024 * 1024; size >= 512; size /= 2) {
        try {
          writeFileSync(filler, Buffer.alloc(size), { flag: "a" });
        } catch {
          // Not enough space. Tries half of it.
        }
      }
    },
    makeRoom: () => rmSync(filler),
  };
}

function mount(folder: string, mebibytes: number): boolean {
  if (process.platform !== "linux" || process.getuid?.() !== 0) return false;
  const options = ["-t", "tmpfs", "-o", `size=${mebibytes}m`, "tmpfs", folder];
  return spawnSync("mount", options, { stdio: "ignore" }).status === 0;
}
