/** Version of the package, which bridges send to the robot's host. */
export const VERSION = "0.1.0";
