/**
 * What a stop, or a command that replaces, does to what was accepted before it; and what becomes of a
 * robot's commands when a page takes it. To be called in one step.
 */
import type { CommandRecord, Ending } from "@corridor/protocol";
import { doubtReasons, type PageState, type TermedRecord } from "./session-store.ts";
import { numberIn, RECORD, recordsIn, TERMED, termedIn } from "./sqlite-rows.ts";
import { IS_OPEN, OPEN_COMMANDS } from "./sqlite-schema.ts";
import type { Statements } from "./statements.ts";

export const STOP = '{"action":"stop"}';
/** Condition of the commands that do not wait for those before them. */
export const OVERTAKES = `(command = '${STOP}' OR replaces = 1)`;

/** Ends what was accepted before a command that overtakes. */
export function overtake(
  statements: Statements,
  id: string,
  { seq, isStop }: { seq: number; isStop: boolean },
): TermedRecord[] {
  const [state, words] = isStop ? ["cancelled", "stopped"] : ["superseded", "replaced"];
  return termedIn(
    statements,
    `UPDATE ${OPEN_COMMANDS} SET state = ?, is_open = 0, reason = ?
     WHERE robot = ? AND state = 'accepted' AND ${IS_OPEN} AND seq < ? RETURNING ${TERMED}`,
    [state ?? "", `${words ?? ""} by command ${seq}`, id, seq],
  );
}

/** Takes back all that a key or a script has sent, or all but stops. @returns what waited, and has ended by this */
export function recallAllOf(
  statements: Statements,
  id: string,
  whose: { driver: string } | { script: string } | "all",
  reason: string,
): TermedRecord[] {
  const [condition, mark] = conditionOf(whose);
  const mine = `robot = ? AND ${condition} AND ${IS_OPEN}`;
  statements.run(
    `UPDATE ${OPEN_COMMANDS} SET recalled = coalesce(recalled, ?)
     WHERE ${mine} AND state IN ('delivered', 'started')`,
    [reason, id, mark],
  );
  return termedIn(
    statements,
    `UPDATE ${OPEN_COMMANDS} SET state = 'cancelled', is_open = 0, reason = ?
     WHERE ${mine} AND state = 'accepted' RETURNING ${TERMED}`,
    [reason, id, mark],
  );
}

function conditionOf(whose: Parameters<typeof recallAllOf>[2]): [condition: string, mark: string] {
  if (whose === "all") return ["command <> ?", STOP];
  return "driver" in whose ? ["driver = ?", whose.driver] : ["script = ?", whose.script];
}

/** delivered or started → its ending. @returns null when it was neither */
export function end(statements: Statements, id: string, ending: Ending): CommandRecord | null {
  const { seq, state, reason, pose, distance } = ending;
  const changes = statements.run(
    `UPDATE commands SET state = ?, is_open = 0, reason = ?, pose = ?, distance = ?
     WHERE robot = ? AND seq = ? AND state IN ('delivered', 'started')`,
    [state, reason, pose === null ? null : JSON.stringify(pose), distance, id, seq],
  );
  return changes > 0 ? recordOf(statements, id, seq) : null;
}

export function recordOf(statements: Statements, id: string, seq: number): CommandRecord | null {
  const sql = `SELECT ${RECORD} FROM commands WHERE robot = ? AND seq = ?`;
  return recordsIn(statements, sql, [id, seq])[0] ?? null;
}

/** Brings the commands of a robot to what the page that takes it says of itself. */
export function meetPage(
  statements: Statements,
  id: string,
  page: PageState & { isSettled: boolean },
) {
  const changed: CommandRecord[] = [];
  const refused: CommandRecord[] = [];
  for (const ending of page.endings) {
    const record = end(statements, id, ending);
    if (record !== null) {
      changed.push(record);
      continue;
    }
    const known = recordOf(statements, id, ending.seq);
    if (known !== null && known.state !== ending.state) refused.push(known);
  }
  changed.push(
    ...recordsIn(
      statements,
      `UPDATE ${OPEN_COMMANDS} SET
         state = CASE WHEN seq <= ?1 THEN 'started'
           WHEN coalesce(?3, recalled) IS NULL THEN 'accepted' ELSE 'cancelled' END,
         is_open = (seq <= ?1 OR coalesce(?3, recalled) IS NULL),
         reason = CASE WHEN seq <= ?1 THEN NULL ELSE coalesce(?3, recalled) END
       WHERE robot = ?2 AND state = 'delivered' AND ${IS_OPEN} RETURNING ${RECORD}`,
      [page.lastApplied, id, page.isSettled ? null : doubtReasons.delivered],
    ),
  );
  if (page.fresh || !page.isSettled) {
    changed.push(
      ...recordsIn(
        statements,
        `UPDATE ${OPEN_COMMANDS} SET state = 'cancelled', is_open = 0, reason = ?
         WHERE robot = ? AND state = 'started' AND ${IS_OPEN} RETURNING ${RECORD}`,
        [page.isSettled ? "the page was reloaded" : doubtReasons.started, id],
      ),
    );
  }
  changed.push(...overtakeAgain(statements, id, page.lastApplied));
  return { changed: lastOfEach(changed), refused };
}

/** What was delivered when something overtook it may wait again now; it was overtaken all the same. */
function overtakeAgain(statements: Statements, id: string, lastApplied: number): CommandRecord[] {
  const ended: CommandRecord[] = [];
  for (const isStop of [true, false]) {
    const seq = numberIn(
      statements,
      `SELECT max(seq) AS found FROM commands
       WHERE robot = ? AND seq > ? AND ${isStop ? `command = '${STOP}'` : "replaces = 1"}`,
      [id, lastApplied],
    );
    if (seq === null) continue;
    ended.push(...overtake(statements, id, { seq, isStop }).map(({ record }) => record));
  }
  return ended;
}

/** A command that changed twice in one step is reported once, with its last state. */
function lastOfEach(records: CommandRecord[]): CommandRecord[] {
  const bySeq = new Map(records.map((record) => [record.seq, record]));
  return [...bySeq.values()].toSorted((a, b) => a.seq - b.seq);
}
