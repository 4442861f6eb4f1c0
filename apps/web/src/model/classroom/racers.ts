/** The programs that can race: those that the teacher's page has verified. Pure. */
import { isProgram, type LessonDocument, type LessonTask } from "@corridor/challenge";
import { MAX_RACERS, type Racer } from "@corridor/protocol";
import type { Verifications } from "./verifier.ts";

/** Characters of all codes: a message to the big screens has at most 64 KiB. */
const MAX_CODES = 32_768;
/** Unseen mazes among which the teacher chooses. */
const MAX_UNSEEN = 10;

export interface RaceField {
  racers: Racer[];
  /** students whose programs have no room in the race */
  missing: number[];
}

/**
 * The programs that solve a task, without names. Students with the same program share a robot. Most
 * frequent programs come first; those beyond the limits do not race.
 */
export function raceField(task: number, verifications: Verifications): RaceField {
  const students = new Map<string, number[]>();
  for (const [student, tasks] of verifications) {
    const found = tasks.get(task);
    if (found?.kind !== "passes" || !isProgram(found.attempt)) continue;
    const { code } = found.claim;
    students.set(code, [...(students.get(code) ?? []), student]);
  }
  const racers: Racer[] = [];
  const missing: number[] = [];
  let left = MAX_CODES;
  // The order of the codes contains nothing about students.
  const sorted = [...students].toSorted(
    ([a, { length }], [b, other]) => other.length - length || (a < b ? -1 : 1),
  );
  for (const [code, found] of sorted) {
    if (racers.length === MAX_RACERS || code.length > left) {
      missing.push(...found);
      continue;
    }
    left -= code.length;
    racers.push({ code, count: found.length });
  }
  return { racers, missing };
}

/** Names the mazes in which a task can race, as in tiles: the given ones, and some unseen ones. */
export function raceMazes({ mazes, unseen }: Pick<LessonTask, "mazes" | "unseen">): string[] {
  return [
    ...mazes.map((_, at) => `g${at + 1}`),
    ...Array.from({ length: Math.min(unseen?.count ?? 0, MAX_UNSEEN) }, (_, at) => `u${at + 1}`),
  ];
}

/** The maze that the teacher has chosen for the race of a task. */
export interface RaceChoice {
  /** from 1 */
  task: number;
  /** as in tiles */
  maze: string;
}

/** The chosen maze if the task has it, else its first one. */
export function chosenMaze(
  lesson: LessonDocument,
  task: number,
  choice: RaceChoice | null,
): string {
  const found = lesson.tasks[task - 1];
  const isFound =
    choice?.task === task && found !== undefined && raceMazes(found).includes(choice.maze);
  return isFound ? choice.maze : "g1";
}

/** Number of students whose programs race. */
export function countRacers(racers: readonly Pick<Racer, "count">[]): number {
  return racers.reduce((sum, { count }) => sum + count, 0);
}
