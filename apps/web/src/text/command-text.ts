/** Short texts of a command and its result. */
import type { Command, CommandRecord } from "@corridor/protocol";

/** The action with its numbers, as in the API: "left 90", "move 120", "drive 0.2 -0.2 602 ms". */
export function commandText(command: Command): string {
  if (command.action === "move") return `move ${command.distance}`;
  if (command.action === "turn") return `turn ${command.degrees}`;
  if (command.action !== "drive") return command.action;
  const time = command.milliseconds === undefined ? "" : ` ${command.milliseconds} ms`;
  return `drive ${command.left} ${command.right}${time}`;
}

/**
 * The distance, in whole cm, after which a command ended early; null if it did not, or if it ended
 * at once.
 */
export function cutShortAfter({
  state,
  distance,
}: Pick<CommandRecord, "state" | "distance">): number | null {
  const isCutShort = state === "collided" || state === "cancelled" || state === "superseded";
  return isCutShort && distance !== null && distance >= 0.5 ? Math.round(distance) : null;
}
