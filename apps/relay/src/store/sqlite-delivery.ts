/**
 * What is sent to a robot's page, and what it has begun. To be called in one step.
 *
 * Rows are looked for first and changed one by one by their key. One statement that finds, changes and
 * returns them needs tables of its own for that, which took a third of a millisecond, most often to find
 * that nothing waits.
 */
import type { CommandRecord } from "@corridor/protocol";
import { CLOCK_TOLERANCE_MS, type TermedRecord } from "./session-store.ts";
import { OVERTAKES, recordOf } from "./sqlite-overtaking.ts";
import { numberIn, TERMED, termedIn } from "./sqlite-rows.ts";
import { IS_OPEN, OPEN_COMMANDS } from "./sqlite-schema.ts";
import type { Statements } from "./statements.ts";

/** Condition of an accepted command that must not start any more at the time ?1. */
export const IS_LATE = `(deadline <= ?1 OR accepted_at > ?1 + ${CLOCK_TOLERANCE_MS})`;

const WAITING = `SELECT seq, ${OVERTAKES} AS overtakes FROM ${OPEN_COMMANDS}
  WHERE robot = ?2 AND state = 'accepted' AND ${IS_OPEN} AND NOT ${IS_LATE} ORDER BY seq`;
const DELIVERED = "UPDATE commands SET state = 'delivered', epoch = ? WHERE robot = ? AND seq = ?";
const ONE = `SELECT ${TERMED} FROM commands WHERE robot = ? AND seq = ?`;
const STARTED = `UPDATE commands SET state = 'started'
  WHERE robot = ?1 AND seq = ?3 AND state = 'delivered'
    AND EXISTS (SELECT 1 FROM sessions WHERE id = ?1 AND epoch = ?2)`;

/** Commands in a state, without those that overtake. */
export function countIn(
  statements: Statements,
  id: string,
  state: "accepted" | "delivered",
): number {
  const sql = `SELECT count(*) AS found FROM ${OPEN_COMMANDS}
    WHERE robot = ? AND state = '${state}' AND ${IS_OPEN} AND NOT ${OVERTAKES}`;
  return numberIn(statements, sql, [id]) ?? 0;
}

/** accepted → delivered, in order: as many as the window has room for, and all that overtake. */
export function deliver(
  statements: Statements,
  id: string,
  { epoch, window, now }: { epoch: number; window: number; now: number },
): TermedRecord[] {
  const waiting = statements.all(WAITING, [now, id]);
  if (waiting.length === 0 || epochOf(statements, id) !== epoch) return [];
  const free = window - countIn(statements, id, "delivered");
  const due = waiting.filter(({ overtakes }, at) => at < free || overtakes === 1);
  return due.flatMap((row) => {
    const seq = Number(row["seq"]);
    statements.run(DELIVERED, [epoch, id, seq]);
    return termedIn(statements, ONE, [id, seq]);
  });
}

/** delivered → started. @returns null when it was not delivered, or the epoch is not the newest */
export function begin(
  statements: Statements,
  id: string,
  { epoch, seq }: { epoch: number; seq: number },
): CommandRecord | null {
  return statements.run(STARTED, [id, epoch, seq]) > 0 ? recordOf(statements, id, seq) : null;
}

/** Raised each time a page takes the robot. @returns null when there is no such robot */
export function epochOf(statements: Statements, id: string): number | null {
  const sql = "SELECT epoch AS found FROM sessions WHERE id = ?";
  return numberIn(statements, sql, [id]);
}
