/**
 * One command as a store on disk keeps it, in the order of its columns. What stands in a row was checked before
 * it was written: to check it again at each step took a third of what a command costs.
 */
import type { SQLInputValue } from "node:sqlite";
import type { Command, CommandRecord, CommandState } from "@corridor/protocol";
import type { TermedRecord } from "./session-store.ts";

export interface CommandRow {
  readonly seq: number;
  readonly driver: string;
  readonly script: string | null;
  readonly key: string | null;
  readonly command: Command;
  /** the command as JSON, by which two are compared */
  readonly text: string;
  readonly acceptedAt: number;
  readonly ttl: number;
  readonly deadline: number;
  readonly replace: boolean;
  readonly lease: number | null;
  state: CommandState;
  reason: string | null;
  /** why it was taken back, though the robot has it */
  recalled: string | null;
  pose: CommandRecord["pose"];
  distance: number | null;
  /** of the page that it was delivered to */
  epoch: number | null;
}

type TermColumns = [
  seq: number,
  driver: string,
  script: string | null,
  key: string | null,
  text: string,
  acceptedAt: number,
  ttl: number,
  deadline: number,
  replaces: 0 | 1,
  lease: number | null,
];
type StateColumns = [
  state: CommandState,
  reason: string | null,
  recalled: string | null,
  pose: string | null,
  distance: number | null,
  epoch: number | null,
];

/** The columns of a row, without its robot's. */
export const ROW_COLUMNS =
  "seq, driver, script, key, command, accepted_at, ttl, deadline, replaces, lease, " +
  "state, reason, recalled, pose, distance, epoch";

/** What of a row is in each of its columns. */
export function columnsOf(row: CommandRow): SQLInputValue[] {
  const { seq, driver, script, key, text, acceptedAt, ttl, deadline, replace, lease } = row;
  const { state, reason, recalled, pose, distance, epoch } = row;
  return [
    seq,
    driver,
    script,
    key,
    text,
    acceptedAt,
    ttl,
    deadline,
    replace ? 1 : 0,
    lease,
    state,
    reason,
    recalled,
    pose === null ? null : JSON.stringify(pose),
    distance,
    epoch,
  ];
}

/** @param columns as `columnsOf` gives them */
export function rowOf(columns: readonly unknown[]): CommandRow {
  const [seq, driver, script, key, text, acceptedAt, ttl, deadline, replaces, lease] =
    columns as TermColumns;
  const [state, reason, recalled, pose, distance, epoch] = columns.slice(10) as StateColumns;
  return {
    seq,
    driver,
    script,
    key,
    command: JSON.parse(text) as Command,
    text,
    acceptedAt,
    ttl,
    deadline,
    replace: replaces === 1,
    lease,
    state,
    reason,
    recalled,
    pose: pose === null ? null : (JSON.parse(pose) as CommandRecord["pose"]),
    distance,
    epoch,
  };
}

export function recordOfRow(row: CommandRow): CommandRecord {
  const { seq, key, command, state, reason, pose, distance } = row;
  return {
    seq,
    key,
    action: command.action,
    command,
    state,
    reason,
    acceptedAt: new Date(row.acceptedAt).toISOString(),
    pose,
    distance,
    duplicate: false,
  };
}

export function termedOfRow(row: CommandRow): TermedRecord {
  const { driver, script, ttl, deadline, replace, lease } = row;
  return { record: recordOfRow(row), driver, script, ttl, deadline, replace, lease };
}
