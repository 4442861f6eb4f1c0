/**
 * A step of a class: a function of its state that decides on changes and events. Steps may run
 * again on a newer state, if another relay has changed the class meanwhile.
 */
import type { ProgressRecord } from "@corridor/protocol";
import type { ClassRecord } from "../bus/class-record.ts";
import type { ClassChanges, ClassRow, StudentRow } from "../store/class-store.ts";
import { differInSettings, viewOf, type ClassState } from "./class-state.ts";

/** Sources of what a step does not decide itself. */
export interface StepContext {
  now: number;
  readonly mintCode: () => string;
  /** @returns a whole number from 0 up to the bound, which is excluded */
  readonly random: (below: number) => number;
}

export interface StepResult<T> {
  value: T;
  /** null: nothing changes */
  changes: ClassChanges | null;
  events: readonly ClassRecord[];
}

/** @throws Refusal if the state does not permit the step */
export type Step<T> = (state: ClassState, context: StepContext) => StepResult<T>;

/** Nothing changes. */
export function unchanged<T>(value: T): StepResult<T> {
  return { value, changes: null, events: [] };
}

interface Change extends Partial<Omit<ClassChanges, "row">> {
  row?: Partial<ClassRow>;
  events?: readonly ClassRecord[];
}

/** Changes to the next version of the class. */
export function changed<T>(
  { row: before }: ClassState,
  value: T,
  { row, events = [], ...rest }: Change,
): StepResult<T> {
  const next = { ...before, ...row, version: before.version + 1 };
  const all: ClassRecord[] = [...events];
  if (differInSettings(before, next)) all.push({ type: "settings" });
  next.n += all.length;
  return { value, changes: { ...noChanges(next), ...rest }, events: all };
}

/** A student joined or changed, which dashboards then see, with a new progress record. */
export function studentChanged<T>(
  state: ClassState,
  value: T,
  student: StudentRow,
  {
    progress = null,
    ...change
  }: Omit<Change, "students" | "events" | "progress"> & { progress?: ProgressRecord | null } = {},
): StepResult<T> {
  const view = viewOf({ ...state.row, ...change.row }, student);
  const { student: number } = student;
  return changed(state, value, {
    ...change,
    students: [student],
    ...(progress !== null && {
      progress: [{ student: number, seq: progress.seq, text: JSON.stringify(progress) }],
    }),
    events: [{ type: "student", student: view, progress }],
  });
}

function noChanges(row: ClassRow): ClassChanges {
  return {
    row,
    students: [],
    removed: [],
    progress: [],
    programs: [],
    lesson: null,
    newCodes: [],
    oldCodes: [],
  };
}

/** Two successive changes as one. */
export function mergedChanges(first: ClassChanges | null, second: ClassChanges): ClassChanges {
  if (first === null) return second;
  const isStored = ({ student }: { student: number }): boolean => !second.removed.includes(student);
  const isValid = ({ hash, student }: { hash: string; student: number | null }): boolean =>
    !second.oldCodes.includes(hash) && (student === null || isStored({ student }));
  return {
    row: second.row,
    students: [...first.students.filter(isStored), ...second.students],
    removed: [...first.removed, ...second.removed],
    progress: [...first.progress.filter(isStored), ...second.progress],
    programs: [...first.programs.filter(isStored), ...second.programs],
    lesson: second.lesson ?? first.lesson,
    newCodes: [...first.newCodes.filter(isValid), ...second.newCodes],
    oldCodes: [...first.oldCodes, ...second.oldCodes],
  };
}
