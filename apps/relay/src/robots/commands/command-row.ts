/**
 * A command in the form in which the SQLite store holds it. Rows are validated before they are
 * written. Validating them again in each step took a third of the cost of a command.
 */
import type { Command, CommandRecord, CommandState } from "@corridor/protocol";
import { commandIn } from "./known-commands.ts";
import type { TermedRecord } from "../../store/session-store.ts";

export interface CommandRow {
  readonly seq: number;
  readonly driver: string;
  readonly script: string | null;
  readonly key: string | null;
  readonly command: Command;
  /** the command as JSON, for comparison */
  readonly text: string;
  readonly acceptedAt: number;
  readonly ttl: number;
  readonly deadline: number;
  readonly replace: boolean;
  readonly lease: number | null;
  /** it does not wait for earlier commands */
  readonly overtakes: boolean;
  state: CommandState;
  reason: string | null;
  /** why it was cancelled although the robot already has it */
  recalled: string | null;
  pose: CommandRecord["pose"];
  distance: number | null;
  /** of the page to which it was delivered */
  epoch: number | null;
}

/** Layout of a journal entry. The tables read the same positions, so they must not change. */
type Entry = [
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
  state: CommandState,
  reason: string | null,
  recalled: string | null,
  pose: string | null,
  distance: number | null,
  epoch: number | null,
  /** missing in entries of the first journals */
  forgotten?: number,
];

/** A stop command as JSON. */
export const STOP = '{"action":"stop"}';

export function isStop(text: string): boolean {
  return text === STOP;
}

/**
 * Serialises a row for the journal and the tables.
 * @param forgotten highest seq up to which this step deletes the robot's ended commands; 0: none
 */
export function entryOf(row: CommandRow, forgotten: number): string {
  const { seq, driver, script, key, text, acceptedAt, ttl, deadline, replace, lease } = row;
  const { state, reason, recalled, pose, distance, epoch } = row;
  const entry: Entry = [
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
    forgotten,
  ];
  return JSON.stringify(entry);
}

/** @throws SyntaxError if the text is not an entry */
export function rowIn(entry: string): { row: CommandRow; forgotten: number } {
  const [seq, driver, script, key, text, acceptedAt, ttl, deadline, replaces, lease, ...rest] =
    JSON.parse(entry) as Entry;
  const [state, reason, recalled, pose, distance, epoch, forgotten = 0] = rest;
  const row: CommandRow = {
    seq,
    driver,
    script,
    key,
    ...commandIn(text),
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
  return { row, forgotten };
}

const newest = { at: Number.NaN, text: "" };

/** Formats a time. Many commands arrive in the same millisecond, so the last result is reused. */
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
