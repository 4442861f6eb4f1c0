/** Samples of a class as the relay sends it. */
import type { ClassView, Progress, ProgressRecord, StudentView } from "@corridor/protocol";

export function studentView(student: number, change: Partial<StudentView> = {}): StudentView {
  return {
    student,
    name: { word: student, text: null },
    renamesLeft: 2,
    joinedAt: "2026-01-01T08:00:00.000Z",
    helpSince: null,
    programs: 0,
    ...change,
  };
}

export function record(seq: number, activeMs: number, event: Progress): ProgressRecord {
  return { seq, at: "2026-01-01T08:00:00.000Z", activeMs, event };
}

export function classView(
  students: ClassView["students"] = [],
  change: Partial<ClassView> = {},
): ClassView {
  return {
    id: "A".repeat(22),
    now: "2026-01-01T08:10:00.000Z",
    activeMs: 600_000,
    endsInSeconds: 12 * 3_600 - 600,
    expected: 24,
    settings: {
      code: "BCDFGH",
      locked: false,
      pauseEndsInMs: null,
      paceTo: null,
      lesson: "k3J9x2aBk3J9x2aBk3J9x2",
    },
    students,
    since: "k3J9x2aB-4",
    ...change,
  };
}
