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
  /** it does not wait for those before it */
  readonly overtakes: boolean;
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

/** A stop, as JSON. */
export const STOP = '{"action":"stop"}';

export function isStop(text: string): boolean {
  return text === STOP;
}

/** The columns of a row, without its robot's. */
export const ROW_COLUMNS =
  "seq, driver, script, key, command, accepted_at, ttl, deadline, replaces, lease, " +
  "state, reason, recalled, pose, distance, epoch";
const COLUMNS = ROW_COLUMNS.split(", ").length;
const STATE = ROW_COLUMNS.split(", ").indexOf("state");

/**
 * An entry of the journal: a row as a step has left it.
 * @param forgotten up to which number the robot's commands that have ended are forgotten by that step; 0: none is
 */
export function entryOf(row: CommandRow, forgotten: number): string {
  const columns: unknown[] = columnsOf(row);
  columns.push(forgotten);
  return JSON.stringify(columns);
}

/** @throws SyntaxError when it is no entry */
export function rowIn(entry: string): { row: CommandRow; forgotten: number } {
  const columns = JSON.parse(entry) as unknown[];
  // Entries of the first journals end with the row.
  return { row: rowOf(columns), forgotten: Number(columns[COLUMNS] ?? 0) };
}

/** What an entry has for each of the columns. @throws SyntaxError when it is no entry */
export function columnsIn(entry: string): SQLInputValue[] {
  return (JSON.parse(entry) as SQLInputValue[]).slice(0, COLUMNS);
}

export function stateIn(columns: readonly SQLInputValue[]): CommandState {
  return columns[STATE] as CommandState;
}

/** What of a row is in each of its columns. */
function columnsOf(row: CommandRow): SQLInputValue[] {
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
    overtakes: replaces === 1 || isStop(text),
    state,
    reason,
    recalled,
    pose: pose === null ? null : (JSON.parse(pose) as CommandRecord["pose"]),
    distance,
    epoch,
  };
}

const newest = { at: Number.NaN, text: "" };

/** A time as text: many come in the same millisecond. */
function timeOf(at: number): string {
  if (at !== newest.at) Object.assign(newest, { at, text: new Date(at).toISOString() });
  return newest.text;
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
    acceptedAt: timeOf(row.acceptedAt),
    pose,
    distance,
    duplicate: false,
  };
}

export function termedOfRow(row: CommandRow): TermedRecord {
  const { driver, script, ttl, deadline, replace, lease } = row;
  return { record: recordOfRow(row), driver, script, ttl, deadline, replace, lease };
}
