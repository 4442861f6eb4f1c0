/** A command as a JSON object in Redis. Values that Lua would round are stored as text. */
import { commandRecordSchema, type Ending } from "@corridor/protocol";
import { z } from "zod";
import type { NewCommand, TermedRecord } from "../session-store.ts";

const row = z.object({
  seq: z.int(),
  key: z.string().nullable(),
  command: z.string(),
  state: z.string(),
  reason: z.string().nullable(),
  acceptedAt: z.number(),
  pose: z.string().nullable(),
  distance: z.string().nullable(),
  driver: z.string(),
  // Rows of earlier versions lack it.
  script: z.string().nullable().default(null),
  ttl: z.number(),
  deadline: z.number(),
  replace: z.boolean(),
  lease: z.number().nullable(),
});
const actionOf = z.object({ action: z.string() });

/** Parses the row of a command. */
export const termedRow = row.transform((given): TermedRecord => {
  const { driver, script, ttl, deadline, replace, lease, ...shown } = given;
  const { command, pose, distance, acceptedAt, ...rest } = shown;
  const parsed: unknown = JSON.parse(command);
  const record = commandRecordSchema.parse({
    ...rest,
    action: actionOf.parse(parsed).action,
    command: parsed,
    acceptedAt: new Date(acceptedAt).toISOString(),
    pose: pose === null ? null : JSON.parse(pose),
    distance: distance === null ? null : JSON.parse(distance),
    duplicate: false,
  });
  return { record, driver, script, ttl, deadline, replace, lease };
});
/** Parses a row into a record, without the details that only the relay and the robot need. */
export const recordRow = termedRow.transform(({ record }) => record);

/** The row of a new command. Redis assigns its seq. */
export function rowOf(given: NewCommand): unknown {
  const { driver, script, key, command, acceptedAt, ttl, deadline, replace, lease } = given;
  return {
    driver,
    script,
    key,
    command: JSON.stringify(command),
    stop: command.action === "stop",
    state: "accepted",
    reason: null,
    acceptedAt,
    pose: null,
    distance: null,
    ttl: Math.round(ttl),
    deadline: Math.round(deadline),
    replace,
    lease: lease === null ? null : Math.round(lease),
  };
}

export function endingOf({ pose, distance, ...rest }: Ending): unknown {
  return {
    ...rest,
    pose: pose === null ? null : JSON.stringify(pose),
    distance: distance === null ? null : JSON.stringify(distance),
  };
}
