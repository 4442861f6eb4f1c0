/** What the big button and Step do now, and what a press of one, or of its shortcut, asks for. */
import type { Rights } from "@corridor/challenge";
import type { Snapshot } from "@corridor/protocol";
import type { RunView, StepLength, ToWorker } from "../../worker/worker-messages.ts";

/** What decides it; the run store has all of it. */
interface RunNow {
  snapshot: Snapshot | null;
  view: RunView;
}

/**
 * Pause while a program or a script lets the robot move, and while the past is played. While a hand
 * drives it is Run, even with a key held: it hands the robot to the program. In the past it is Run from
 * here.
 */
export function runButton({ snapshot, view }: RunNow): "run" | "pause" | "run-here" {
  if (view === "playing") return "pause";
  if (view === "past") return "run-here";
  return snapshot?.state === "running" && snapshot.driver !== "me" ? "pause" : "run";
}

/** Whether a challenge is for a hand alone: Run and Step are off there. */
export function isProgramRefused(rights: Pick<Rights, "drivers"> | null): boolean {
  return rights !== null && !rights.drivers.includes("program");
}

/** What a press of the big button asks of the simulator. */
export function runOrPause(now: RunNow): ToWorker {
  return { type: runButton(now) };
}

/** What a press of Step asks: the next decision or tick; where the past is displayed, a recorded one. */
export function stepOn(
  { view, snapshot }: Pick<RunNow, "view" | "snapshot">,
  length: StepLength = "decision",
): ToWorker {
  if (view === "now") return { type: "step", length };
  if (length === "decision") return { type: "seek-step", by: 1 };
  return { type: "seek", tick: (snapshot?.tick ?? 0) + 1 };
}

/** What "One decision back" asks: the exact mirror of Step. */
export function stepBack(
  { snapshot }: Pick<RunNow, "snapshot">,
  length: StepLength = "decision",
): ToWorker {
  if (length === "decision") return { type: "seek-step", by: -1 };
  return { type: "seek", tick: Math.max(0, (snapshot?.tick ?? 0) - 1) };
}
