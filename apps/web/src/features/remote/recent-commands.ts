/** Which commands the first view of the Remote panel lists. */
import type { ListedCommand } from "../../worker/worker-messages.ts";

/** Commands that have ended and are listed below the running one. */
const RECENT = 5;

/**
 * @param commands newest first
 * @returns the running command and the last five that ended, newest first, and how many wait
 */
export function recentCommands(commands: readonly ListedCommand[]): {
  listed: ListedCommand[];
  waiting: number;
} {
  let [ended, waiting] = [0, 0];
  const listed = commands.filter(({ state }) => {
    if (state === "started") return true;
    if (state === "accepted" || state === "delivered") {
      waiting++;
      return false;
    }
    return ++ended <= RECENT;
  });
  return { listed, waiting };
}
