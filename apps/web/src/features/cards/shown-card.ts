/** Which card belongs to the moment on the screen. */
import type { Snapshot } from "@corridor/protocol";
import type { CardState } from "../../stores/card-store.ts";
import type { ChallengeResult } from "../../stores/challenge-store.ts";
import type { RunEvent, RunView } from "../../worker/worker-messages.ts";

/** How the open challenge stands. */
export interface ShownAttempt {
  result: ChallengeResult;
  /** whether the run on the screen is what met it; otherwise a check of all mazes did */
  isSeen: boolean;
}

/**
 * A bump is explained at the very moment at which it happened, also when the reader goes back to it. The
 * goal, or that the challenge is met, is told from then on while nobody drives on, but for a newer bump.
 * @param attempt null while no challenge is open
 */
export function shownCard(
  { bump, goal }: CardState,
  snapshot: Snapshot | null,
  view: RunView,
  attempt: ShownAttempt | null = null,
): "bump" | "goal" | "met" | null {
  if (snapshot === null || view === "playing" || isDriving(snapshot)) return null;
  if (attempt?.result.state === "met") {
    if (snapshot.tick >= (attempt.isSeen ? attempt.result.ticks : 0)) return "met";
  }
  // A goal that is reached against the rules of the challenge solves nothing.
  const counts = attempt?.result.state !== "failed" && attempt?.result.state !== "met";
  const isReached = goal !== null && snapshot.goalReached && snapshot.tick >= goal.event.tick;
  const isAtBump = bump !== null && isOf(bump.event, snapshot);
  // After a robot drove on from the goal into a wall, the card explains the bump.
  const isGoalNewer = !isAtBump || (goal?.event.tick ?? 0) >= bump.event.tick;
  if (counts && isReached && isGoalNewer) return "goal";
  return isAtBump ? "bump" : null;
}

/** A script's robot rests at the wall until the next command. */
function isOf({ driver, bumps, tick }: RunEvent, snapshot: Snapshot): boolean {
  if (driver !== "remote") return snapshot.tick === tick;
  return snapshot.driver === "remote" && snapshot.bumping && snapshot.bumps === bumps;
}

/** Time goes on for a script between its commands: its robot is at rest while none runs. */
function isDriving({ state, driver, command, motion }: Snapshot): boolean {
  if (state !== "running") return false;
  return driver !== "remote" || command !== null || motion !== "stop";
}
