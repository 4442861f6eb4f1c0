/**
 * Messages between the page of a teacher's dashboard and its worker, which holds the connection to
 * the class and draws the cards. Times with "active" in their name are ms since the class was
 * created, without its pauses, by the relay's clock.
 */
import type { LessonDocument } from "@corridor/challenge";
import type { ClassSettings, ScreenNumbers, StudentName, Tile } from "@corridor/protocol";
import type { Palette } from "../../stage/drawing/palette.ts";

/** The class, and a teacher's key. */
export interface Classroom {
  id: string;
  key: string;
}

/** A solution that a student's page reports. It counts once the dashboard has run it. */
export interface ClaimedSolution {
  /** completion code; null: the drive has none, so nobody can check it */
  code: string | null;
  activeAt: number;
  /** of the program; null: the commands of a drive */
  lines: number | null;
  /** attempts until then */
  attempts: number;
}

/** The work of a student on a task. */
export interface TaskWork {
  task: number;
  /** null: not opened yet */
  openedAt: number | null;
  claims: readonly ClaimedSolution[];
  /** first runs or checks of a changed program */
  attempts: number;
  runs: number;
  bumps: number;
  failedChecks: number;
  hints: number;
  /** mistakes that the diagnosis found */
  mistakes: number;
  /** attempts by why they failed, most frequent first */
  failures: readonly CountedFailure[];
}

export interface CountedFailure {
  /** as the check names it */
  code: string;
  /** null: no line caused it */
  line: number | "default" | null;
  count: number;
}

/** A run or a check of a student. */
export interface RecentAttempt {
  /** number of its record */
  seq: number;
  task: number;
  /** active time at which its record arrived */
  at: number;
  /** number of mazes that passed, and of all mazes; null: a run */
  check: { passes: number; mazes: number } | null;
  /** null: it did not fail */
  failure: Pick<CountedFailure, "code" | "line"> | null;
}

/** A student as the dashboard sees it. */
export interface SeenStudent {
  student: number;
  name: StudentName;
  /** ms since 1970, by the relay's clock */
  helpSince: number | null;
  /** number of stored programs */
  programs: number;
  isConnected: boolean;
  /** the newest one, without what only the picture needs; null: none yet */
  tile: Pick<Tile, "task" | "state" | "line"> | null;
  /** the last edit, or the last time the robot drove; up to 5 s old while it drives on */
  busyAt: number;
  /** the last new best result, or the opening of the task or the lesson */
  bestAt: number;
  /** number of newest attempts in a row that failed with the same code and line */
  repeats: number;
  tasks: readonly TaskWork[];
  /** the newest attempts of the student whom the teacher watches, newest first; else empty */
  recent: readonly RecentAttempt[];
  /** to the survey, by the ids of the questions; null: not answered */
  answers: Readonly<Record<string, number | null>> | null;
}

export type ClassroomStatus =
  | { kind: "connecting" | "connected" | "lost" }
  /** over: the class has ended; refused: the key is not valid */
  | { kind: "over" | "refused" };

/** The time of the class, on the clock of this device. */
export interface ClassTime {
  /** a moment, in ms since 1970, and the active time then */
  at: number;
  activeMs: number;
  /** ms since 1970; null: not paused */
  pauseEndsAt: number | null;
  /** ms that this clock is ahead of the relay's */
  ahead: number;
}

export interface ClassroomState {
  settings: Pick<ClassSettings, "code" | "locked" | "paceTo">;
  expected: number | null;
  /** ms since 1970, on the clock of this device */
  createdAt: number;
  time: ClassTime;
}

/** The place of a student's picture on a canvas, in device pixels. */
export interface PictureBox {
  student: number;
  x: number;
  y: number;
  width: number;
  height: number;
  /** out of date: grey */
  isOld: boolean;
}

/** What the big screens show. */
export interface ScreenUpdate {
  numbers: ScreenNumbers;
  /** whose run they show; null: none */
  student: number | null;
  /** of that student, as a link text; null: not known */
  program: string | null;
  /** see `ScreenPriority` */
  priority: number;
}

export type ToClassroom =
  | { type: "open"; room: Classroom }
  /** reconnects at once */
  | { type: "again" }
  /** receives the tiles of a student more often; null: of nobody */
  | { type: "watch"; student: number | null }
  | { type: "hint"; student: number; task: number; hint: number }
  /** replaces what the big screens show */
  | ({ type: "screens" } & ScreenUpdate)
  | { type: "colours"; palette: Palette }
  /** whether robots jump from tile to tile instead of moving */
  | { type: "calm"; isCalm: boolean }
  /** a canvas for pictures of students */
  | { type: "canvas"; place: string; canvas: OffscreenCanvas }
  /** its size in device pixels, and all pictures on it */
  | {
      type: "pictures";
      place: string;
      width: number;
      height: number;
      pictures: readonly PictureBox[];
    }
  | { type: "canvas-gone"; place: string }
  /** the path of a student whose solution passes is green */
  | { type: "verified"; student: number; tasks: readonly number[] };

/** How often robots bumped in a cell. */
export interface CountedBump {
  task: number;
  maze: string;
  column: number;
  row: number;
  count: number;
}

export type FromClassroom =
  | { type: "status"; status: ClassroomStatus }
  | { type: "state"; state: ClassroomState }
  | { type: "lesson"; lesson: LessonDocument; version: string }
  | { type: "students"; changed: readonly SeenStudent[]; removed: readonly number[] }
  | { type: "bumps"; bumps: readonly CountedBump[] }
  /** priority of what the big screens show; null: nothing, or of a dashboard that has closed */
  | { type: "displayed"; priority: number | null };
