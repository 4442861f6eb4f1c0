/** What is known of an attempt at a task, while it is checked in all mazes and afterwards. */
import {
  countMazes,
  isProgram,
  taskVerdict,
  type Attempt,
  type Failure,
  type FailureCode,
  type LessonTask,
  type MazeOutcome,
} from "@corridor/challenge";

/** Codes of a goal that was missed in the time limit. More time may be enough. */
const timeLimits: ReadonlySet<FailureCode> = new Set([
  "not-reached",
  "not-visited",
  "not-stopped",
  "too-short",
]);

export function isTimeLimit({ code }: Failure): boolean {
  return timeLimits.has(code);
}

export type Verdict =
  /** passes in every maze */
  | "all"
  /** passes the task, but not in every unseen maze */
  | "enough"
  | "fails"
  /** fails only because the time limit was reached */
  | "time-limit"
  | "not-allowed"
  /** not checked in every maze */
  | "open";

/** A maze in which an attempt fails. */
export interface MazeFailure {
  /** see `mazeOf`; null if the task does not allow the attempt */
  maze: number | null;
  failure: Failure;
}

/** An unseen maze in which an attempt passes. */
export interface MazePass {
  /** see `mazeOf` */
  maze: number;
  /** up to the goal */
  ticks: number;
}

export interface AttemptResult {
  verdict: Verdict;
  /** number of mazes in which the attempt passes, of `checked` mazes */
  passed: number;
  checked: number;
  /** number of all mazes of the task */
  mazes: number;
  /** lines of the program, without "otherwise"; null without a program */
  lines: number | null;
  /** ticks in the slowest given maze; null unless the attempt passes in all of them */
  ticks: number | null;
  /** null until all mazes before it are checked */
  first: MazeFailure | null;
}

/** @param outcomes by maze; undefined for a maze that is not checked yet */
export function resultOf(
  task: LessonTask,
  attempt: Attempt,
  violation: Failure | null,
  outcomes: readonly (MazeOutcome | undefined)[],
): AttemptResult {
  const mazes = countMazes(task);
  const lines = isProgram(attempt) ? attempt.rules.length : null;
  const common = { mazes, lines };
  if (violation !== null) {
    const first = { maze: null, failure: violation };
    return { ...common, verdict: "not-allowed", passed: 0, checked: 0, ticks: null, first };
  }
  const known = outcomes.filter((each) => each !== undefined);
  const failed = known.filter(({ failure }) => failure !== null);
  const counts = { passed: known.length - failed.length, checked: known.length };
  const first = firstFailure(outcomes, mazes);
  if (known.length < mazes) return { ...common, ...counts, verdict: "open", ticks: null, first };
  const given = known.slice(0, task.mazes.length);
  const passesGiven = given.every(({ failure }) => failure === null);
  const ticks = passesGiven ? Math.max(...given.map((each) => each.ticks)) : null;
  const isLate = failed.every(({ failure }) => failure !== null && isTimeLimit(failure));
  const verdict = taskVerdict(task, known).passed
    ? failed.length === 0
      ? "all"
      : "enough"
    : isLate
      ? "time-limit"
      : "fails";
  return { ...common, ...counts, verdict, ticks, first };
}

/** Every maze in which an attempt fails, in order. */
export function failuresOf(outcomes: readonly (MazeOutcome | undefined)[]): MazeFailure[] {
  const found: MazeFailure[] = [];
  for (const [maze, outcome] of outcomes.entries()) {
    if (outcome !== undefined && outcome.failure !== null) {
      found.push({ maze, failure: outcome.failure });
    }
  }
  return found;
}

/**
 * Every unseen maze in which an attempt passes, in order.
 * @param given number of given mazes, which come first
 */
export function unseenPasses(
  outcomes: readonly (MazeOutcome | undefined)[],
  given: number,
): MazePass[] {
  const found: MazePass[] = [];
  for (const [maze, outcome] of outcomes.entries()) {
    if (maze < given || outcome === undefined || outcome.failure !== null) continue;
    found.push({ maze, ticks: outcome.ticks });
  }
  return found;
}

function firstFailure(
  outcomes: readonly (MazeOutcome | undefined)[],
  mazes: number,
): MazeFailure | null {
  for (let maze = 0; maze < mazes; maze++) {
    const outcome = outcomes[maze];
    if (outcome === undefined) return null;
    if (outcome.failure !== null) return { maze, failure: outcome.failure };
  }
  return null;
}
