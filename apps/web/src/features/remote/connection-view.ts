/** The state of the connection that the panel displays. */
import type { RemoteStatus, RemoteTrouble } from "../../simulator/protocol/worker-messages.ts";

/** ms since the last message of a script, after which it counts as quiet instead of connected. */
export const QUIET_AFTER_MS = 5_000;

export type ConnectionView =
  | { kind: "off" | "connecting" | "waiting" | "paused" }
  | { kind: "connected" | "quiet"; client: string; seconds: number }
  | { kind: "lost" | "over"; reason: RemoteTrouble };

/**
 * @param isRunPaused whether the robot waits for Run: commands of scripts wait too, so that scripts
 * fall silent
 * @param now ms since 1970
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
