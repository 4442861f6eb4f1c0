/** The presets that were solved on this device, as it stores them. */
import type { StoreApi } from "zustand/vanilla";
import type { KeyValueStorage } from "../storage/key-value-storage.ts";

/** stored ids; those of a later version of Corridor are retained */
export type SolvedStore = StoreApi<{ ids: readonly string[] }>;

export const SOLVED_KEY = "corridor.solved";

/** An entry that cannot be read counts as none. */
export function readSolved(device: KeyValueStorage): string[] {
  let stored: unknown;
  try {
    stored = JSON.parse(device.getItem(SOLVED_KEY) ?? "[]");
  } catch {
    return [];
  }
  const names: unknown[] = Array.isArray(stored) ? stored : [];
  return names.filter((name) => typeof name === "string");
}
