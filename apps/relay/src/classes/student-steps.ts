/** Steps of a student. Pure: the rules of joining, names, progress, programs and help. */
import {
  MAX_RENAMES,
  MAX_STUDENTS,
  NAME_WORDS,
  type Progress,
  type ProgressRecord,
  type StudentName,
} from "@corridor/protocol";
import { hashKey } from "../platform/keys.ts";
import { notAuthorised, Refusal } from "../platform/errors/problems.ts";
import type { ClassRow, StudentRow } from "../store/class-store.ts";
import { activeMs, isoTime, nameOf, type ClassState } from "./class-state.ts";
import { studentChanged, unchanged, type Step, type StepContext } from "./step.ts";

export interface Joined {
  student: number;
  name: StudentName;
}

/**
 * Admits a new student, and locks the class if as many have joined as expected.
 * @param key hash of the student's key
 * @param code hash of the class's code, which the teacher may have replaced meanwhile
 */
export function joinStep(key: string, code: string): Step<Joined> {
  return (state, context) => {
    const { row, students } = state;
    if (hashKey(row.code) !== code) throw wrongCode();
    if (row.isLocked) throw classLocked();
    const name = freeName(state, context);
    if (students.size >= MAX_STUDENTS || name === null) throw classFull(students.size);
    const student: StudentRow = {
      student: row.lastStudent + 1,
      name,
      renamesLeft: MAX_RENAMES,
      key,
      joinedAt: context.now,
      helpSince: null,
      progress: 0,
      programs: 0,
      returnCode: null,
    };
    const isLocked = students.size + 1 === row.expected;
    const joined = { student: student.student, name: nameOf(row, student) };
    return studentChanged(state, joined, student, {
      row: { lastStudent: student.student, ...(isLocked && { isLocked }) },
    });
  };
}

/**
 * Makes another device the student. The code and the previous key are invalid from then on.
 * @param code hash of the return code
 */
export function returnStep(number: number, key: string, code: string): Step<Joined> {
  return (state, { now }) => {
    const student = state.students.get(number);
    const known = student?.returnCode ?? null;
    const isValid = known?.hash === code && known.endsAt > now;
    if (student === undefined || !isValid) throw wrongCode();
    const joined = { student: number, name: nameOf(state.row, student) };
    const next = { ...student, key, returnCode: null };
    return studentChanged(state, joined, next, { oldCodes: [code] });
  };
}

/** Changes the name, at most twice. */
export function renameStep(caller: StudentCaller): Step<void> {
  return (state, context) => {
    const student = requireCaller(state, caller);
    if (student.renamesLeft === 0) throw noOtherName("You have changed your name twice.");
    const name = freeName(state, context);
    if (name === null) throw noOtherName("All names are in use.");
    const renamesLeft = student.renamesLeft - 1;
    return studentChanged(state, undefined, { ...student, name, renamesLeft });
  };
}

/** Stores a progress record. A repeated one changes nothing. */
export function progressStep(caller: StudentCaller, seq: number, event: Progress): Step<void> {
  return (state, { now }) => {
    const student = requireCaller(state, caller);
    if (seq <= student.progress) return unchanged(undefined);
    if (seq !== student.progress + 1) throw missingProgress(student.progress + 1);
    const at = isoTime(now);
    const progress: ProgressRecord = { seq, at, activeMs: activeMs(state.row, now), event };
    return studentChanged(state, undefined, { ...student, progress: seq }, { progress });
  };
}

/** Stores a program in place of the previous one. */
export function programStep(caller: StudentCaller, task: number, link: string): Step<void> {
  return (state, { now }) => {
    const student = requireCaller(state, caller);
    const text = JSON.stringify({ task, link, storedAt: isoTime(now) });
    const programs = [{ student: student.student, text }];
    const next = { ...student, programs: student.programs + 1 };
    return studentChanged(state, undefined, next, { programs });
  };
}

export function helpStep(caller: StudentCaller, isWanted: boolean): Step<void> {
  return (state, { now }) => {
    const student = requireCaller(state, caller);
    if ((student.helpSince !== null) === isWanted) return unchanged(undefined);
    return studentChanged(state, undefined, { ...student, helpSince: isWanted ? now : null });
  };
}

/** A student by number and hash of the key, which a return to another device replaces. */
export interface StudentCaller {
  student: number;
  key: string;
}

/** @throws Refusal not-authorised if the student was removed or has returned on another device */
export function requireCaller(state: ClassState, { student, key }: StudentCaller): StudentRow {
  const found = state.students.get(student);
  if (found?.key === key) return found;
  throw notAuthorised("The student was removed, or continues on another device.");
}

/** Index of a random name that no student has; null if there is none. */
function freeName({ row, students }: ClassState, { random }: StepContext): number | null {
  const used = new Set([...students.values()].map(({ name }) => name));
  const free = Array.from({ length: nameCount(row) }, (_, at) => at).filter((at) => !used.has(at));
  return free[random(free.length)] ?? null;
}

function nameCount({ names }: ClassRow): number {
  return names?.length ?? NAME_WORDS;
}

export function wrongCode(): Refusal {
  return new Refusal(
    "no-class",
    "No class has this code. Check each letter, or ask the teacher for the current code.",
  );
}

function classLocked(): Refusal {
  return new Refusal(
    "class-locked",
    "The teacher has locked the class. Ask the teacher to unlock it, or for a return code.",
  );
}

/** @param size number of students */
function classFull(size: number): Refusal {
  const expected = `fewer than ${size}`;
  return new Refusal("class-full", "The class has no free place. Ask the teacher.", {
    errors: [{ path: "students", found: String(size), expected }],
  });
}

function noOtherName(why: string): Refusal {
  return new Refusal("no-other-name", `${why} You keep your name.`);
}

function missingProgress(next: number): Refusal {
  const found = "a later number";
  return new Refusal("bad-request", `Progress is missing. Send the record ${next} next.`, {
    errors: [{ path: "seq", found, expected: String(next) }],
  });
}
