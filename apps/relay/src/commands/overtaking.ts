/**
 * Commands that overtake: they end the accepted commands before them, and are delivered regardless
 * of the window.
 */
import type { RemoteCommand } from "@corridor/protocol";

/**
 * A stop cancels the commands before it, a replacement supersedes them. In order of precedence: a
 * stop also cancels what a replacement has overtaken.
 */
export const overtakingKinds = ["stop", "replace"] as const;
export type Overtaking = (typeof overtakingKinds)[number];

/**
 * How a command overtakes; null: it waits. This is the only place that decides it. Rows hold the
 * result, and queries of a store use the stored result.
 */
export function overtakingOf(command: RemoteCommand, replace: boolean): Overtaking | null {
  if (command.action === "stop") return "stop";
  return replace || command.action === "reset" ? "replace" : null;
}
