/** A file of its own: the page's worker needs no schema for it. */

/** The `reason` of a command that expired, for its script. @param ttl in ms */
export function expiredReason(ttl: number): string {
  return `Not started within ${ttl / 1000} s: check that the robot's page is open, connected under Remote and not paused.`;
}
