/**
 * Finds commands of a robot, first in memory and then in the tables. Must be called within a step.
 */
import type { CommandRecord } from "@corridor/protocol";
import { recordOfRow, STOP, type CommandRow } from "../../commands/command-row.ts";
import { newestOvertaking as newestOf } from "../../commands/state-machine.ts";
import type { LiveRobot } from "./live-robot.ts";
import { numberIn, rowsIn } from "./sqlite-rows.ts";
import type { Statements } from "./file/statements.ts";

const BY_KEY = "SELECT entry FROM commands WHERE robot = ? AND driver = ? AND key = ?";
const BY_SEQ = "SELECT entry FROM commands WHERE robot = ? AND seq = ?";
const AFTER = "SELECT entry FROM commands WHERE robot = ? AND seq > ? ORDER BY seq LIMIT ?";

export function rowWith(
  statements: Statements,
  id: string,
  robot: LiveRobot,
  seq: number,
): CommandRow | null {
  const { commands } = robot;
  const known = commands.row(seq);
  if (known !== null || seq <= commands.deletedUpTo) return known;
  return rowsIn(statements, BY_SEQ, [id, seq])[0] ?? null;
}

export function recordOf(
  statements: Statements,
  id: string,
  robot: LiveRobot,
  seq: number,
): CommandRecord | null {
  const row = rowWith(statements, id, robot, seq);
  return row && recordOfRow(row);
}

/** The command with this idempotency key. */
export function withKey(
  statements: Statements,
  id: string,
  robot: LiveRobot,
  { driver, key }: { driver: string; key: string },
): CommandRow | null {
  const atHand = robot.commands.withKey(driver, key);
  if (atHand !== null) return atHand;
  const [row] = robot.mayHaveLeft(driver, key) ? rowsIn(statements, BY_KEY, [id, driver, key]) : [];
  return row === undefined || row.seq <= robot.commands.deletedUpTo ? null : row;
}

/** Commands with a higher seq, in order. */
export function recordsAfter(
  statements: Statements,
  id: string,
  { commands: robot }: LiveRobot,
  { seq, limit }: { seq: number; limit: number },
): CommandRecord[] {
  const inTable = rowsIn(statements, AFTER, [id, Math.max(seq, robot.deletedUpTo), limit]);
  const bySeq = new Map(inTable.map((row) => [row.seq, row]));
  for (const row of robot.rows()) if (row.seq > seq) bySeq.set(row.seq, row);
  const rows = [...bySeq.values()].toSorted((a, b) => a.seq - b.seq);
  return rows.slice(0, limit).map(recordOfRow);
}

/** The highest seq of a stop or a replacing command after `after`; null if there is none. */
export function newestOvertaking(
  statements: Statements,
  id: string,
  { commands: robot }: LiveRobot,
  { what, after }: { what: "stop" | "replace"; after: number },
): number | null {
  const condition = what === "stop" ? `command = '${STOP}'` : "replaces = 1";
  const sql = `SELECT max(seq) AS found FROM commands WHERE robot = ? AND seq > ? AND ${condition}`;
  const inTable = numberIn(statements, sql, [id, Math.max(after, robot.deletedUpTo)]);
  const atHand = newestOf(robot.rows(), what, after);
  return atHand === null ? inTable : Math.max(inTable ?? atHand, atHand);
}
