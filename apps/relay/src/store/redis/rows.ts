/** A command as a JSON object in Redis. */
import { commandRecordSchema } from "@corridor/protocol";
import { z } from "zod";
import { causes, recallCauseIn } from "../../commands/reasons.ts";
import {
  termedOfRow,
  commandIn,
  type CommandRow,
  overtakingOf,
} from "../../commands/robot-commands.ts";

const { state, pose, distance } = commandRecordSchema.shape;

const stored = z.object({
  seq: z.int(),
  driver: z.string(),
  script: z.string().nullable(),
  key: z.string().nullable(),
  command: z.string(),
  acceptedAt: z.number(),
  ttl: z.number(),
  deadline: z.number(),
  replace: z.boolean(),
  lease: z.number().nullable(),
  state,
  reason: z
    .union([z.string(), z.object({ cause: z.enum(causes), by: z.int().nullable() })])
    .nullable(),
  recalled: z.string().nullable().transform(recallCauseIn),
  pose,
  distance,
  epoch: z.int().nullable(),
});

/** Parses the row of a command. */
const commandRow = stored.transform(({ command: text, ...row }): CommandRow => {
  const known = commandIn(text);
  return { ...row, ...known, overtakes: overtakingOf(known.command, row.replace) };
});
/** Parses a row into what a relay shows of the command and sends to the robot. */
export const termedRow = commandRow.transform(termedOfRow);

/** @throws Error if the text is not a row */
export function rowIn(text: string): CommandRow {
  return commandRow.parse(JSON.parse(text));
}

export function textOf({ command: _command, text, overtakes: _overtakes, ...row }: CommandRow) {
  const values: z.input<typeof stored> = { ...row, command: text };
  return JSON.stringify(values);
}
