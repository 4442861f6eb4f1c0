/**
 * What a press of a drive key does in each state of the run. Keys, buttons and fingers all ask here, so that
 * each of them takes over from a program or a script in the same states. Pure.
 */
import type { Rights } from "@corridor/challenge";
import type { RunState } from "../../stores/run-store.ts";
import type { DriveKey } from "../../worker/worker-messages.ts";

/** What decides it; the run store has all of it. */
export type HandRun = Pick<RunState, "snapshot" | "view" | "nowDriver" | "fault">;

/**
 * drive: the hand drives already; take-over: it drives from now on; pause: Stop ends what the program, the
 * script or the replay does; refuse: the open challenge is not for the hand; none: there is nothing to do.
 */
export type HandAction = "drive" | "take-over" | "pause" | "refuse" | "none";

/** Whether drive keys would do nothing but refuse: then they are not displayed. */
export function isHandRefused(run: HandRun, rights: Pick<Rights, "drivers"> | null): boolean {
  return handAction("forward", run, rights) === "refuse";
}

/** @param rights of the open challenge; null: no challenge is open */
export function handAction(
  key: DriveKey,
  { snapshot, view, nowDriver, fault }: HandRun,
  rights: Pick<Rights, "drivers"> | null,
): HandAction {
  if (fault !== null) return "none";
  // In the past, the displayed moment and the newest one may have different drivers.
  const isDriving = snapshot?.driver === "me" && (view === "now" || nowDriver === "me");
  if (key === "stop" && (!isDriving || view !== "now"))
    return snapshot?.state === "running" ? "pause" : "none";
  if (isDriving) return "drive";
  return rights === null || rights.drivers.includes("me") ? "take-over" : "refuse";
}
