/** Bounds of the terms of a command. In their own file so that the page imports no schemas. */

/** ms within which a command must start */
export const TTL_MS = { min: 200, max: 60_000, default: 10_000 } as const;
/** ms after which an unrenewed drive stops */
export const LEASE_MS = { min: 100, max: 2_000, default: 500 } as const;
