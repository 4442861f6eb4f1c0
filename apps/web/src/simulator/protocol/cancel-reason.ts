/**
 * Why this page ends remote commands early. The page displays a translated reason, by its code;
 * scripts receive the English sentence.
 */
import { BLOCKED_REASON, PAUSED_REASON, REVOKED_REASON, SILENT_REASON } from "@corridor/protocol";

export const cancelReasons = {
  notRemote: "Remote is not driving: choose Remote on the robot's page.",
  takenOver: "The robot's page took over: choose Remote there to let scripts drive.",
  reset: "The robot was put back to its start.",
  mazeChanged: "The maze changed and the robot was put back to its start.",
  movedInTime: "The robot's page opened another run, or another time in the run.",
  stopped: "The robot was stopped.",
  replaced: "A newer command replaced this command.",
  cancelledByScript: "The script cancelled this command. To run it, send a new command.",
  keyRevoked: REVOKED_REASON,
  blocked: BLOCKED_REASON,
  paused: PAUSED_REASON,
  silent: SILENT_REASON,
  disconnected: "The robot's page disconnected.",
  addressEnded: "The robot's page no longer uses this address. Copy its new address.",
} as const satisfies Record<string, string>;

/**
 * Reasons in the page itself. Commands that were sent before are for an outdated state, so those
 * still queued at the relay end, too.
 */
export const pageReasons: ReadonlySet<CancelReason> = new Set([
  "notRemote",
  "takenOver",
  "reset",
  "mazeChanged",
  "movedInTime",
  "disconnected",
]);

/** Key of `cancelReasons`. */
export type CancelReason = keyof typeof cancelReasons;
