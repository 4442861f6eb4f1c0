/** A snapshot: everything that the robot reports at the end of one tick. */
import { z } from "zod";
import { actionNames } from "./command.ts";
import { driverSchema, poseSchema, sensorReadingsSchema } from "./quantities.ts";

/** Messages contain only integers that every language represents exactly. */
const count = z
  .int({ error: "a whole number" })
  .min(0, { error: "0 or more" })
  .max(Number.MAX_SAFE_INTEGER, { error: "a whole number below 2^53" });

/** The state of the robot's body, without its driver. */
export const robotReportSchema = z.strictObject({
  /** ticks of 1/60 s since the robot was placed at its start */
  tick: count,
  /** the four distances */
  sensors: sensorReadingsSchema,
  /** where the robot is */
  pose: poseSchema,
  /** the action that moves the robot now; `stop` if it stands still. Readers accept later actions */
  motion: z
    .string()
    .max(40)
    .meta({ enum: [...actionNames] }),
  /** number of bumps since the robot's start */
  bumps: count,
  /** whether the robot touches a wall now */
  bumping: z.boolean(),
  /** whether the robot has reached a goal since its start */
  goalReached: z.boolean(),
});
export type RobotReport = z.infer<typeof robotReportSchema>;

/** A program line by its index from 0, or the default action. */
export const lineSchema = z.union([z.literal("default"), count]);
export type LineRef = z.infer<typeof lineSchema>;

export const snapshotSchema = robotReportSchema.extend({
  /** number of the snapshot, increasing */
  seq: count,
  /** running; paused: the page sleeps, or the user paused; gone: the page is closed */
  state: z.enum(["running", "paused", "gone"]),
  /** who drives */
  driver: driverSchema,
  /** the program line that decides now; null unless a program drives */
  line: lineSchema.nullable(),
  /** seq of the running remote command; null if there is none */
  command: count.nullable(),
});
/** Everything that the robot reports, of one tick. */
export type Snapshot = z.infer<typeof snapshotSchema>;
