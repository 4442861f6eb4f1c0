/** What the card of a student shows. */
import { openTask, openWork } from "../../model/classroom/standing.ts";
import {
  isClassPaused,
  timeOf,
  verificationOf,
  type DashboardState,
} from "../../model/classroom/dashboard.ts";
import type { SeenStudent } from "../../simulator/protocol/classroom-messages.ts";
import type { CardState } from "./StandingChip.tsx";

/** @param student one of the state */
export function cardState(state: DashboardState, student: SeenStudent): CardState {
  const standing = state.shown.get(student.student)?.standing ?? "working";
  const verification = verificationOf(state, student)?.kind;
  const isOpen = standing === "working" || standing === "bumped";
  if (isOpen && verification === "fails") return "unverified";
  if (standing !== "working") return standing;
  if (verification === "checking" || verification === "unchecked") return verification;
  // A robot stands during a pause, and nobody can write.
  if (isClassPaused(state)) return "paused";
  return student.tile?.state === "driving" ? "driving" : "writing";
}

function writtenLines({ programs }: DashboardState, student: SeenStudent): number | null {
  const read = programs.get(student.student);
  return read?.task === openTask(student) ? (read.program?.rules.length ?? null) : null;
}

/** Whole seconds on the open task; 0 for a student who is gone. */
export function cardSeconds(state: DashboardState, number: number): number {
  const student = state.students.get(number);
  return student === undefined ? 0 : Math.floor(timeOf(state, student) / 1_000);
}

/** A picture that is older than this is grey. */
const OLD_SECONDS = 20;

/** The time on the open task. A running time is described by constants, as it changes always. */
export interface CardTime {
  /** whole, of a time that does not run; 0 while it runs */
  minutes: number;
  /** ms since 1970 at which a running time was 0; null: the time does not run */
  startedAt: number | null;
  /** of the minute, of a time that does not run; 0 while it runs */
  seconds: number;
}

export function cardTime(state: DashboardState, student: SeenStudent): CardTime {
  const { classroom, verifications, now } = state;
  const ms = timeOf(state, student);
  const isRunning = timeOf({ classroom, verifications, now: now + 1 }, student) > ms;
  return {
    minutes: isRunning ? 0 : Math.floor(ms / 60_000),
    startedAt: isRunning ? now - ms : null,
    seconds: isRunning ? 0 : Math.floor(ms / 1_000) % 60,
  };
}

interface CardFacts extends CardTime {
  /** of the name: a number, or a text that the teacher pasted */
  word: number | null;
  text: string | null;
  /** number of the open task */
  task: number;
  /** whether the lesson has more than one */
  hasTasks: boolean;
  state: CardState;
  /** of the verified solution, or of the newest program; null: not known */
  lines: number | null;
  attempts: number;
  /** age of the picture; null: it is new */
  awaySeconds: number | null;
}

/** Everything that a card renders; null: the student is gone. */
export function cardFacts(state: DashboardState, number: number): CardFacts | null {
  const student = state.students.get(number);
  if (student === undefined) return null;
  const verification = verificationOf(state, student);
  const since = state.awaySince.get(number) ?? state.lostAt;
  const age = since === null ? 0 : Math.floor((state.now - since) / 1_000);
  return {
    ...student.name,
    task: openTask(student),
    hasTasks: (state.lesson?.tasks.length ?? 1) > 1,
    state: cardState(state, student),
    ...cardTime(state, student),
    lines:
      verification?.kind === "passes" ? verification.claim.lines : writtenLines(state, student),
    attempts: openWork(student)?.attempts ?? 0,
    awaySeconds: age >= OLD_SECONDS ? age : null,
  };
}
