/** In its own file so that the page's worker imports no schemas. */

const CHECK_PAGE = "check that the robot's page is open, connected under Remote and not paused.";

/**
 * The `reason` of a command that has not ended, in the response to a script that waited for its
 * ending while no page was connected as the robot.
 */
export const ABSENT_ROBOT_REASON =
  "The robot's page is closed or offline: open it again and choose Remote.";

/**
 * The `reason` of an expired command.
 * @param ttl in ms
 * @param isAbsent whether no page was connected as the robot at the deadline
 */
export function expiredReason(ttl: number, isAbsent = false): string {
  if (isAbsent) return `${ABSENT_ROBOT_REASON} The command did not start within ${ttl / 1000} s.`;
  return `Not started within ${ttl / 1000} s: ${CHECK_PAGE}`;
}

/**
 * The `reason` of a command that has not ended, in the response to a script that waited for its
 * ending while the robot was paused or asleep.
 */
export const SILENT_ROBOT_REASON = `The robot does not answer: ${CHECK_PAGE}`;
