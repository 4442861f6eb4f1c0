/** What the big button does now. */
import type { Snapshot } from "@corridor/protocol";
import type { ToWorker } from "../../worker/worker-messages.ts";

/**
 * Pause while a program or a script lets the robot move. While a hand drives it is Run, even with a
 * key held: it hands the robot to the program.
 */
export function isPauseOffered(snapshot: Snapshot | null): boolean {
  return snapshot !== null && snapshot.state === "running" && snapshot.driver !== "me";
}

/** What a press of the button, or of its shortcut, asks of the simulator. */
export function runOrPause(snapshot: Snapshot | null): ToWorker {
  return { type: isPauseOffered(snapshot) ? "pause" : "run" };
}
