/** Which card belongs to the moment on the screen. */
import type { Snapshot } from "@corridor/protocol";
import type { CardState } from "../../stores/card-store.ts";
import type { RunView } from "../../worker/worker-messages.ts";

/**
 * A bump is explained at the very moment at which it happened, also when the reader goes back to it. The
 * goal is told from then on while nobody drives on.
 */
export function shownCard(
  { bump, goal }: CardState,
  snapshot: Snapshot | null,
  view: RunView,
): "bump" | "goal" | null {
  if (snapshot === null || view === "playing") return null;
  const isStill = snapshot.state !== "running";
  if (goal !== null && isStill && snapshot.goalReached && snapshot.tick >= goal.moment.tick) {
    return "goal";
  }
  return bump !== null && isStill && snapshot.tick === bump.moment.tick ? "bump" : null;
}
