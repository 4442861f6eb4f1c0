/**
 * Decides what a press of a drive key does in each state of the run. Keyboard, buttons and touch
 * share this rule, so that all of them take over in the same states. Pure.
 */
import type { Rights } from "@corridor/challenge";
import type { RunState } from "../../model/run/run-store.ts";
import type { DriveKey } from "../../simulator/protocol/worker-messages.ts";

/** The parts of the run store that decide. */
export type HandRun = Pick<RunState, "snapshot" | "view" | "nowDriver" | "fault">;

/**
 * - drive: Me drives already.
 * - take-over: Me drives from now on.
 * - pause: Stop pauses the program, the script or the replay.
 * - refuse: the open challenge does not allow Me.
 * - none: there is nothing to do.
 */
export type HandAction = "drive" | "take-over" | "pause" | "refuse" | "none";

/** Whether the challenge would refuse every drive key; the page then does not display the keys. */
export function isHandRefused(run: HandRun, rights: Pick<Rights, "drivers"> | null): boolean {
  return handAction("forward", run, rights) === "refuse";
}

/** @param rights rights in the open challenge; null if no challenge is open */
export function handAction(
  key: DriveKey,
  { snapshot, view, nowDriver, fault }: HandRun,
  rights: Pick<Rights, "drivers"> | null,
): HandAction {
  if (fault !== null) return "none";
  // In the past, the displayed tick and the newest tick may have different drivers.
  const isDriving = snapshot?.driver === "me" && (view === "now" || nowDriver === "me");
  if (key === "stop" && (!isDriving || view !== "now"))
    return snapshot?.state === "running" ? "pause" : "none";
  if (key !== "stop" && rights?.drivers.includes("me") === false) return "refuse";
  return isDriving ? "drive" : "take-over";
}
