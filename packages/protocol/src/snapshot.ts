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
  sensors: sensorReadingsSchema,
  pose: poseSchema,
  /** the action that moves the robot now */
  motion: z.string().max(40),
  bumps: count,
  bumping: z.boolean(),
  goalReached: z.boolean(),
});
export type RobotReport = z.infer<typeof robotReportSchema>;

/** A program line by its index from 0, or the line "otherwise". */
export const lineSchema = z.union([z.literal("default"), count]);
export type LineRef = z.infer<typeof lineSchema>;

export const snapshotSchema = robotReportSchema.extend({
  /** rises with every snapshot that the page sends */
  seq: count,
  /** running, paused (the page sleeps or the user paused), gone (the page is away) */
  state: z.enum(["running", "paused", "gone"]),
  driver: driverSchema,
  /** the line that decides now; null unless a program drives */
  line: lineSchema.nullable(),
  /** seq of the remote command that runs; null when none does */
  command: count.nullable(),
});
export type Snapshot = z.infer<typeof snapshotSchema>;
