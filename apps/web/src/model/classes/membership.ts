/**
 * The class that this tab has joined. The tab stores the key of the student, so that a reload stays
 * in the class.
 */
import { joinedClassSchema, readJson, type JoinedClass } from "@corridor/protocol";
import type { KeyValueStorage } from "../storage/key-value-storage.ts";
import { CLASS_KEY } from "./class-key.ts";

const MAX_STORED_TEXT = 1_024;

/** @returns null if this tab has joined no class */
export function storedMembership(tab: KeyValueStorage): JoinedClass | null {
  const text = tab.getItem(CLASS_KEY);
  if (text === null) return null;
  const read = readJson(joinedClassSchema, text, MAX_STORED_TEXT);
  return read.ok ? read.value : null;
}

export function storeMembership(tab: KeyValueStorage, joined: JoinedClass): void {
  try {
    tab.setItem(CLASS_KEY, JSON.stringify(joined));
  } catch {
    // Without storage, a reload needs the letters again.
  }
}

/** Removes the key of the student from this tab: the student has left the class. */
export function removeMembership(tab: KeyValueStorage): void {
  tab.removeItem(CLASS_KEY);
}
