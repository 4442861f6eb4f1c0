/** A command as an entry of the journal and of the tables in SQLite. */
import type { SQLInputValue } from "node:sqlite";
import { hasEnded, type CommandRecord, type CommandState } from "@corridor/protocol";
import { commandIn, type CommandRow } from "../../commands/command-row.ts";
import type { Overtaking } from "../../commands/overtaking.ts";
import { recallCauseIn, type Reason } from "../../commands/reasons.ts";
import type { Statements } from "./file/statements.ts";

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
  /** a string: the robot's sentence, or one that an earlier version of Corridor stored */
  reason: Reason | null,
  recalled: string | null,
  pose: string | null,
  distance: number | null,
  epoch: number | null,
  deletedTo: number,
  overtakes: Overtaking | null,
  /** for queries */
  isOpen: 0 | 1,
];

/**
 * Serialises a row for the journal and the tables.
 * @param deletedTo highest seq up to which this step deletes the robot's ended commands; 0: none
 */
export function entryOf(row: CommandRow, deletedTo: number): string {
  const { seq, driver, script, key, text, acceptedAt, ttl, deadline, replace, lease } = row;
  const { state, reason, recalled, pose, distance, epoch, overtakes } = row;
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
    deletedTo,
    overtakes,
    hasEnded(state) ? 0 : 1,
  ];
  return JSON.stringify(entry);
}

/** @throws SyntaxError if the text is not an entry */
export function rowIn(entry: string): { row: CommandRow; deletedTo: number } {
  const [seq, driver, script, key, text, acceptedAt, ttl, deadline, replaces, lease, ...rest] =
    JSON.parse(entry) as Entry;
  const [state, reason, recalled, pose, distance, epoch, deletedTo, overtakes] = rest;
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
    overtakes,
    state,
    reason,
    recalled: recallCauseIn(recalled),
    pose: pose === null ? null : (JSON.parse(pose) as CommandRecord["pose"]),
    distance,
    epoch,
  };
  return { row, deletedTo };
}

/** The rows in the column `entry` of a query. */
export function rowsIn(statements: Statements, sql: string, values: SQLInputValue[]): CommandRow[] {
  return statements.all(sql, values).map(({ entry }) => rowIn(String(entry)).row);
}
