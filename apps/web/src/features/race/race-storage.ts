/** The ghosts of a race in the storage of this tab, so that they survive a reload. */
import { readRun, type RunDocument } from "@corridor/recording";
import type { KeyValueStorage } from "../../model/storage/key-value-storage.ts";
import { RACE_KEY } from "../../model/run/race-store.ts";

export interface StoredGhost {
  /** A to G */
  badge: string;
  run: RunDocument;
}

/** If the storage is full, the race lasts until the student leaves the page. */
export function storeGhosts(tab: KeyValueStorage, ghosts: readonly StoredGhost[]): void {
  tab.removeItem(RACE_KEY);
  if (ghosts.length === 0) return;
  const stored = ghosts.map(({ badge, run }) => ({ badge, run: JSON.stringify(run) }));
  try {
    tab.setItem(RACE_KEY, JSON.stringify(stored));
  } catch {
    // Nothing from before this page view is lost.
  }
}

/** Skips unreadable entries. */
export function readGhosts(tab: KeyValueStorage): StoredGhost[] {
  let stored: unknown;
  try {
    stored = JSON.parse(tab.getItem(RACE_KEY) ?? "[]");
  } catch {
    return [];
  }
  if (!Array.isArray(stored)) return [];
  return stored.flatMap((each: unknown) => {
    if (typeof each !== "object" || each === null) return [];
    if (!("badge" in each && "run" in each)) return [];
    const { badge, run } = each;
    if (typeof badge !== "string" || typeof run !== "string") return [];
    const read = readRun(run);
    return read.ok ? [{ badge, run: read.value }] : [];
  });
}
