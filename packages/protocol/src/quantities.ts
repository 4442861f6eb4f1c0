/**
 * Units and bounds of the quantities in messages and documents.
 * Lengths in units (1 unit = 1 cm), angles in degrees clockwise from north.
 */
import { z } from "zod";

/** Largest coordinate, in units: the largest maze has 256 x 256 cells of 100 units. */
export const MAX_LENGTH = 25_600;

const length = z
  .number({ error: "a number of cm" })
  .min(-MAX_LENGTH, { error: `at least ${-MAX_LENGTH} cm` })
  .max(MAX_LENGTH, { error: `at most ${MAX_LENGTH} cm` });

const reading = z
  .number({ error: "a distance in cm" })
  .min(0, { error: "0 cm or more" })
  // The diagonal of the largest maze is shorter than this.
  .max(2 * MAX_LENGTH, { error: `at most ${2 * MAX_LENGTH} cm` });

const heading = z
  .number({ error: "degrees clockwise from north" })
  .min(0, { error: "0 degrees or more" })
  .lt(360, { error: "less than 360 degrees" });

/**
 * Where the robot's centre is and where it faces: `{x: units right, y: units down, heading: [0,
 * 360)}`.
 */
export const poseSchema = z.strictObject({
  /** cm from the left edge of the maze */
  x: length,
  /** cm from the top edge of the maze */
  y: length,
  /** degrees clockwise from north, from 0 up to 360 */
  heading,
});
/** Where the robot's centre is, and where it faces. */
export type Pose = z.infer<typeof poseSchema>;

/** The four range sensors, in units from the robot's centre. */
export const sensorReadingsSchema = z.strictObject({
  /** cm to the wall in front */
  front: reading,
  /** cm to the wall at the right */
  right: reading,
  /** cm to the wall behind */
  back: reading,
  /** cm to the wall at the left */
  left: reading,
});
/** The distance to the next wall on each side, in cm from the robot's centre, all of one tick. */
export type SensorReadings = z.infer<typeof sensorReadingsSchema>;

/** Who drives the robot. */
export const driverSchema = z.enum(["me", "program", "remote"], {
  error: "one of me, program, remote",
});
export type DriverName = z.infer<typeof driverSchema>;
