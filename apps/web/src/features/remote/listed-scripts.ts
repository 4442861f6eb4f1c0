/** Which scripts the panel shows, and in an order in which no row moves away from under the pointer. */
import type { ListedScript } from "../../worker/worker-messages.ts";

/** One without a line is forgotten once it was silent for so long. In ms. */
const SHOWN_MS = 120_000;
/** A script that was heard less long ago than this is there; after that it is quiet. In ms. */
const QUIET_AFTER_MS = 5_000;

/** @param now milliseconds since 1970 */
export function shownScripts(scripts: readonly ListedScript[], now: number): ListedScript[] {
  return scripts
    .filter(
      ({ isBlocked, connections, seenAt }) =>
        isBlocked || connections > 0 || silence(seenAt, now) < SHOWN_MS,
    )
    .toSorted((a, b) => order(a.name ?? a.client, b.name ?? b.client) || order(a.id, b.id));
}

/** Whole seconds for which a script has been quiet; 0 while it is heard. */
export function quietSeconds(
  { isBlocked, connections, seenAt }: ListedScript,
  now: number,
): number {
  const ms = silence(seenAt, now);
  return isBlocked || connections > 0 || ms < QUIET_AFTER_MS ? 0 : Math.floor(ms / 1_000);
}

function silence(seenAt: number | null, now: number): number {
  return seenAt === null ? Infinity : Math.max(0, now - seenAt);
}

function order(a: string, b: string): number {
  if (a === b) return 0;
  return a < b ? -1 : 1;
}
