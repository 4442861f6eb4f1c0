/**
 * Names of the Redis keys of one robot. The braces are a hash tag, which keeps them on one node of
 * a cluster.
 */

export function sessionOf(id: string): string {
  return `corridor:{${id}}`;
}

/** Relays by the time until which they count as alive. */
export const RELAYS = "corridor:relays";

/** The channel of a robot. */
export function lineOf(id: string): string {
  return `${sessionOf(id)}:line`;
}

/** The channel with messages for a single relay. */
export function postOf(relay: string): string {
  return `corridor:relay:${relay}`;
}

/** The keys that sessions.lua expects, in order. */
export function keysOf(id: string): string[] {
  const session = sessionOf(id);
  const parts = ["open", "ended", "keys"].map((part) => `${session}:${part}`);
  return [session, ...parts, "corridor:uses", "corridor:births", lineOf(id), RELAYS];
}
