/** Steps of the teacher. Pure: the rules of locks, pauses, pace, codes and removal. */
import { hashKey } from "../platform/keys.ts";
import { Refusal } from "../platform/errors/problems.ts";
import { limits } from "../platform/limits/limits.ts";
import type { StudentRow } from "../store/class-store.ts";
import { pausedMs, type ClassState } from "./class-state.ts";
import { changed, unchanged, type Step } from "./step.ts";

/** Starts a pause, in place of a running one. It ends by the clock. */
export function pauseStep(seconds: number): Step<void> {
  return (state, { now }) =>
    changed(state, undefined, {
      row: {
        pausedMs: pausedMs(state.row, now),
        pause: { startedAt: now, endsAt: now + seconds * 1_000 },
      },
    });
}

export function resumeStep(): Step<void> {
  return (state, { now }) =>
    state.row.pause === null
      ? unchanged(undefined)
      : changed(state, undefined, { row: { pausedMs: pausedMs(state.row, now), pause: null } });
}

export function lockStep(isLocked: boolean): Step<void> {
  return (state) =>
    state.row.isLocked === isLocked
      ? unchanged(undefined)
      : changed(state, undefined, { row: { isLocked } });
}

/** @param to null: all tasks are open */
export function paceStep(to: number | null): Step<void> {
  return (state) =>
    state.row.paceTo === to
      ? unchanged(undefined)
      : changed(state, undefined, { row: { paceTo: to } });
}

export function lessonStep(text: string, version: string): Step<void> {
  return (state) =>
    state.row.lessonVersion === version
      ? unchanged(undefined)
      : changed(state, undefined, { row: { lessonVersion: version }, lesson: text });
}

/** Replaces the code of the class. @returns the new one */
export function newCodeStep(): Step<string> {
  return (state, { mintCode }) => {
    const code = mintCode();
    return changed(state, code, {
      row: { code },
      newCodes: [{ hash: hashKey(code), student: null, endsAt: null }],
      oldCodes: [hashKey(state.row.code)],
    });
  };
}

/** Creates a code by which another device becomes this student, in place of an earlier one. */
export function returnCodeStep(number: number): Step<{ code: string; seconds: number }> {
  return (state, { now, mintCode }) => {
    const student = requireStudent(state, number);
    const code = mintCode();
    const returnCode = { hash: hashKey(code), endsAt: now + limits.returnCodeMs };
    const previous = student.returnCode === null ? [] : [student.returnCode.hash];
    return changed(
      state,
      { code, seconds: limits.returnCodeMs / 1_000 },
      {
        students: [{ ...student, returnCode }],
        newCodes: [{ ...returnCode, student: number }],
        oldCodes: previous,
      },
    );
  };
}

export function removeStep(number: number): Step<void> {
  return (state) => {
    requireStudent(state, number);
    return changed(state, undefined, {
      removed: [number],
      events: [{ type: "removed", student: number }],
    });
  };
}

/** @throws Refusal no-student */
export function requireStudent(state: ClassState, number: number): StudentRow {
  const found = state.students.get(number);
  if (found !== undefined) return found;
  throw new Refusal("no-student", `The class has no student with the number ${number}.`);
}
