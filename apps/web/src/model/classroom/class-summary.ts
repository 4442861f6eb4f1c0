/** The numbers above the cards, of one task. Pure. */
import type { SeenStudent } from "../../simulator/protocol/classroom-messages.ts";
import type { Standing } from "./standing.ts";
import { groupedStudent, groupOf, type StudentGroup } from "./student-group.ts";
import type { Verifications } from "./verifier.ts";

export interface Bar {
  /** upper end of the bar: minutes, lines or attempts */
  value: number;
  count: number;
  /** whether the last bar also has all larger values */
  isOpen: boolean;
}

/** A value that `count` of `all` have. */
export interface CommonValue {
  value: number;
  count: number;
  all: number;
}

export interface ClassSummary {
  /** students with a verified solution */
  solved: number;
  /** expected students, or those who have joined if they are more */
  all: number;
  /** number of students in each group; those who have not joined are not here */
  groups: Record<StudentGroup, number>;
  /** ms; null: nobody has solved the task */
  medianMs: number | null;
  times: Bar[];
  /** the most common number of lines; null: no solution with a program */
  commonLines: CommonValue | null;
  lines: Bar[];
  /** null: no attempts */
  medianAttempts: number | null;
  attempts: Bar[];
}

const MAX_BARS = 8;
const MINUTE_MS = 60_000;
const nobody: Record<StudentGroup, number> = {
  solved: 0,
  driving: 0,
  writing: 0,
  paused: 0,
  bumped: 0,
  stuck: 0,
  help: 0,
  elsewhere: 0,
  away: 0,
};

export function summaryOf(
  task: number,
  students: ReadonlyMap<number, SeenStudent>,
  shown: ReadonlyMap<number, { standing: Standing }>,
  verifications: Verifications,
  { expected, isPaused }: { expected: number | null; isPaused: boolean },
): ClassSummary {
  const solutions = [...students.values()].flatMap(({ student, tasks }) => {
    const found = verifications.get(student)?.get(task);
    const work = tasks.find((each) => each.task === task);
    return found?.kind === "passes" ? [{ claim: found.claim, openedAt: work?.openedAt ?? 0 }] : [];
  });
  const all = Math.max(expected ?? 0, students.size);
  const groups = { ...nobody, away: all - students.size };
  for (const student of students.values()) {
    groups[groupOf(groupedStudent(student, task, { shown, verifications, isPaused }))]++;
  }
  const times = solutions.map(({ claim, openedAt }) => Math.max(0, claim.activeAt - openedAt));
  const lines = solutions.flatMap(({ claim }) => claim.lines ?? []);
  const attempts = [...students.values()].flatMap(({ tasks }) => {
    const work = tasks.find((each) => each.task === task);
    return work === undefined || work.attempts === 0 ? [] : [work.attempts];
  });
  return {
    solved: groups.solved,
    all,
    groups,
    medianMs: median(times),
    times: barsOf(times.map((ms) => Math.max(1, Math.ceil(ms / MINUTE_MS)))),
    commonLines: mostCommon(lines),
    lines: barsOf(lines),
    medianAttempts: median(attempts),
    attempts: barsOf(attempts),
  };
}

/** null for an empty list */
export function median(values: readonly number[]): number | null {
  const sorted = values.toSorted((a, b) => a - b);
  const middle = Math.floor(sorted.length / 2);
  const upper = sorted[middle];
  if (upper === undefined) return null;
  return sorted.length % 2 === 1 ? upper : ((sorted[middle - 1] ?? upper) + upper) / 2;
}

/** The smallest of the most common values; null for an empty list. */
export function mostCommon(values: readonly number[]): CommonValue | null {
  let best: CommonValue | null = null;
  for (const value of new Set(values.toSorted((a, b) => a - b))) {
    const count = values.filter((each) => each === value).length;
    if (count > (best?.count ?? 0)) best = { value, count, all: values.length };
  }
  return best;
}

/** A bar for each whole number from the smallest to the largest value, at most 8. */
export function barsOf(values: readonly number[]): Bar[] {
  if (values.length === 0) return [];
  const first = Math.min(...values);
  const last = Math.max(...values);
  const length = Math.min(MAX_BARS, last - first + 1);
  return Array.from({ length }, (_, at) => {
    const value = first + at;
    const isOpen = at === MAX_BARS - 1 && last > value;
    const isIn = (each: number): boolean => each === value || (isOpen && each > value);
    return { value, count: values.filter(isIn).length, isOpen };
  });
}
