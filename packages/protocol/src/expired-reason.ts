/** In its own file so that the page's worker imports no schemas. */

/** The `reason` of an expired command. @param ttl in ms */
export function expiredReason(ttl: number): string {
  return `Not started within ${ttl / 1000} s: check that the robot's page is open, connected under Remote and not paused.`;
}
