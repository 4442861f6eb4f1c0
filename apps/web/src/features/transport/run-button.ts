/** What the big button and Step do now, and what a press of one, or of its shortcut, asks for. */
import type { Snapshot } from "@corridor/protocol";
import type { RunView, ToWorker } from "../../worker/worker-messages.ts";

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

/** What a press of the big button asks of the simulator. */
export function runOrPause(now: RunNow): ToWorker {
  return { type: runButton(now) };
}

/** What a press of Step asks: one decision, of those that were taken where the past is shown. */
export function stepOn({ view }: Pick<RunNow, "view">): ToWorker {
  return view === "now" ? { type: "step" } : { type: "seek-step", by: 1 };
}
