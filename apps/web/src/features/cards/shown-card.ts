/** Selects the card for the displayed tick. */
import type { Snapshot } from "@corridor/protocol";
import type { CardState } from "../../model/run/card-store.ts";
import type { ChallengeResult } from "../../model/challenge/challenge-store.ts";
import type { RunEvent } from "../../simulator/protocol/worker-messages.ts";
import type { RunView } from "../../stage/drawing/frame.ts";

/** The state of the open challenge. */
export interface ShownAttempt {
  result: ChallengeResult;
  /** whether the displayed run met the challenge; otherwise a check of all mazes did */
  isSeen: boolean;
}

/**
 * Returns the card to display while the robot does not drive.
 * - bump: at the tick of the bump, also when the user seeks back to it.
 * - goal: from the goal on, unless the bump that is displayed is newer.
 * - met: from the tick that met the challenge on, or at any tick after a check of all mazes. It
 *   replaces the other cards.
 * @param attempt null if no challenge is open
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
  // Reaching the goal against the rules of the challenge solves nothing.
  const counts = attempt?.result.state !== "failed" && attempt?.result.state !== "met";
  const isReached = goal !== null && snapshot.goalReached && snapshot.tick >= goal.event.tick;
  const isAtBump = bump !== null && isOf(bump.event, snapshot);
  // If the robot drives from the goal into a wall, the card explains the bump.
  const isGoalNewer = !isAtBump || (goal?.event.tick ?? 0) >= bump.event.tick;
  if (counts && isReached && isGoalNewer) return "goal";
  return isAtBump ? "bump" : null;
}

/** A script's robot stays at the wall until the next command. */
function isOf({ driver, bumps, tick }: RunEvent, snapshot: Snapshot): boolean {
  if (driver !== "remote") return snapshot.tick === tick;
  return snapshot.driver === "remote" && snapshot.bumping && snapshot.bumps === bumps;
}

/** A script's robot is at rest between commands, although time continues. */
function isDriving({ state, driver, command, motion }: Snapshot): boolean {
  if (state !== "running") return false;
  return driver !== "remote" || command !== null || motion !== "stop";
}
