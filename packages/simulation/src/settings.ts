/**
 * All tuning constants of the simulation, with units and sources.
 * The Classic robot is the robot of the 2013 thesis. 1 unit is 1 cm.
 */
import { TICKS_PER_SECOND } from "@corridor/protocol";

/** Length of a tick in simulated time. */
export const TICK_SECONDS = 1 / TICKS_PER_SECOND;

/** Radius of the disc-shaped body, in units. */
export const ROBOT_RADIUS = 25;

/** Speed of `forward` and `reverse`, in units per tick. */
export const DRIVE_STEP = 100 / TICKS_PER_SECOND;

/** Speed of a turn on the spot, in degrees per tick: 150 degrees per second. */
export const TURN_STEP = 150 / TICKS_PER_SECOND;

/** Distance between the two wheels, in units. */
export const TRACK_WIDTH = 40;

/**
 * Rim speed of a wheel at power 1, in units per second: `drive(0.2, -0.2)` turns 90 degrees in 602
 * ms.
 */
export const WHEEL_SPEED = 261;

/** A delayed turn drives to the middle of the opening, turns, and leaves the junction. In units. */
export const DELAY_DISTANCE = 50;
export const LEAVE_DISTANCE = 60;
