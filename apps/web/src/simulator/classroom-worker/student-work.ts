/** What a student has done, from the stored progress records. Pure. */
import type { ProgressRecord } from "@corridor/protocol";
import type {
  CountedBump,
  CountedFailure,
  RecentAttempt,
  SeenStudent,
  TaskWork,
} from "../protocol/classroom-messages.ts";

/** More claims of one task are not run again. */
const MAX_CLAIMS = 20;
const MAX_FAILURES = 12;
const MAX_RECENT = 12;

/** What belongs to a lesson: tasks of two lessons have equal numbers, and questions equal ids. */
type LessonWork = Pick<SeenStudent, "tasks" | "answers">;

const noLessonWork: LessonWork = { tasks: [], answers: null };

type SeenWork = "busyAt" | "bestAt" | "repeats" | "tasks" | "recent" | "answers";

export type Work = Pick<SeenStudent, SeenWork> & {
  /** the failure that `repeats` counts; null: the newest attempt did not fail */
  failure: Pick<CountedFailure, "code" | "line"> | null;
  /** the largest number of mazes that passed in a check of the open task */
  best: number;
  /** mark of the open lesson; null: none opened yet */
  lesson: string | null;
  /** the work in lessons that were open before, by their marks */
  earlier: ReadonlyMap<string, LessonWork>;
  /** where the robot bumped, in all lessons */
  bumped: readonly PlacedBumps[];
};

/** The bumps of a student in one cell of a lesson. */
export interface PlacedBumps extends CountedBump {
  /** its mark; null: before the first one was opened */
  lesson: string | null;
}

/** Equal for all students without bumps. */
export const noBumps: readonly PlacedBumps[] = [];

/** @param joinedAt active time at which the student joined */
export function noWork(joinedAt: number): Work {
  return {
    busyAt: joinedAt,
    bestAt: joinedAt,
    repeats: 0,
    tasks: [],
    recent: [],
    answers: null,
    failure: null,
    best: 0,
    lesson: null,
    earlier: new Map(),
    bumped: noBumps,
  };
}

/** Starts the counts of the open task again. @param at active time */
export function withRestart(work: Work, at: number): Work {
  return { ...work, busyAt: at, bestAt: at, best: 0, repeats: 0, failure: null };
}

/** Adds the next record. */
export function withRecord(work: Work, { event, activeMs: at, seq }: ProgressRecord): Work {
  switch (event.kind) {
    case "opened": {
      const inLesson = withLesson(work, event.lesson);
      const { openedAt } = taskOf(inLesson, event.task);
      return withRestart(withTask(inLesson, event.task, { openedAt: openedAt ?? at }), at);
    }
    case "run":
    case "check":
      return withAttempt(work, event, { seq, at });
    case "hint": {
      const { hints } = taskOf(work, event.task);
      // A hint comes with all hints before it, and can be shown again.
      return withTask(work, event.task, { hints: Math.max(hints, event.hint) });
    }
    case "solved": {
      const { claims, attempts, openedAt } = taskOf(work, event.task);
      const { code, lines } = event;
      const isKnown = claims.length >= MAX_CLAIMS || claims.some((each) => each.code === code);
      const claim = { code, lines, attempts, activeAt: at };
      const change = {
        claims: isKnown ? claims : [...claims, claim],
        openedAt: openedAt ?? at,
      };
      // The solution ends a row of failures.
      const ended = { busyAt: at, bestAt: at, repeats: 0, failure: null };
      return { ...withTask(work, event.task, change), ...ended };
    }
    case "survey":
      return {
        ...work,
        answers: Object.fromEntries(event.answers.map(({ id, answer }) => [id, answer])),
      };
  }
}

/** Opens a lesson, with the work that it has from before. */
function withLesson(work: Work, lesson: string): Work {
  if (work.lesson === lesson) return work;
  // Work before the first opening belongs to the lesson that opens.
  if (work.lesson === null) {
    const bumped = work.bumped.map((each) => ({ ...each, lesson }));
    return { ...work, lesson, bumped: bumped.length === 0 ? noBumps : bumped };
  }
  const { tasks, answers } = work;
  const earlier = new Map(work.earlier).set(work.lesson, { tasks, answers });
  return { ...workIn({ ...work, earlier }, lesson), lesson };
}

