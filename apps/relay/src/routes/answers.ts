/** Answers that only HTTP has; the other shapes are the protocol's. The routes are typed by these. */
import {
  commandRecordSchema,
  driversSchema,
  mazeVersionSchema,
  robotIdSchema,
  snapshotSchema,
} from "@corridor/protocol";
import { z } from "zod";
import { limits } from "../sessions/limits.ts";

export const healthSchema = z.strictObject({ status: z.literal("ok") });
export type Health = z.infer<typeof healthSchema>;

export const readySchema = z.strictObject({
  status: z
    .enum(["ready", "degraded"])
    .describe("degraded: the disk is full, so that nothing new can be stored"),
});
export type Ready = z.infer<typeof readySchema>;

export const commandLogSchema = z.strictObject({
  /** in the order of their numbers */
  commands: z.array(commandRecordSchema).max(limits.logPage),
});
export type CommandLog = z.infer<typeof commandLogSchema>;

/** What is held of a robot, besides its commands. */
export const heldSessionSchema = z.strictObject({
  id: robotIdSchema,
  createdAt: z.iso.datetime(),
  lastUsedAt: z.iso.datetime(),
  endsInSeconds: z
    .int()
    .min(0)
    .describe(
      "until it is forgotten, however much it is used; earlier when nobody uses it for 2 h",
    ),
  drivers: driversSchema,
  maze: mazeVersionSchema
    .nullable()
    .describe("version of the maze that its page gave, to be read below; null while it gave none"),
  /** null while the robot has not reported */
  snapshot: snapshotSchema.nullable(),
});
export type HeldSession = z.infer<typeof heldSessionSchema>;
