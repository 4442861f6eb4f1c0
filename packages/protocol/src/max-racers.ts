/**
 * Different programs of a race. In a file of its own, so that the dashboard loads no schemas for
 * it.
 */
export const MAX_RACERS = 40;
