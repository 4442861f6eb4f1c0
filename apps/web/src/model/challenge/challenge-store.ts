/**
 * The open lesson, if any: its open task, what the page may offer, and the state of the attempt. The
 * lessons, which load on demand, write it; everything else only reads it.
 */
import type {
  FailureCode,
  HelpKind,
  LessonDocument,
  LessonTask,
  Rights,
} from "@corridor/challenge";
import type { Diagnosis } from "@corridor/coach";
import type { DriverName } from "@corridor/protocol";
import { createStore } from "zustand/vanilla";
import type { CheckedTask } from "../check/checked-task.ts";

/** State of the attempt. */
export type ChallengeResult =
  | { state: "open" }
  /**
   * the goal is met in the displayed maze; the other mazes are being checked, or are still to be
   * checked. Unseen mazes are among the others
   */
  | { state: "here"; driver: DriverName; ticks: number; bumps: number; lines: number }
  /**
   * `driver`: who reached it; `ticks` and `bumps` of the run on the screen that met it, otherwise of
   * the check; `lines` of the program, 0 for a hand-driven robot
   */
  | { state: "met"; driver: DriverName; ticks: number; bumps: number; lines: number }
  /** until the robot is reset; "late" and "edited" come from the run alone */
  | { state: "failed"; code: FailureCode | "late" | "edited"; tick: number };

/** A task of a stored lesson. */
export interface TaskPlace {
  /** id of the lesson: its mark */
  lesson: string;
  index: number;
}

export interface ChallengeState {
  /** a mission or a challenge of version 1 is a lesson of one task; null while none is open */
  lesson: LessonDocument | null;
  /** index of the open task */
  index: number;
  /** id of the mission; null for a lesson from a link or a file */
  mission: string | null;
  /** id under which the device stores a lesson of several tasks; null for any other */
  lessonId: string | null;
  /** which tasks of that lesson are solved on this device */
  solved: readonly boolean[];
  /** index of the displayed maze */
  maze: number;
  /** given mazes of the open task in which a hand or a script has met the goal, since it opened */
  drivenMazes: readonly number[];
  /** what the editor may offer; null: everything */
  rights: Rights | null;
  result: ChallengeResult;
  /** result of the newest check of all mazes for the current program; null without one */
  checked: CheckedTask | null;
  /** the same, as the newest verdict; null after a run that failed since */
  verdict: CheckedTask | null;
  /** parallel to the mazes of the verdict: why the program fails there */
  diagnoses: readonly (Diagnosis | null)[];
  /** why the program fails in the unseen maze of the verdict's failure; null without one */
  unseenDiagnosis: Diagnosis | null;
  /** why the displayed run failed; null if it has not, and after a newer check */
  failedRun: Diagnosis | null;
  /** whether the card beside the robot offers the next step, so that nothing else has to */
  hasCard: boolean;
  isChecking: boolean;
  /** the tasks up to this number are open in the class; absent: the lesson decides */
  openTo?: number | undefined;
  /** hints that the teacher shows: how many of a task, by its index */
  hints?: Readonly<Record<number, number>> | undefined;
  /** the same hints, as far as the student has closed them */
  hintsRead?: Readonly<Record<number, number>> | undefined;
  /** whether a first-time user is asked to start with mission 1 */
  isInvited: boolean;
  /** whether the dialog with all missions is open */
  isPathOpen: boolean;
}

export const noChallenge = {
  lesson: null,
  index: 0,
  mission: null,
  lessonId: null,
  solved: [],
  maze: 0,
  drivenMazes: [],
  rights: null,
  result: { state: "open" },
  checked: null,
  verdict: null,
  diagnoses: [],
  unseenDiagnosis: null,
  failedRun: null,
  hasCard: false,
  isChecking: false,
} as const satisfies Partial<ChallengeState>;

export function createChallengeStore() {
  return createStore<ChallengeState>()(() => ({
    ...noChallenge,
    isInvited: false,
    isPathOpen: false,
  }));
}
export type ChallengeStore = ReturnType<typeof createChallengeStore>;

/** The open task; null while none is open. */
export function openTask({
  lesson,
  index,
}: Pick<ChallengeState, "lesson" | "index">): LessonTask | null {
  return lesson?.tasks[index] ?? null;
}

/** Whether the student has not closed the newest hint of the teacher yet. */
export function hasNewHint({
  hints,
  hintsRead,
  index,
}: Pick<ChallengeState, "hints" | "hintsRead" | "index">): boolean {
  return (hints?.[index] ?? 0) > (hintsRead?.[index] ?? 0);
}

/** State of the open task; null while none is open. */
export function challengeResult({ lesson, result }: ChallengeState): ChallengeResult | null {
  return lesson === null ? null : result;
}

/** Number of mazes in which a program must be checked, including the unseen ones. */
export function mazeCount(task: Pick<LessonTask, "mazes" | "unseen"> | null): number {
  return (task?.mazes.length ?? 0) + (task?.unseen?.count ?? 0);
}

/** Index of the next maze to drive through by hand or by a script; null: none, or it needs a program. */
export function nextMazeToDrive(state: ChallengeState): number | null {
  const task = openTask(state);
  const { result, drivenMazes } = state;
  if (task === null || task.unseen !== null) return null;
  if (result.state !== "here" || result.driver === "program") return null;
  const next = task.mazes.findIndex((_, at) => !drivenMazes.includes(at));
  return next < 0 ? null : next;
}

/**
 * Whether the displayed run alone decides: one maze, and a goal that the run can show as reached.
 */
export function isJudgedByRun(task: LessonTask): boolean {
  const { kind } = task.goal;
  return mazeCount(task) === 1 && (kind === "reach" || kind === "stop");
}

/** Whether the page gives a kind of help. Without a task, it gives all. */
export function showsHelp(rights: Rights | null, kind: HelpKind): boolean {
  return rights?.help.has(kind) !== false;
}
