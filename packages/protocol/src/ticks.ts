/** Number of ticks in a second of simulated time: the unit of `tick` in a snapshot. */
export const TICKS_PER_SECOND = 60;
