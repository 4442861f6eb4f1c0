/**
 * The names in Redis of what belongs to one robot. The braces let them stay together where many Redis
 * share the robots.
 */

export function sessionOf(id: string): string {
  return `corridor:{${id}}`;
}

/** The relays, by the time until which they count as alive. */
export const RELAYS = "corridor:relays";

/** The channel on which the robot's line is. */
export function lineOf(id: string): string {
  return `${sessionOf(id)}:line`;
}

/** The channel on which a relay gets what is for it alone. */
export function postOf(relay: string): string {
  return `corridor:relay:${relay}`;
}

/** What the script of the sessions is given, in its order. */
export function keysOf(id: string): string[] {
  const session = sessionOf(id);
  const parts = ["open", "ended", "keys"].map((part) => `${session}:${part}`);
  return [session, ...parts, "corridor:uses", "corridor:births", lineOf(id), RELAYS];
}
