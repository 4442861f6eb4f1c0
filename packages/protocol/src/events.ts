/**
 * State events: what became of commands, numbered for each robot, so that a reader that comes back says
 * which it was told last and gets the rest. A relay that was restarted counts anew, in another stream.
 */
import { z } from "zod";
import { commandRecordSchema, commandStates } from "./command-record.ts";
import { snapshotSchema } from "./snapshot.ts";

/** The newest events of a robot that are kept, and for how long: 10 minutes. */
export const MAX_STORED_EVENTS = 1_000;
export const EVENT_RETENTION_MS = 600_000;

/** More commands than can be open at once. */
const MAX_OPEN = 200;

const number = z
  .int({ error: "a whole number" })
  .min(0, { error: "0 or more" })
  .max(Number.MAX_SAFE_INTEGER, { error: "a whole number below 2^53" });

const streamError = "the 8 characters of a stream";
/** Which series of numbers `n` belongs to. */
export const eventStreamSchema = z
  .string({ error: streamError })
  .regex(/^[A-Za-z0-9_]{8}$/, { error: streamError });

const sinceError = "STREAM-n of the last state that was told, such as k3J9x2aB-17";
/** The last event that a reader was told: its stream and its `n`. */
export const sinceSchema = z
  .string({ error: sinceError })
  .regex(/^[A-Za-z0-9_]{8}-\d{1,15}$/, { error: sinceError });

/** A command of the robot, whoever sent it, has a new state. */
export const stateEventSchema = z.strictObject({
  /** 1, 2, 3 in its stream */
  n: number,
  record: commandRecordSchema,
});
export type StateEvent = z.infer<typeof stateEventSchema>;

/** States that a reader missed and that are not kept: the current ones in their place. */
export const eventGapSchema = z.strictObject({
  /** goes on from here */
  n: number,
  /** the commands that have not ended; every other one has */
  open: z.array(z.strictObject({ seq: number.min(1), state: z.enum(commandStates) })).max(MAX_OPEN),
});
export type EventGap = z.infer<typeof eventGapSchema>;

/** The answer to a request that waits for events. */
export const eventPageSchema = z.strictObject({
  /** for the next request */
  since: sinceSchema,
  /** null when nothing was missed */
  gap: eventGapSchema.nullable(),
  /** in their order */
  states: z.array(stateEventSchema).max(MAX_STORED_EVENTS),
  /** the newest; null while the robot has not reported. Never older than the states */
  snapshot: snapshotSchema.nullable(),
});
export type EventPage = z.infer<typeof eventPageSchema>;

/** The text of `since`. */
export function sinceOf(stream: string, n: number): string {
  return `${stream}-${n}`;
}
