/** In its own file so that the page's worker imports no schemas. */

const CHECK_PAGE = "check that the robot's page is open, connected under Remote and not paused.";

/**
 * Why a robot neither starts nor continues commands.
 *
 * - absent: no page is connected as the robot
 * - paused: the page reports a paused run
 * - asleep: the page does not report
 */
export type Obstacle = "absent" | "paused" | "asleep";

const reasons: Readonly<Record<Obstacle, string>> = {
  absent:
    "The robot's page is closed or offline: open it again and choose Remote. If it says Off, press Connect. If you closed its tab, copy the new address.",
  paused: "The run is paused: press Run on the robot's page.",
  asleep: `The robot does not answer: ${CHECK_PAGE}`,
};

/** The `reason` of a command that has not ended, for a script that waited for its ending. */
export function waitingReason(obstacle: Obstacle): string {
  return reasons[obstacle];
}

/**
 * The `reason` of an expired command.
 * @param ttl in ms
 * @param obstacle at the deadline, if it is known
 */
export function expiredReason(ttl: number, obstacle?: "absent" | "paused"): string {
  const seconds = ttl / 1000;
  if (obstacle === undefined) return `Not started within ${seconds} s: ${CHECK_PAGE}`;
  return `${reasons[obstacle]} The command did not start within ${seconds} s.`;
}
