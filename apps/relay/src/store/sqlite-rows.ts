/** Rows of commands in SQLite, read as records. */
import type { SQLInputValue } from "node:sqlite";
import { commandRecordSchema, type CommandRecord } from "@corridor/protocol";
import { z } from "zod";
import type { TermedRecord } from "./session-store.ts";
import type { Statements } from "./statements.ts";

const recordRow = z.object({
  seq: z.int(),
  key: z.string().nullable(),
  command: z.string(),
  state: z.string(),
  reason: z.string().nullable(),
  accepted_at: z.int(),
  pose: z.string().nullable(),
  distance: z.number().nullable(),
});
const termsRow = z.object({
  driver: z.string(),
  script: z.string().nullable(),
  ttl: z.number(),
  deadline: z.number(),
  replaces: z.int(),
  lease: z.number().nullable(),
});
const actionOf = z.object({ action: z.string() });

/** The columns that `recordsIn` reads. */
export const RECORD = "seq, key, command, state, reason, accepted_at, pose, distance";
/** The columns that `termedIn` reads. */
export const TERMED = `${RECORD}, driver, script, ttl, deadline, replaces, lease`;

/** Commands in the order of their numbers: RETURNING gives rows in no promised order. */
export function recordsIn(
  statements: Statements,
  sql: string,
  values: SQLInputValue[],
): CommandRecord[] {
  return statements
    .all(sql, values)
    .map(readRecord)
    .toSorted((a, b) => a.seq - b.seq);
}

/** The same, with what was asked beside them. */
export function termedIn(
  statements: Statements,
  sql: string,
  values: SQLInputValue[],
): TermedRecord[] {
  return statements
    .all(sql, values)
    .map((row) => {
      const { replaces, ...terms } = termsRow.parse(row);
      return { record: readRecord(row), ...terms, replace: replaces === 1 };
    })
    .toSorted((a, b) => a.record.seq - b.record.seq);
}

/** The column `found` of the first row; null where there is none. */
export function numberIn(
  statements: Statements,
  sql: string,
  values: SQLInputValue[],
): number | null {
  const found = statements.all(sql, values)[0]?.["found"];
  return typeof found === "number" ? found : null;
}

function readRecord(row: unknown): CommandRecord {
  const { command, pose, accepted_at, ...rest } = recordRow.parse(row);
  const parsed: unknown = JSON.parse(command);
  const { action } = actionOf.parse(parsed);
  return commandRecordSchema.parse({
    ...rest,
    action,
    command: parsed,
    acceptedAt: new Date(accepted_at).toISOString(),
    pose: pose === null ? null : JSON.parse(pose),
    duplicate: false,
  });
}
