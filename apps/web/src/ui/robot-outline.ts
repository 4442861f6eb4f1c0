/**
 * The outline of the robot from above, in units around its centre, facing north, as in the SVG files
 * of the design.
 */

export const ROBOT_BODY =
  "M-20-8C-20-19-12-25 0-25S20-19 20-8V10C20 19 14 24 6 24H-6C-14 24-20 19-20 10z";

/** Half of its width. Its body fits into a circle of this radius. Both include the line around it. */
export const ROBOT_HALF = 28;
