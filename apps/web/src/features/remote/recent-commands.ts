/** The commands that the first view of the Remote panel lists. */
import type { ListedCommand } from "../../simulator/protocol/worker-messages.ts";

/** Maximum number of listed commands that have ended. */
const RECENT = 5;

/**
 * @param commands newest first
 * @param selected number of the command that is selected on the timeline; null: none
 * @returns the running command, the last five that ended and the selected one, newest first, and
 * the number of queued commands
 */
export function recentCommands(
  commands: readonly ListedCommand[],
  selected: number | null = null,
): {
  listed: ListedCommand[];
  waiting: number;
} {
  let [ended, waiting] = [0, 0];
  const listed = commands.filter(({ seq, state }) => {
    if (state === "started") return true;
    if (state === "accepted" || state === "delivered") {
      waiting++;
      return false;
    }
    return ++ended <= RECENT || seq === selected;
  });
  return { listed, waiting };
}
