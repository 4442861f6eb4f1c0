/** The state of a class, and what its members see of it. Pure: no clock, no I/O. */
import type { ClassSettings, StudentName, StudentView } from "@corridor/protocol";
import type { ClassChanges, ClassRow, LoadedClass, StudentRow } from "../store/class-store.ts";

export interface ClassState {
  row: ClassRow;
  /** by number, in the order in which they joined */
  students: ReadonlyMap<number, StudentRow>;
}

export function stateOf({ row, students }: LoadedClass): ClassState {
  return { row, students: new Map(students.map((each) => [each.student, each])) };
}

/** The rows that a commit replaces. */
export type ChangedRows = Pick<ClassChanges, "row" | "students" | "removed">;

export function applied(state: ClassState, { row, students, removed }: ChangedRows): ClassState {
  const all = new Map(state.students);
  for (const each of students) all.set(each.student, each);
  for (const student of removed) all.delete(student);
  return { row, students: all };
}

/** When the pause ends; null if the class is not paused. */
function pauseEnd({ pause }: ClassRow, now: number): number | null {
  return pause !== null && pause.endsAt > now ? pause.endsAt : null;
}

/** ms of all pauses until now */
export function pausedMs({ pause, pausedMs: before }: ClassRow, now: number): number {
  return before + (pause === null ? 0 : Math.max(0, Math.min(now, pause.endsAt) - pause.startedAt));
}

/** ms since the class was created, without its pauses */
export function activeMs(row: ClassRow, now: number): number {
  return Math.max(0, now - row.createdAt - pausedMs(row, now));
}

/** Whether the settings that members see differ. */
export function differInSettings(one: ClassRow, other: ClassRow): boolean {
  return (
    one.code !== other.code ||
    one.isLocked !== other.isLocked ||
    one.pause?.endsAt !== other.pause?.endsAt ||
    one.paceTo !== other.paceTo ||
    one.lessonVersion !== other.lessonVersion
  );
}

export function settingsOf(row: ClassRow, now: number): ClassSettings {
  const end = pauseEnd(row, now);
  return {
    code: row.code,
    locked: row.isLocked,
    pauseEndsInMs: end === null ? null : end - now,
    paceTo: row.paceTo,
    lesson: row.lessonVersion,
  };
}

export function nameOf({ names }: ClassRow, { name }: StudentRow): StudentName {
  return names === null ? { word: name, text: null } : { word: null, text: names[name] ?? "" };
}

export function viewOf(row: ClassRow, student: StudentRow): StudentView {
  return {
    student: student.student,
    name: nameOf(row, student),
    renamesLeft: student.renamesLeft,
    joinedAt: isoTime(student.joinedAt),
    helpSince: student.helpSince === null ? null : isoTime(student.helpSince),
    programs: student.programs,
  };
}

export function isoTime(ms: number): string {
  return new Date(ms).toISOString();
}
