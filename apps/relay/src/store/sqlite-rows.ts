/**
 * Rows of commands in SQLite, read as records. Their tables are STRICT, and what stands in them was checked
 * before it was written: to check it again at each step took a third of what a command costs.
 */
import type { SQLInputValue } from "node:sqlite";
import type { CommandRecord } from "@corridor/protocol";
import type { TermedRecord } from "./session-store.ts";
import type { Statements } from "./statements.ts";

interface RecordRow extends Pick<CommandRecord, "seq" | "key" | "state" | "reason" | "distance"> {
  /** JSON */
  command: string;
  accepted_at: number;
  /** JSON */
  pose: string | null;
}

interface TermedRow extends RecordRow, Omit<TermedRecord, "record" | "replace"> {
  replaces: 0 | 1;
}

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
  const rows = statements.all(sql, values) as unknown as RecordRow[];
  return rows.map(readRecord).toSorted((a, b) => a.seq - b.seq);
}

/** The same, with what was asked beside them. */
export function termedIn(
  statements: Statements,
  sql: string,
  values: SQLInputValue[],
): TermedRecord[] {
  const rows = statements.all(sql, values) as unknown as TermedRow[];
  return rows
    .map((row) => {
      const { driver, script, ttl, deadline, replaces, lease } = row;
      const record = readRecord(row);
      return { record, driver, script, ttl, deadline, replace: replaces === 1, lease };
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

function readRecord(row: RecordRow): CommandRecord {
  const { seq, key, state, reason, distance, pose } = row;
  const command = JSON.parse(row.command) as CommandRecord["command"];
  return {
    seq,
    key,
    action: command.action,
    command,
    state,
    reason,
    acceptedAt: new Date(row.accepted_at).toISOString(),
    pose: pose === null ? null : (JSON.parse(pose) as CommandRecord["pose"]),
    distance,
    duplicate: false,
  };
}
