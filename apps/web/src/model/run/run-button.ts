/**
 * The function of the run button and of Step, and the requests that they and their shortcuts send.
 */
import type { Rights } from "@corridor/challenge";
import type { Snapshot } from "@corridor/protocol";
import type { StepLength, ToWorker } from "../../simulator/protocol/worker-messages.ts";
import type { RunView } from "../../stage/drawing/frame.ts";

/** The part of the run store that is used here. */
interface RunNow {
  snapshot: Snapshot | null;
  view: RunView;
}

/**
 * Pause while a program or a script drives, and while the past is played. Run while the user
 * drives, even with a key held: it transfers the robot to the program. Run from here while the past
 * is displayed.
 */
export function runButton({ snapshot, view }: RunNow): "run" | "pause" | "run-here" {
  if (view === "playing") return "pause";
  if (view === "past") return "run-here";
  return snapshot?.state === "running" && snapshot.driver !== "me" ? "pause" : "run";
}

/** Whether a challenge excludes the driver Program, which disables Run and Step. */
export function isProgramRefused(rights: Pick<Rights, "drivers"> | null): boolean {
  return rights !== null && !rights.drivers.includes("program");
}

/** The hint before a run: how to start one, or who drives where Run and Step are disabled. */
export function startHint(rights: Pick<Rights, "drivers"> | null): "hint" | "byHand" | "byScript" {
  if (rights === null || rights.drivers.includes("program")) return "hint";
  return rights.drivers.includes("me") ? "byHand" : "byScript";
}

/** The request of the run button. */
export function runOrPause(now: RunNow): ToWorker {
  return { type: runButton(now) };
}

/** The request of Step: the next decision or tick; while the past is displayed, a recorded one. */
export function stepOn(
  { view, snapshot }: Pick<RunNow, "view" | "snapshot">,
  length: StepLength = "decision",
): ToWorker {
  if (view === "now") return { type: "step", length };
  if (length === "decision") return { type: "seek-step", by: 1 };
  return { type: "seek", tick: (snapshot?.tick ?? 0) + 1 };
}

/** The request of "One decision back", the inverse of Step. */
export function stepBack(
  { snapshot }: Pick<RunNow, "snapshot">,
  length: StepLength = "decision",
): ToWorker {
  if (length === "decision") return { type: "seek-step", by: -1 };
  return { type: "seek", tick: Math.max(0, (snapshot?.tick ?? 0) - 1) };
}
