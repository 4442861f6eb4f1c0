/**
 * The groups of students in the results and in the filter of the cards. Both are about one task, so
 * that their numbers agree. Pure.
 */
import type { SeenStudent } from "../../simulator/protocol/classroom-messages.ts";
import { needsHelp, openTask, type Standing } from "./standing.ts";
import type { Verifications } from "./verifier.ts";

/**
 * Every student is in one group. help: asked for it; elsewhere: has another task open, and has not
 * solved this one
 */
export const groups = [
  "solved",
  "driving",
  "writing",
  "paused",
  "bumped",
  "stuck",
  "help",
  "elsewhere",
  "away",
] as const;
export type StudentGroup = (typeof groups)[number];

export const filters = ["all", "help", "working", "solved", "elsewhere", "away"] as const;
export type Filter = (typeof filters)[number];

/** A student in relation to the task of the results. */
export interface GroupedStudent {
  standing: Standing;
  /** whether a solution of the task passes */
  isSolved: boolean;
  /** whether the student has this task open */
  isInTask: boolean;
  isDriving: boolean;
  /** whether the class is paused */
  isPaused: boolean;
}

interface ClassNow {
  shown: ReadonlyMap<number, { standing: Standing }>;
  verifications: Verifications;
  isPaused: boolean;
}

/** @param task of the results */
export function groupedStudent(
  student: SeenStudent,
  task: number,
  { shown, verifications, isPaused }: ClassNow,
): GroupedStudent {
  return {
    standing: shown.get(student.student)?.standing ?? "working",
    isSolved: hasSolved(verifications, student.student, task),
    isInTask: openTask(student) === task,
    isDriving: student.tile?.state === "driving",
    isPaused,
  };
}

/** A student who is expected, but has not joined. */
export const notHere: GroupedStudent = {
  standing: "not-here",
  isSolved: false,
  isInTask: false,
  isDriving: false,
  isPaused: false,
};

/** Whether a solution of the task has passed on this dashboard, whatever the student does now. */
function hasSolved(verifications: Verifications, student: number, task: number): boolean {
  return verifications.get(student)?.get(task)?.kind === "passes";
}

export function groupOf(student: GroupedStudent): StudentGroup {
  const { standing, isSolved, isInTask, isDriving, isPaused } = student;
  if (isSolved) return "solved";
  if (standing === "disconnected" || standing === "not-here") return "away";
  if (!isInTask) return "elsewhere";
  switch (standing) {
    case "help":
    case "stuck":
    case "bumped":
      return standing;
    // The card may show for some seconds that the task before is solved.
    case "solved":
    case "working":
      return isPaused ? "paused" : isDriving ? "driving" : "writing";
  }
}

const working: ReadonlySet<StudentGroup> = new Set(["driving", "writing", "paused", "bumped"]);

/** A student who needs help is in that group in any case, also because of another task. */
export function isIn(filter: Filter, student: GroupedStudent): boolean {
  switch (filter) {
    case "all":
      return true;
    case "help":
      return needsHelp(student.standing);
    case "working":
      return working.has(groupOf(student));
    case "solved":
    case "elsewhere":
    case "away":
      return groupOf(student) === filter;
  }
}
