/**
 * Assumed maximum drift between the clocks of two computers, as a share of the elapsed time: crystals
 * differ by 0.0001 at most. A receiver that measures how late messages are counts its own clock as
 * slower by this share, so that drift alone never makes a message of a long session look late. The
 * error is 18 ms a minute at most.
 */
export const MAX_CLOCK_DRIFT = 0.0002;
