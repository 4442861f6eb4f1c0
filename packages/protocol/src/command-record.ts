/** The record of one remote command. Times are ISO 8601 in UTC. */
import { z } from "zod";
import { recordActionSchema, recordedCommandSchema } from "./command.ts";
import { commandStates } from "./command-state.ts";
import { poseSchema } from "./quantities.ts";

export const idempotencyKeySchema = z
  .string({ error: "8 to 64 letters, digits, - or _" })
  .regex(/^[A-Za-z0-9_-]{8,64}$/, { error: "8 to 64 letters, digits, - or _" });

export const commandRecordSchema = z.strictObject({
  /** number of the command of this robot: 1, 2, 3, ... */
  seq: z.int().min(1).max(Number.MAX_SAFE_INTEGER),
  /** the idempotency key; null if the sender gave none */
  key: idempotencyKeySchema.nullable(),
  /** such as `move` or `left 90`. An open list: readers accept actions that they do not know */
  action: recordActionSchema,
  /** the command with its parameters. Old records have no `until` */
  command: recordedCommandSchema,
  /**
   * accepted, delivered, started, or an ending: completed, collided, cancelled, superseded or
   * expired
   */
  state: z.enum(commandStates),
  /**
   * why it ended, or what to check while it does not, as a sentence; null if there is nothing to
   * explain
   */
  reason: z.string().max(200).nullable(),
  /** when the relay stored it, in UTC */
  acceptedAt: z.iso.datetime(),
  /** where the robot was when the command ended; null before that */
  pose: poseSchema.nullable(),
  /** cm driven by this command, 0 or more; null before its end */
  distance: z.number().min(0).nullable(),
  /** true in the response to a retry of a stored command */
  duplicate: z.boolean(),
});
/** The record of one command. */
export type CommandRecord = z.infer<typeof commandRecordSchema>;
