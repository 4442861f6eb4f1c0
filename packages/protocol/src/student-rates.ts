/**
 * How often the page of a student sends to its class. Pages keep to it, and relays reject more. In a
 * file of its own, so that a page loads no schemas for it.
 */

/** Least time between two tiles, in ms. */
export const TILE_INTERVAL_MS = 500;
/** The same while a teacher watches the student. */
export const WATCHED_TILE_INTERVAL_MS = 200;
/** Messages of progress, and those of programs. */
export const REPORT_RATE = { perSecond: 0.5, burst: 10 } as const;
