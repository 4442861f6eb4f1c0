/**
 * How long the conditions of a guarded motion are stored: until its command has ended, and then
 * while it is one of the newest ended commands. Without this limit, the conditions of a robot would
 * need a hundred times the space of its commands.
 *
 * Readers see exactly this. The rows are shortened a little later, many at a time.
 */
import { createHash } from "node:crypto";
import { hasEnded, type CommandRecord } from "@corridor/protocol";
import { commandIn, recordOfRow, type CommandRow, type RobotCommands } from "./robot-commands.ts";

/** Ended commands that retain their conditions. */
export const GUARDED_RECORDS = 200;
/** New commands between two looks at the ended ones. */
const INTERVAL = 50;
/** Commands to look at: more than an interval, because the number of open commands changes. */
const RANGE = 2 * INTERVAL;

/** Ended commands up to this seq have no conditions. @param open seqs of the open commands */
export function conditionsEndAt(lastSeq: number, open: Iterable<number>): number {
  let seq = lastSeq - GUARDED_RECORDS;
  for (const each of [...open].toSorted((a, b) => b - a)) if (each > seq) seq -= 1;
  return seq;
}

function endOf({ admissionState, open }: RobotCommands): number {
  const seqs = [...open].map(({ seq }) => seq);
  return conditionsEndAt(admissionState.lastSeq, seqs);
}

/** The record for readers. @param endAt of `conditionsEndAt`, if it is needed */
export function shownRecord(row: CommandRow, endAt: () => number): CommandRecord {
  const isOld = row.command.until !== undefined && hasEnded(row.state) && row.seq <= endAt();
  return recordOfRow(isOld ? { ...row, ...shortened(row) } : row);
}

/** The record for readers of a robot in memory. */
export function shownRecordIn(commands: RobotCommands, row: CommandRow): CommandRecord {
  return shownRecord(row, () => endOf(commands));
}

/** Ended commands to shorten with the next command; null: none. */
export function toShorten(commands: RobotCommands): { after: number; upTo: number } | null {
  if ((commands.admissionState.lastSeq + 1) % INTERVAL !== 0) return null;
  const upTo = endOf(commands);
  return upTo <= commands.deletedUpTo ? null : { after: upTo - RANGE, upTo };
}

/** Removes the conditions of these ended commands. */
export function shorten(commands: RobotCommands, ended: readonly CommandRow[]): void {
  for (const row of ended) {
    if (row.command.until !== undefined) commands.change(row, shortened(row));
  }
}

/** Whether a stored command, which may be shortened, is the same as a new one. */
export function isSameCommand(stored: CommandRow, text: string): boolean {
  return stored.text === text || stored.text === shortText(text);
}

function shortened({ text }: CommandRow): Pick<CommandRow, "command" | "text"> {
  return commandIn(shortText(text));
}

/** The command with a digest in place of its conditions, so that it can still be compared. */
function shortText(text: string): string {
  const { until, ...command } = commandIn(text).command;
  if (until === undefined) return text;
  const digest = createHash("sha256").update(text).digest("base64url").slice(0, 22);
  return JSON.stringify({ ...command, digest });
}
