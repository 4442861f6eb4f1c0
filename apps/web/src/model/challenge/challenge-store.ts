/**
 * The open challenge, if any: what the editor may offer and the state of the attempt. The lessons,
 * which load on demand, write it; everything else only reads it.
 */
import type { ChallengeDocument, FailureCode, Rights, Verdict } from "@corridor/challenge";
import type { Diagnosis } from "@corridor/coach";
import type { DriverName } from "@corridor/protocol";
import { createStore } from "zustand/vanilla";

/** State of the attempt. */
export type ChallengeResult =
  | { state: "open" }
  /**
   * the goal is met in the displayed maze; the other mazes are being checked, or are still to be
   * checked
   */
  | { state: "here"; ticks: number; bumps: number; lines: number }
  /**
   * `driver`: who reached it; `ticks` and `bumps` of the run on the screen that met it, otherwise of
   * the check; `lines` of the program, 0 for a hand-driven robot
   */
  | { state: "met"; driver: DriverName; ticks: number; bumps: number; lines: number }
  /** until the robot is reset; "late" and "edited" come from the run alone */
  | { state: "failed"; code: FailureCode | "late" | "edited"; tick: number };

export interface ChallengeState {
  /** null while none is open */
  challenge: ChallengeDocument | null;
  /** id of the mission of the challenge; null for a challenge from a link */
  mission: string | null;
  /** index of the displayed maze */
  maze: number;
  /** what the editor may offer; null: everything */
  rights: Rights | null;
  result: ChallengeResult;
  /** result of the newest check of all mazes for the current program; null without one */
  checked: Verdict | null;
  /** the same, as the newest verdict; null after a run that failed since */
  verdict: Verdict | null;
  /** parallel to the mazes of the verdict: why the program fails there */
  diagnoses: readonly (Diagnosis | null)[];
  /** why the displayed run failed; null if it has not, and after a newer check */
  failedRun: Diagnosis | null;
  /** whether the card beside the robot offers the next step, so that nothing else has to */
  hasCard: boolean;
  isChecking: boolean;
  /** whether a first-time user is asked to start with mission 1 */
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
  checked: null,
  verdict: null,
  diagnoses: [],
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

/** State of the open challenge; null while none is open. */
export function challengeResult({ challenge, result }: ChallengeState): ChallengeResult | null {
  return challenge === null ? null : result;
}

/**
 * Whether the displayed run alone decides: one maze, and a goal that the run can show as reached.
 */
export function isJudgedByRun({ mazes, goal }: ChallengeDocument): boolean {
  return mazes.length === 1 && (goal.kind === "reach" || goal.kind === "stop");
}
