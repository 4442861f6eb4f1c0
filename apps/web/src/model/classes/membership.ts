/**
 * The class that this tab has joined. The tab stores the key of the student and the pause, so that a
 * reload stays in the class, and ends no pause.
 */
import { joinedClassSchema, readJson, type JoinedClass } from "@corridor/protocol";
import type { KeyValueStorage } from "../storage/key-value-storage.ts";
import { CLASS_KEY } from "./class-key.ts";
import { PAUSE_KEY, storedKeys } from "./stored-keys.ts";

const MAX_STORED_TEXT = 1_024;

/** @returns null if this tab has joined no class */
export function storedMembership(tab: KeyValueStorage): JoinedClass | null {
  const text = tab.getItem(CLASS_KEY);
  if (text === null) return null;
  const read = readJson(joinedClassSchema, text, MAX_STORED_TEXT);
  return read.ok ? read.value : null;
}

/** Another student, or a student of another class, starts with nothing of the one before. */
export function storeMembership(tab: KeyValueStorage, joined: JoinedClass): void {
  if (storedMembership(tab)?.key !== joined.key) removeMembership(tab);
  try {
    tab.setItem(CLASS_KEY, JSON.stringify(joined));
  } catch {
    // Without storage, a reload needs the letters again.
  }
}

/** Removes the key of the student and all else of the class from this tab: the student has left. */
export function removeMembership(tab: KeyValueStorage): void {
  for (const key of [CLASS_KEY, ...storedKeys]) tab.removeItem(key);
}

/** @returns the end of the pause in milliseconds since 1970; null if the class is not paused */
export function storedPauseEnd(tab: KeyValueStorage): number | null {
  const endsAt = Number(tab.getItem(PAUSE_KEY) ?? Number.NaN);
  return Number.isSafeInteger(endsAt) ? endsAt : null;
}

export function storePauseEnd(tab: KeyValueStorage, endsAt: number | null): void {
  if (endsAt === null) return tab.removeItem(PAUSE_KEY);
  try {
    tab.setItem(PAUSE_KEY, String(endsAt));
  } catch {
    // Without storage, a reload learns of the pause once it is connected.
  }
}
