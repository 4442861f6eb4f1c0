/**
 * The challenge that is open, if any: what it leaves to the editor and how the attempt stands. Filled
 * by the lessons, which come in a file of their own; everything else only reads it.
 */
import type { ChallengeDocument, FailureCode, Rights, Verdict } from "@corridor/challenge";
import type { Diagnosis } from "@corridor/coach";
import type { DriverName } from "@corridor/protocol";
import { createStore } from "zustand/vanilla";

/** How the attempt on the screen stands. */
export type ChallengeResult =
  | { state: "open" }
  /** the goal is met in the maze that is shown; what it takes beyond that is being checked, or is to be */
  | { state: "here"; ticks: number; bumps: number; lines: number }
  /** `driver`: who did it; lines of the program, 0 for a hand */
  | { state: "met"; driver: DriverName; ticks: number; bumps: number; lines: number }
  /** until the robot is put back to its start; "late" and "edited" come from the run alone */
  | { state: "failed"; code: FailureCode | "late" | "edited"; tick: number };

export interface ChallengeState {
  /** null while none is open */
  challenge: ChallengeDocument | null;
  /** id of the mission whose challenge it is; null for one that came by a link */
  mission: string | null;
  /** index of the maze that is shown */
  maze: number;
  /** what the editor may offer; null: everything */
  rights: Rights | null;
  result: ChallengeResult;
  /** what the newest check of all mazes said of the program as it is; null when there was none */
  verdict: Verdict | null;
  /** beside the verdict, for each maze: why the program fails there */
  diagnoses: readonly (Diagnosis | null)[];
  /** why the run on the screen failed; null while it has not, and once a check says something newer */
  failedRun: Diagnosis | null;
  /** whether the card beside the robot offers the way on, so that nothing else has to */
  isCardShown: boolean;
  isChecking: boolean;
  /** a reader who has never been here is asked whether to begin with mission 1 */
  isInvited: boolean;
  /** whether the dialog with all missions is open */
  isPathOpen: boolean;
}

export const noChallenge = {
  challenge: null,
  mission: null,
  maze: 0,
  rights: null,
  result: { state: "open" },
  verdict: null,
  diagnoses: [],
  failedRun: null,
  isCardShown: false,
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

/** How the open challenge stands; null while none is open. */
export function challengeResult({ challenge, result }: ChallengeState): ChallengeResult | null {
  return challenge === null ? null : result;
}

/** Whether what the run on the screen does is what counts: one maze, and a goal that is seen reached. */
export function isSeenInRun({ mazes, goal }: ChallengeDocument): boolean {
  return mazes.length === 1 && (goal.kind === "reach" || goal.kind === "stop");
}
