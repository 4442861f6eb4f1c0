/**
 * State events: changes of commands, numbered per robot. A reader that reconnects sends the last
 * number that it received and gets the events after it. A restarted relay starts a new stream of
 * numbers.
 */
import { z } from "zod";
import { commandRecordSchema } from "./command-record.ts";
import { commandStates } from "./command-state.ts";
import { snapshotSchema } from "./snapshot.ts";

/** The relay retains this many events per robot, for 10 minutes. */
export const MAX_STORED_EVENTS = 1_000;
export const EVENT_RETENTION_MS = 600_000;

/** An upper bound: fewer commands can be open at a time. */
const MAX_OPEN = 200;

const number = z
  .int({ error: "a whole number" })
  .min(0, { error: "0 or more" })
  .max(Number.MAX_SAFE_INTEGER, { error: "a whole number below 2^53" });

const streamError = "the 8 characters of a stream";
/** The stream that `n` belongs to. */
export const eventStreamSchema = z
  .string({ error: streamError })
  .regex(/^[A-Za-z0-9_]{8}$/, { error: streamError });

const sinceError = "STREAM-n of the last event that was received, such as k3J9x2aB-17";
/** The last event that a reader received: its stream and its `n`. */
export const sinceSchema = z
  .string({ error: sinceError })
  .regex(/^[A-Za-z0-9_]{8}-\d{1,15}$/, { error: sinceError });

/** A command of any script has a new state. */
export const stateEventSchema = z.strictObject({
  /** 1, 2, 3, ... in its stream */
  n: number,
  record: commandRecordSchema,
});
export type StateEvent = z.infer<typeof stateEventSchema>;

/** Replaces events that a reader missed and that the relay no longer retains. */
export const eventGapSchema = z.strictObject({
  /** the next event has the number after this one */
  n: number,
  /** the commands that have not ended; all others have */
  open: z.array(z.strictObject({ seq: number.min(1), state: z.enum(commandStates) })).max(MAX_OPEN),
});
export type EventGap = z.infer<typeof eventGapSchema>;

/** The response to a request that waits for events. */
export const eventPageSchema = z.strictObject({
  /** to send with the next request */
  since: sinceSchema,
  /** null if no events were missed */
  gap: eventGapSchema.nullable(),
  /** in order */
  states: z.array(stateEventSchema).max(MAX_STORED_EVENTS),
  /** the newest snapshot, never older than the states; null before the robot's first report */
  snapshot: snapshotSchema.nullable(),
});
export type EventPage = z.infer<typeof eventPageSchema>;

/** The value of `since`. */
export function sinceOf(stream: string, n: number): string {
  return `${stream}-${n}`;
}
