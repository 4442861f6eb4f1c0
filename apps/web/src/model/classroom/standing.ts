/** What the teacher needs to know of a student first, and since when. Pure. */
import type { SeenStudent, TaskWork } from "../../simulator/protocol/classroom-messages.ts";

/** In the order in which they need the teacher. */
export const standings = [
  "help",
  "stuck",
  "bumped",
  "working",
  "disconnected",
  "solved",
  "not-here",
] as const;
/** help: asked for it; not-here: expected, but not joined */
export type Standing = (typeof standings)[number];

export interface StandingSince {
  standing: Standing;
  /** active time at which it began, in ms */
  since: number;
  /** number of the task in which it began */
  task: number;
}

/** Failed attempts in a row with the same line and failure. */
const STUCK_REPEATS = 4;
/** Without an edit or a run, in active ms. */
const IDLE_MS = 180_000;
/** Without a new best result, in active ms. */
const NO_BEST_MS = 480_000;
/** A standing lasts at least this long. */
const LEAST_MS = 20_000;
/** Those that appear at once: the teacher can act on them, or the student is done. */
const immediate: ReadonlySet<Standing> = new Set(["help", "solved"]);

/** A student, and which tasks this dashboard has verified. */
export interface JudgedStudent {
  student: Pick<
    SeenStudent,
    "helpSince" | "isConnected" | "tile" | "busyAt" | "bestAt" | "repeats"
  >;
  /** number of the open task */
  task: number;
  /** whether a solution of the open task passes */
  isSolved: boolean;
}

/** The number of the task that a student has open. */
export function openTask({ tile, tasks }: Pick<SeenStudent, "tile" | "tasks">): number {
  if (tile !== null) return tile.task;
  const opened = tasks.filter(({ openedAt }) => openedAt !== null);
  return opened.toSorted((a, b) => (b.openedAt ?? 0) - (a.openedAt ?? 0))[0]?.task ?? 1;
}

/** The work on the open task; undefined before it was opened. */
export function openWork(student: Pick<SeenStudent, "tile" | "tasks">): TaskWork | undefined {
  const task = openTask(student);
  return student.tasks.find((each) => each.task === task);
}

/**
 * The standing of a student now, and since when as far as it is known.
 * @param now active time
 * @param helpAt active time at which the student asked for help
 */
export function standingOf(
  { student, task, isSolved }: JudgedStudent,
  now: number,
  helpAt: number,
): StandingSince {
  const { helpSince, isConnected, tile, busyAt, bestAt } = student;
  if (helpSince !== null) return { standing: "help", since: helpAt, task };
  if (isSolved) return { standing: "solved", since: bestAt, task };
  if (!isConnected) return { standing: "disconnected", since: now, task };
  const stuck = stuckSince(student, now);
  if (stuck !== null) return { standing: "stuck", since: stuck, task };
  if (tile?.state === "bumped") return { standing: "bumped", since: now, task };
  return { standing: "working", since: Math.min(now, busyAt), task };
}

/** The earliest of the times at which a rule applied; null if none applies. */
function stuckSince(
  { busyAt, bestAt, repeats }: JudgedStudent["student"],
  now: number,
): number | null {
  const since = [
    ...(repeats >= STUCK_REPEATS ? [busyAt] : []),
    ...(now - busyAt >= IDLE_MS ? [busyAt + IDLE_MS] : []),
    ...(now - bestAt >= NO_BEST_MS ? [bestAt + NO_BEST_MS] : []),
  ];
  return since.length === 0 ? null : Math.min(...since);
}

/** A standing as the card shows it. */
export interface ShownStanding extends StandingSince {
  /** when the card began to show it, in ms by any clock that does not stop in a pause */
  shownAt: number;
}

/**
 * The standing to show: a more urgent one at once, any other after the one before it was shown for
 * 20 s. So a card does not change while the teacher looks at it. In another task, it begins at once.
 * @param now ms by the clock of `shownAt`
 */
export function settle(
  before: ShownStanding | null,
  next: StandingSince,
  now: number,
): ShownStanding {
  if (before === null || before.task !== next.task) return { ...next, shownAt: now };
  if (before.standing === next.standing) return before;
  const isMoreUrgent = rank(next.standing) < rank(before.standing);
  const isOld = now - before.shownAt >= LEAST_MS;
  return isMoreUrgent || isOld || immediate.has(next.standing) ? { ...next, shownAt: now } : before;
}

export function rank(standing: Standing): number {
  return standings.indexOf(standing);
}

/** Whether the teacher should go to this student. */
export function needsHelp(standing: Standing): boolean {
  return standing === "help" || standing === "stuck";
}
