/**
 * A snapshot: all that the robot reports at the end of one tick.
 */
import { z } from "zod";
import { driverSchema, poseSchema, sensorReadingsSchema } from "./quantities.ts";

/** Numbers on the wire stay where every language can hold them exactly. */
const count = z
  .int({ error: "a whole number" })
  .min(0, { error: "0 or more" })
  .max(Number.MAX_SAFE_INTEGER, { error: "a whole number below 2^53" });

/** What the body itself knows, without who drives it and why. */
export const robotReportSchema = z.strictObject({
  /** ticks of 1/60 s since the robot was put at its start */
  tick: count,
  /** the four distances */
  sensors: sensorReadingsSchema,
  /** where the robot is */
  pose: poseSchema,
  /** the action that moves the robot now */
  motion: z.string().max(40),
  /** number of walls that the robot has met since its start */
  bumps: count,
  /** whether the robot touches a wall now */
  bumping: z.boolean(),
  /** whether the robot has reached a goal since its start */
  goalReached: z.boolean(),
});
export type RobotReport = z.infer<typeof robotReportSchema>;

/** A program line by its index from 0, or the line "otherwise". */
export const lineSchema = z.union([z.literal("default"), count]);
export type LineRef = z.infer<typeof lineSchema>;

export const snapshotSchema = robotReportSchema.extend({
  /** number of the snapshot; it rises with each one that the page sends */
  seq: count,
  /** running, paused (the page sleeps or the user paused) or gone (the page is closed) */
  state: z.enum(["running", "paused", "gone"]),
  /** who drives */
  driver: driverSchema,
  /** the line that decides now; null unless a program drives */
  line: lineSchema.nullable(),
  /** seq of the remote command that runs; null when none does */
  command: count.nullable(),
});
/** Everything that the robot reports, of one tick. */
export type Snapshot = z.infer<typeof snapshotSchema>;
