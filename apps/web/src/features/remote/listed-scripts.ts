/**
 * Which scripts the panel lists. Their order is stable, so that no row moves away from the pointer.
 */
import type { ListedScript } from "../../simulator/protocol/worker-messages.ts";
import { QUIET_AFTER_MS } from "./connection-view.ts";

/** ms of silence after which a script without a connection is no longer listed. */
const SHOWN_MS = 120_000;

/** @param now ms since 1970 */
export function shownScripts(scripts: readonly ListedScript[], now: number): ListedScript[] {
  return scripts
    .filter(
      ({ isBlocked, connections, seenAt }) =>
        isBlocked || connections > 0 || silence(seenAt, now) < SHOWN_MS,
    )
    .toSorted((a, b) => order(a.name ?? a.client, b.name ?? b.client) || order(a.id, b.id));
}

/**
 * Whole seconds for which a script has been quiet; 0 while it is connected, blocked or recently
 * active.
 */
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
