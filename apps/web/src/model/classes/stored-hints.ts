/**
 * The hints of the lesson of the class that this tab displays. The tab stores them, so that a reload
 * hides none of them.
 */
import type { KeyValueStorage } from "../storage/key-value-storage.ts";
import { HINTS_KEY } from "./stored-keys.ts";

/** How many hints of a task, by its index. */
export type Hints = Readonly<Record<number, number>>;

interface StoredHints {
  /** on display */
  hints: Hints;
  /** as far as the student has closed them */
  read: Hints;
}

const none: StoredHints = { hints: {}, read: {} };

/** @param mark of the lesson; the hints of another one are not read */
export function storedHints(tab: KeyValueStorage, mark: string | null): StoredHints {
  try {
    const stored: unknown = JSON.parse(tab.getItem(HINTS_KEY) ?? "null");
    if (typeof stored !== "object" || stored === null) return none;
    const { mark: of, hints, read } = stored as Record<string, unknown>;
    return of === mark ? { hints: numbersIn(hints), read: numbersIn(read) } : none;
  } catch {
    return none;
  }
}

export function storeHints(tab: KeyValueStorage, mark: string | null, stored: StoredHints): void {
  try {
    tab.setItem(HINTS_KEY, JSON.stringify({ mark, ...stored }));
  } catch {
    // Without storage, the teacher shows the hint again.
  }
}

/** The teacher shows a hint, and all hints before it. */
export function withHint(hints: Hints, index: number, hint: number): Hints {
  return { ...hints, [index]: Math.max(hint, hints[index] ?? 0) };
}

function numbersIn(value: unknown): Hints {
  if (typeof value !== "object" || value === null) return {};
  const entries = Object.entries(value).flatMap(([key, each]) =>
    Number.isSafeInteger(Number(key)) && Number.isSafeInteger(each) ? [[key, Number(each)]] : [],
  );
  return Object.fromEntries(entries) as Hints;
}
