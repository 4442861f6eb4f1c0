import type { ClassRow } from "../class-store.ts";

/** A new class. @param change what matters to the test */
export function classRow(change: Partial<ClassRow> = {}): ClassRow {
  return {
    version: 0,
    n: 0,
    stream: "abcdefgh",
    createdAt: 0,
    names: null,
    expected: null,
    keys: [],
    code: "BCDFGH",
    isLocked: false,
    pause: null,
    pausedMs: 0,
    paceTo: null,
    lessonVersion: "first",
    lastStudent: 0,
    ...change,
  };
}
