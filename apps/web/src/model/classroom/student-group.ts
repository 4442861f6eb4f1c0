/**
 * The groups of students in the results and in the filter of the cards. Both are about one task, so
 * that their numbers agree. Pure.
 */
import { needsHelp, type Standing } from "./standing.ts";
import type { Verifications } from "./verifier.ts";

/** Every student is in one group. */
export type StudentGroup = "solved" | "needHelp" | "bumped" | "working" | "away";

export const filters = ["all", "help", "working", "solved", "away"] as const;
export type Filter = (typeof filters)[number];

/** Whether a solution of the task has passed on this dashboard, whatever the student does now. */
export function hasSolved(verifications: Verifications, student: number, task: number): boolean {
  return verifications.get(student)?.get(task)?.kind === "passes";
}

/** @param isSolved whether the student has solved the task of the results */
export function groupOf(standing: Standing, isSolved: boolean): StudentGroup {
  if (isSolved) return "solved";
  switch (standing) {
    case "help":
    case "stuck":
      return "needHelp";
    case "bumped":
      return "bumped";
    // In another task, which is solved.
    case "solved":
    case "working":
      return "working";
    case "disconnected":
    case "not-here":
      return "away";
  }
}

/** A student who needs help is in that group in any case, also because of a later task. */
export function isIn(filter: Filter, standing: Standing, isSolved: boolean): boolean {
  const group = groupOf(standing, isSolved);
  switch (filter) {
    case "all":
      return true;
    case "help":
      return needsHelp(standing);
    case "working":
      return group === "working" || group === "bumped";
    case "solved":
    case "away":
      return group === filter;
  }
}
