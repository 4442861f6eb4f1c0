/** Times that both ends of a connection use. In their own file so that the page imports no schemas. */

/** The connection counts as lost after this long without a message. */
export const SILENCE_MS = 45_000;
/** Longest long poll, in seconds; below the 30 s after which many proxies time out. */
export const LONG_POLL_SECONDS = 25;
