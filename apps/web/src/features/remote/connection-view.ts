/** The state of the connection as the panel names it. */
import type { RemoteStatus, RemoteTrouble } from "../../worker/worker-messages.ts";

/** A script that was heard less long ago than this is connected; after that it is quiet. In ms. */
const QUIET_AFTER_MS = 5_000;

export type ConnectionView =
  | { kind: "off" | "connecting" | "waiting" | "paused" }
  | { kind: "connected" | "quiet"; client: string; seconds: number }
  | { kind: "lost" | "over"; reason: RemoteTrouble };

/**
 * @param isRunPaused whether the robot stands still until Run is pressed: what scripts send waits, so they fall silent
 * @param now milliseconds since 1970
 */
export function viewConnection(
  status: RemoteStatus,
  isRunPaused: boolean,
  now: number,
): ConnectionView {
  if (isRunPaused && (status.kind === "waiting" || status.kind === "connected")) {
    return { kind: "paused" };
  }
  if (status.kind !== "connected") return status;
  const silence = Math.max(0, now - status.seenAt);
  return {
    kind: silence < QUIET_AFTER_MS ? "connected" : "quiet",
    client: status.client,
    seconds: silence / 1_000,
  };
}
