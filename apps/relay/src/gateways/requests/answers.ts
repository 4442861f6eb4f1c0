/**
 * Schemas of the responses that only the HTTP API has. The protocol package defines the others.
 * Route types derive from them.
 */
import {
  commandRecordSchema,
  driversSchema,
  mazeVersionSchema,
  robotIdSchema,
  snapshotSchema,
} from "@corridor/protocol";
import { z } from "zod";
import { limits } from "../../platform/limits/limits.ts";

export const healthSchema = z.strictObject({ status: z.literal("ok") });
export type Health = z.infer<typeof healthSchema>;

export const readySchema = z.strictObject({
  status: z
    .enum(["ready", "degraded"])
    .describe("degraded: the disk is full, so the relay stores no new data"),
});
export type Ready = z.infer<typeof readySchema>;

export const commandLogSchema = z.strictObject({
  /** in order of their numbers */
  commands: z.array(commandRecordSchema).max(limits.logPage),
});
export type CommandLog = z.infer<typeof commandLogSchema>;

/** Stored state of a robot, without its commands. */
export const heldSessionSchema = z.strictObject({
  id: robotIdSchema,
  createdAt: z.iso.datetime(),
  lastUsedAt: z.iso.datetime(),
  endsInSeconds: z
    .int()
    .min(0)
    .describe(
      "until the robot is deleted at the latest; it is deleted earlier after 2 h without use",
    ),
  drivers: driversSchema,
  maze: mazeVersionSchema
    .nullable()
    .describe("version of the maze that its page published; null if there is none"),
  /** null until the robot has reported */
  snapshot: snapshotSchema.nullable(),
});
export type HeldSession = z.infer<typeof heldSessionSchema>;
