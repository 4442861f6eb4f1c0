/** In its own file so that the page's worker imports no schemas. */

const CHECK_PAGE = "check that the robot's page is open, connected under Remote and not paused.";

/** The `reason` of an expired command. @param ttl in ms */
export function expiredReason(ttl: number): string {
  return `Not started within ${ttl / 1000} s: ${CHECK_PAGE}`;
}

/**
 * The `reason` of a command that has not ended, in the response to a script that waited for its
 * ending while the robot was gone or paused.
 */
export const SILENT_ROBOT_REASON = `The robot does not answer: ${CHECK_PAGE}`;
