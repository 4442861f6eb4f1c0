/** In its own file so that the page's worker imports no schemas. */

const CHECK_PAGE = "check that the robot's page is open, connected under Remote and not paused.";

/**
 * The `reason` of a command that has not ended, in the response to a script that waited for its
 * ending while no page was connected as the robot.
 */
export const ABSENT_ROBOT_REASON =
  "The robot's page is closed or offline: open it again and choose Remote. If it says Off, press Connect. If you closed its tab, copy the new address.";

/**
 * The `reason` of a command that has not ended, in the response to a script that waited for its
 * ending while the page reported a paused run.
 */
export const PAUSED_RUN_REASON = "The run is paused: press Run on the robot's page.";

/**
 * The `reason` of an expired command.
 * @param ttl in ms
 * @param obstacle at the deadline, if it is known: no page was connected as the robot, or the run
 *   was paused
 */
export function expiredReason(ttl: number, obstacle?: "absent" | "paused"): string {
  const seconds = ttl / 1000;
  if (obstacle === undefined) return `Not started within ${seconds} s: ${CHECK_PAGE}`;
  const reason = obstacle === "absent" ? ABSENT_ROBOT_REASON : PAUSED_RUN_REASON;
  return `${reason} The command did not start within ${seconds} s.`;
}

/**
 * The `reason` of a command that has not ended, in the response to a script that waited for its
 * ending while the robot was asleep.
 */
export const SILENT_ROBOT_REASON = `The robot does not answer: ${CHECK_PAGE}`;
