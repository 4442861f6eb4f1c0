/**
 * The address of a mission or a bonus mission: `#mission/side-opening`. A fragment works on any
 * static host, offline and below every path (docs/adr/0015-mission-urls-as-fragments.md).
 */
const PREFIX = "#mission/";

/** The fragment of a mission's address. */
export function missionHash(id: string): string {
  return PREFIX + id;
}

/** The mission that a fragment names, whether or not it exists; null for any other fragment. */
export function missionOfHash(hash: string): string | null {
  return hash.startsWith(PREFIX) ? hash.slice(PREFIX.length) : null;
}
