/**
 * A command in the form in which the rules change it and stores hold it. Rows are validated before
 * they are written. Validating them again in each step took a third of the cost of a command.
 */
import type { CommandRecord, CommandState, RecallCause, RemoteCommand } from "@corridor/protocol";
import type { Overtaking } from "./overtaking.ts";
import { reasonText, type Reason } from "./reasons.ts";
import type { TermedRecord } from "./steps.ts";

export interface CommandRow {
  readonly seq: number;
  readonly driver: string;
  readonly script: string | null;
  readonly key: string | null;
  readonly command: RemoteCommand;
  /** the command as JSON, for comparison */
  readonly text: string;
  readonly acceptedAt: number;
  readonly ttl: number;
  readonly deadline: number;
  readonly replace: boolean;
  readonly lease: number | null;
  /** null: it waits for earlier commands */
  readonly overtakes: Overtaking | null;
  state: CommandState;
  reason: Reason | null;
  /** why it was cancelled although the robot already has it */
  recalled: RecallCause | null;
  pose: CommandRecord["pose"];
  distance: number | null;
  /** of the page to which it was delivered */
  epoch: number | null;
}

/** A command and its text. */
export interface KnownCommand {
  readonly command: RemoteCommand;
  /** the command as JSON */
  readonly text: string;
}

const MAX_KNOWN = 512;
/** Longer commands, with many conditions, are seldom sent twice. */
const MAX_KNOWN_LENGTH = 1_024;
const known = new Map<string, KnownCommand>();

/**
 * Interns commands, because robots receive the same few commands repeatedly. Equal commands share
 * one immutable object.
 * @param text a command as JSON
 * @throws SyntaxError if it is not JSON
 */
export function commandIn(text: string): KnownCommand {
  const before = known.get(text);
  if (before !== undefined) return before;
  // A shortened command has a digest in place of its conditions.
  const { digest: _digest, ...command } = JSON.parse(text) as RemoteCommand & { digest?: string };
  const made = { command: Object.freeze(command), text };
  if (text.length > MAX_KNOWN_LENGTH) return made;
  if (known.size >= MAX_KNOWN) known.clear();
  known.set(text, made);
  return made;
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
    reason: reason === null ? null : reasonText(reason, row.ttl),
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
