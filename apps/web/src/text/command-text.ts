/** Short texts of a command and its result. */
import type { CommandRecord, RemoteCommand, UntilCondition } from "@corridor/protocol";

/**
 * The action with its numbers, as in the API: "left 90", "move 120", "drive 0.2 -0.2 602 ms",
 * "forward until front <= 60". Of several conditions, only the first is in the text.
 */
export function commandText({ until = [], ...command }: RemoteCommand): string {
  const [first] = until;
  const action = actionText(command);
  if (first === undefined) return action;
  return `${action} until ${conditionText(first)}${until.length > 1 ? ", …" : ""}`;
}

function conditionText(condition: UntilCondition): string {
  if ("goal" in condition) return "goal";
  const { sensor, is, than } = condition;
  if (than !== "right") return `${sensor} ${is} ${than}`;
  return `${sensor} ${is} right ${condition.plus < 0 ? "-" : "+"} ${Math.abs(condition.plus)}`;
}

function actionText(command: RemoteCommand): string {
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
