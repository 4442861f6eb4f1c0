/**
 * Why this page ends remote commands early. The page displays a translated reason, by its code;
 * scripts receive the English sentence.
 */
import { BLOCKED_REASON, PAUSED_REASON, REVOKED_REASON } from "@corridor/protocol";

export const cancelReasons = {
  notRemote: "Remote does not drive: choose Remote on the robot's page.",
  handedOver: "The robot's page took over: choose Remote there to let scripts drive.",
  reset: "The robot was put back to its start.",
  mazeChanged: "The maze changed and the robot was put back to its start.",
  movedInTime: "The robot's page went to another moment or another run.",
  stopped: "The robot was stopped.",
  replaced: "A newer command took its place.",
  takenBack: "Its script cancelled it. Send it again if the robot should still do it.",
  keyRevoked: REVOKED_REASON,
  blocked: BLOCKED_REASON,
  paused: PAUSED_REASON,
  silent: "Its sender fell silent, so the robot stopped.",
  disconnected: "The robot's page disconnected.",
  addressEnded: "The robot's page no longer uses this address.",
} as const satisfies Record<string, string>;

/** Why a command ended that ran when its page was reloaded; the relay sends the same reason. */
export const RELOADED = "the page was reloaded";

/**
 * Reasons in the page itself. Commands that were sent before are for an outdated state, so those
 * still queued at the relay end, too.
 */
export const pageReasons: ReadonlySet<CancelReason> = new Set([
  "notRemote",
  "handedOver",
  "reset",
  "mazeChanged",
  "movedInTime",
  "disconnected",
]);

/** Key of `cancelReasons`. */
export type CancelReason = keyof typeof cancelReasons;
