/** Steps by which students join a class and return to it. Pure: the rules of codes and names. */
import { MAX_RENAMES, MAX_STUDENTS, NAME_WORDS, type StudentName } from "@corridor/protocol";
import { hashKey } from "../platform/keys.ts";
import { Refusal } from "../platform/errors/problems.ts";
import type { ClassRow, StudentRow } from "../store/class-store.ts";
import { nameOf, type ClassState } from "./class-state.ts";
import { studentChanged, type Step, type StepContext } from "./step.ts";

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
    if (students.size >= MAX_STUDENTS || name === null) throw classFull();
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

function classFull(): Refusal {
  return new Refusal("class-full", "The class has no free place. Ask the teacher.");
}
