/**
 * Names of the Redis keys of robots and classes. The braces are a hash tag, which keeps them on one
 * node of a cluster.
 */

export function robotKeyOf(id: string): string {
  return `corridor:{${id}}`;
}

/** Relays by the time until which they count as alive. */
export const RELAYS = "corridor:relays";

/** The channel of a robot. */
export function channelOf(id: string): string {
  return `${robotKeyOf(id)}:channel`;
}

/** The channel with messages for a single relay. */
export function postOf(relay: string): string {
  return `corridor:relay:${relay}`;
}

/** Robots by last use, and by creation. */
export const USES = "corridor:uses";
export const BIRTHS = "corridor:births";

/** Open commands by seq. */
export function openOf(id: string): string {
  return `${robotKeyOf(id)}:open`;
}

/** Ended commands by seq. */
export function endedOf(id: string): string {
  return `${robotKeyOf(id)}:ended`;
}

/** Seq of ended commands by idempotency key. */
export function keysOf(id: string): string {
  return `${robotKeyOf(id)}:keys`;
}

/** The keys that commit.lua expects, in order. */
export function commitKeys(id: string): string[] {
  return [robotKeyOf(id), openOf(id), keysOf(id), endedOf(id), USES, BIRTHS, channelOf(id)];
}

/** Field with the time at which a key was created. */
export function madeAt(hash: string): string {
  return `made:${hash}`;
}

/** Field with the time at which a key was last used. */
export function usedAt(hash: string): string {
  return `used:${hash}`;
}

/** Classes by last use, and by creation. */
export const CLASS_USES = "corridor:class-uses";
export const CLASS_BIRTHS = "corridor:class-births";

/** A class, with its students, programs and codes. */
export function classKeyOf(id: string): string {
  return `corridor:class:{${id}}`;
}

/** What a code admits to: ID STUDENT ENDS, where STUDENT and ENDS may be `-`. @param hash */
export function classCodeKeyOf(hash: string): string {
  return `corridor:class-code:${hash}`;
}

/** The channel of a class. */
export function classChannelOf(id: string): string {
  return `${classKeyOf(id)}:channel`;
}
