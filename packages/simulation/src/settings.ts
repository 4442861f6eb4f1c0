/**
 * Every tuning number of the simulation, with unit and source.
 * The Classic robot is the one of the 2013 thesis, in the units of this project (1 unit = 1 cm).
 */

/** One tick of simulated time. */
export const TICKS_PER_SECOND = 60;
export const TICK_SECONDS = 1 / TICKS_PER_SECOND;

/** Radius of the body, a disc, in units. */
export const ROBOT_RADIUS = 25;

/** Speed of `forward` and `reverse`, units a tick. */
export const DRIVE_STEP = 100 / TICKS_PER_SECOND;

/** Turning on the spot, degrees a tick: 150 degrees a second. */
export const TURN_STEP = 150 / TICKS_PER_SECOND;

/** Distance between the two wheels, in units. */
export const TRACK_WIDTH = 40;

/** Speed of a wheel's rim at power 1, units a second. So `drive(0.2, -0.2)` turns 90 degrees in 602 ms. */
export const WHEEL_SPEED = 261;

/** A delayed turn drives on to the middle of the opening, turns, and leaves the junction. */
export const DELAY_DISTANCE = 50;
export const LEAVE_DISTANCE = 60;