/**
 * The work in a lesson, which the student may not have open. Work before the first opening belongs
 * to any lesson.
 * @param lesson its mark; null: the open one
 */
export function workIn(work: Work, lesson: string | null): Work {
  if (lesson === null || work.lesson === null || work.lesson === lesson) return work;
  return { ...work, recent: [], ...(work.earlier.get(lesson) ?? noLessonWork) };
}

type AttemptEvent = Extract<ProgressRecord["event"], { kind: "run" | "check" }>;

function withAttempt(
  work: Work,
  event: AttemptEvent,
  { seq, at }: Pick<RecentAttempt, "seq" | "at">,
): Work {
  const before = taskOf(work, event.task);
  const { failure } = event;
  const isBest = event.kind === "check" && event.passes > work.best;
  const next = withTask(work, event.task, {
    openedAt: before.openedAt ?? at,
    attempts: before.attempts + (event.changed ? 1 : 0),
    failures: failure === null ? before.failures : withFailure(before.failures, failure),
    ...(event.kind === "run"
      ? {
          runs: before.runs + 1,
          bumps: before.bumps + event.bumps,
          mistakes: before.mistakes + event.mistakes,
        }
      : { failedChecks: before.failedChecks + (failure === null ? 0 : 1) }),
  });
  const isSame = failure !== null && isSameFailure(failure, work.failure);
  // The same program again is the same attempt.
  const counted = event.changed ? 1 : 0;
  const repeats = failure === null ? 0 : isSame ? work.repeats + counted : 1;
  const places = event.bumpPlaces ?? [];
  const check = event.kind === "check" ? { passes: event.passes, mazes: event.mazes } : null;
  const recent = { seq, task: event.task, at, check, failure };
  return {
    ...next,
    recent: [recent, ...work.recent].slice(0, MAX_RECENT),
    busyAt: at,
    bumped: places.reduce(
      (bumped, place) => withBump(bumped, { lesson: work.lesson, task: event.task, ...place }),
      work.bumped,
    ),
    ...(isBest && event.kind === "check" && { best: event.passes, bestAt: at }),
    repeats,
    failure,
  };
}

function withBump(
  bumped: readonly PlacedBumps[],
  place: Omit<PlacedBumps, "count">,
): readonly PlacedBumps[] {
  const isSame = (each: PlacedBumps): boolean =>
    each.lesson === place.lesson &&
    each.task === place.task &&
    each.maze === place.maze &&
    each.column === place.column &&
    each.row === place.row;
  const count = bumped.find(isSame)?.count ?? 0;
  return [...bumped.filter((each) => !isSame(each)), { ...place, count: count + 1 }];
}

/** The work on a task, which may not have begun. */
export function taskOf({ tasks }: Pick<Work, "tasks">, task: number): TaskWork {
  return tasks.find((each) => each.task === task) ?? emptyTask(task);
}

/** A task in which nothing has happened. */
export function emptyTask(task: number): TaskWork {
  return {
    task,
    openedAt: null,
    claims: [],
    attempts: 0,
    runs: 0,
    bumps: 0,
    failedChecks: 0,
    hints: 0,
    mistakes: 0,
    failures: [],
  };
}

/** Changes the work on a task. */
export function withTask(work: Work, task: number, change: Partial<TaskWork>): Work {
  const next = { ...taskOf(work, task), ...change };
  const others = work.tasks.filter((each) => each.task !== task);
  return { ...work, tasks: [...others, next].toSorted((a, b) => a.task - b.task) };
}

function withFailure(
  failures: readonly CountedFailure[],
  { code, line }: Pick<CountedFailure, "code" | "line">,
): CountedFailure[] {
  const known = failures.find((each) => isSameFailure(each, { code, line }));
  const others = failures.filter((each) => each !== known);
  const counted = { code, line, count: (known?.count ?? 0) + 1 };
  return [...others, counted].toSorted((a, b) => b.count - a.count).slice(0, MAX_FAILURES);
}

function isSameFailure(
  one: Pick<CountedFailure, "code" | "line">,
  other: Pick<CountedFailure, "code" | "line"> | null,
): boolean {
  return other !== null && one.code === other.code && one.line === other.line;
}
