/**
 * State transitions of a robot's commands: the only place for these rules. `RobotStore` describes
 * their meaning. Each transition names the states that it starts from. An ended command never
 * changes again.
 *
 * A function receives what it needs of ended commands that are not in memory from its caller.
 */
import { hasEnded, type CommandRecord, type Ending, type RecallCause } from "@corridor/protocol";
import {
  isStop,
  recordOfRow,
  termedOfRow,
  commandIn,
  type CommandRow,
  type KnownCommand,
} from "./command-row.ts";
import type { Cause, RelayReason } from "./reasons.ts";
import type { RobotCommands } from "./robot-commands.ts";
import {
  CLOCK_TOLERANCE_MS,
  type AddResult,
  type CancelResult,
  type EndResult,
  type NewCommand,
  type PageState,
  type TermedRecord,
} from "./steps.ts";

/**
 * Stores a command, unless its sender may not send commands or its idempotency key is known.
 * @param earlier finds the command with this idempotency key
 */
export function add(
  robot: RobotCommands,
  command: NewCommand,
  earlier: (driver: string, key: string) => CommandRow | null,
): AddResult {
  const { accessState } = robot;
  const { driver, script, key } = command;
  const known = commandIn(JSON.stringify(command.command));
  if (!accessState.keys.has(driver)) return { outcome: "revoked" };
  if (script !== null && accessState.blocked.has(script)) return { outcome: "blocked" };
  const before = key === null ? null : earlier(driver, key);
  if (before !== null) {
    const outcome = before.text === known.text ? "duplicate" : "conflict";
    return { outcome, record: recordOfRow(before) };
  }
  return addNew(robot, command, known);
}

function addNew(robot: RobotCommands, command: NewCommand, known: KnownCommand): AddResult {
  const { accessState } = robot;
  const { driver, script, key, acceptedAt, ttl, deadline, replace, lease } = command;
  const stops = isStop(known.text);
  if (accessState.isPaused && !stops) return { outcome: "paused" };
  if (deadline <= acceptedAt) return { outcome: "late" };
  const seq = accessState.lastSeq + 1;
  const ended = stops || replace ? overtake(robot, { seq, stops }) : [];
  if (!stops && robot.waitingCount >= command.maxWaiting) return { outcome: "full" };
  robot.deleteEnded(seq - command.keep);
  const row = robot.add({
    seq,
    driver,
    script,
    key,
    command: known.command,
    text: known.text,
    acceptedAt,
    ttl: Math.round(ttl),
    deadline: Math.round(deadline),
    replace,
    lease: lease === null ? null : Math.round(lease),
    overtakes: stops || replace,
    state: "accepted",
    reason: null,
    recalled: null,
    pose: null,
    distance: null,
    epoch: null,
  });
  return { outcome: "stored", record: recordOfRow(row), ended };
}

/** accepted → delivered, in order: as many as the window permits, and all that bypass it. */
export function deliver(
  robot: RobotCommands,
  { epoch, window, now }: { epoch: number; window: number; now: number },
): TermedRecord[] {
  if (robot.accessState.epoch !== epoch) return [];
  if (robot.hasAll(window)) return [];
  const free = window - robot.deliveredCount;
  const due: CommandRow[] = [];
  let at = 0;
  for (const row of robot.open) {
    if (row.state !== "accepted" || isLate(row, now)) continue;
    if (at < free || row.overtakes) due.push(row);
    at += 1;
  }
  return due.map((row) => termedOfRow(robot.change(row, { state: "delivered", epoch })));
}

/**
 * accepted → expired.
 * @param isAbsent whether no page is connected as the robot, for the cause
 * @returns the expired commands, and the next deadline of the waiting ones
 */
export function expire(
  robot: RobotCommands,
  now: number,
  isAbsent = false,
): { ended: TermedRecord[]; next: number | null } {
  const ended: TermedRecord[] = [];
  let next: number | null = null;
  for (const row of waiting(robot)) {
    if (isLate(row, now)) {
      const reason = becauseOf(isAbsent ? "expired-absent" : "expired");
      ended.push(termedOfRow(robot.change(row, { state: "expired", reason })));
    } else next = Math.min(next ?? row.deadline, row.deadline);
  }
  return { ended, next };
}

/** Cancels a command for the driver that sent it. @param row the command; null: there is none */
export function cancel(robot: RobotCommands, row: CommandRow | null, driver: string): CancelResult {
  if (row === null) return { outcome: "no-command" };
  if (row.driver !== driver) return { outcome: "not-yours" };
  if (hasEnded(row.state)) return { outcome: "over", record: recordOfRow(row) };
  const termed = recall(robot, row, "sender");
  if (termed !== null) return { outcome: "cancelled", termed };
  return { outcome: "delivered", record: recordOfRow(row) };
}

/**
 * Recalls an open command: accepted → cancelled. A command that the robot has is marked as
 * recalled. @returns the command if it has ended
 */
function recall(robot: RobotCommands, row: CommandRow, cause: RecallCause): TermedRecord | null {
  if (row.state === "accepted")
    return termedOfRow(robot.change(row, { state: "cancelled", reason: becauseOf(cause) }));
  if (row.recalled === null) robot.change(row, { recalled: cause });
  return null;
}

/** Recalls all commands of a key or a script, or all except stops. @returns those that ended */
export function recallAllOf(
  robot: RobotCommands,
  whose: { driver: string } | { script: string } | "all",
  cause: RecallCause,
): TermedRecord[] {
  const isMeant = ({ text, driver, script }: CommandRow): boolean => {
    if (whose === "all") return !isStop(text);
    return "driver" in whose ? driver === whose.driver : script === whose.script;
  };
  const meant = [...robot.open].filter(isMeant);
  return meant.map((row) => recall(robot, row, cause)).filter((termed) => termed !== null);
}

/** Pauses remote driving and recalls all commands except stops, or resumes it. */
export function pause(robot: RobotCommands, isPaused: boolean): TermedRecord[] {
  robot.accessState.isPaused = isPaused;
  return isPaused ? recallAllOf(robot, "all", "paused") : [];
}

/** Recalled commands that the robot has, in order. */
export function recalled(open: Iterable<CommandRow>): { seq: number; cause: RecallCause }[] {
  return [...open].flatMap((row) =>
    row.recalled !== null && isWithRobot(row) ? { seq: row.seq, cause: row.recalled } : [],
  );
}

/** delivered → started. @returns null if it was not delivered or the epoch is not the newest */
export function start(robot: RobotCommands, epoch: number, seq: number): CommandRecord | null {
  const row = robot.row(seq);
  if (row?.state !== "delivered" || robot.accessState.epoch !== epoch) return null;
  return recordOfRow(robot.change(row, { state: "started" }));
}

/** delivered or started → its ending. @param known finds a command, whatever its state */
export function end(
  robot: RobotCommands,
  epoch: number,
  ending: Ending,
  known: (seq: number) => CommandRow | null,
): EndResult {
  const record = robot.accessState.epoch === epoch ? finish(robot, ending) : null;
  if (record !== null) return { outcome: "ended", record };
  const row = known(ending.seq);
  return { outcome: "over", record: row && recordOfRow(row) };
}

/** @returns null if it was neither delivered nor started */
function finish(robot: RobotCommands, ending: Ending): CommandRecord | null {
  const { seq, state, reason, pose, distance } = ending;
  const row = robot.row(seq);
  if (row === null || !isWithRobot(row)) return null;
  return recordOfRow(robot.change(row, { state, reason, pose, distance }));
}

/**
 * Gives up the page of this epoch, because it does not return, and cancels all delivered and
 * started commands. Does nothing if a newer page exists.
 */
export function abandon(robot: RobotCommands, epoch: number): CommandRecord[] {
  if (robot.accessState.epoch !== epoch) return [];
  robot.accessState.epoch += 1;
  const left = [...robot.open].filter(isWithRobot);
  const ending = { state: "cancelled", reason: becauseOf("disconnected") } as const;
  return left.map((row) => recordOfRow(robot.change(row, ending)));
}

/** Where `acquire` finds commands that may not be in memory. */
export interface KnownCommands {
  row(seq: number): CommandRow | null;
  /** The highest seq of a stop or a replacing command after `after`, whatever its state. */
  newest(what: "stop" | "replace", after: number): number | null;
}

/** Makes a page the owner of the robot, and reconciles the commands with its report. */
export function acquire(
  robot: RobotCommands,
  page: PageState,
  known: KnownCommands,
): { epoch: number; changed: CommandRecord[]; refused: CommandRecord[] } {
  const { accessState } = robot;
  const { lastApplied, fresh, settled, endings, pose, left } = page;
  const isSettled = settled !== null && settled >= accessState.epoch;
  accessState.epoch += 1;
  // A page with later commands than the store saw one that lost its newest commands.
  accessState.lastSeq = Math.max(accessState.lastSeq, lastApplied);
  // The new page's robot has not moved for these commands.
  const ending = { state: "cancelled", pose, distance: pose === null ? null : 0 } as const;
  const changed = new Map<number, CommandRecord>();
  const refused: CommandRecord[] = [];
  const change = (row: CommandRow, how: Partial<CommandRow>): void => {
    changed.set(row.seq, recordOfRow(robot.change(row, how)));
  };
  for (const each of endings) {
    const record = finish(robot, each);
    if (record !== null) changed.set(record.seq, record);
    else {
      const before = known.row(each.seq);
      if (before !== null && before.state !== each.state) refused.push(recordOfRow(before));
    }
  }
  for (const row of robot.open) {
    if (row.state !== "delivered") continue;
    const cause = isSettled ? row.recalled : (`${left}-unsure` as const);
    if (row.seq <= lastApplied) change(row, { state: "started", reason: null });
    else if (cause === null) change(row, { state: "accepted", reason: null });
    else change(row, { ...ending, reason: becauseOf(cause) });
  }
  if (fresh || !isSettled) {
    const why = { ...ending, reason: becauseOf(left) };
    for (const row of robot.open) if (row.state === "started") change(row, why);
  }
  // A delivered command may be accepted again now, although a stop or a replacement arrived after
  // it.
  for (const what of ["stop", "replace"] as const) {
    // The lookup is slow among ten thousand commands.
    const seq = waiting(robot).length === 0 ? null : known.newest(what, lastApplied);
    if (seq === null) continue;
    for (const { record } of overtake(robot, { seq, stops: what === "stop" }))
      changed.set(record.seq, record);
  }
  const { epoch } = accessState;
  return { epoch, changed: [...changed.values()].toSorted((a, b) => a.seq - b.seq), refused };
}

/** The highest seq of a stop or a replacing command among these; null: there is none. */
export function newestOvertaking(
  rows: readonly CommandRow[],
  what: "stop" | "replace",
  after: number,
): number | null {
  const isMeant = ({ text, replace }: CommandRow): boolean =>
    what === "stop" ? isStop(text) : replace;
  const seqs = rows.filter((row) => row.seq > after && isMeant(row)).map(({ seq }) => seq);
  return seqs.reduce<number | null>((most, seq) => Math.max(most ?? seq, seq), null);
}

/** Ends the accepted commands before a stop or a replacing command. */
function overtake(
  robot: RobotCommands,
  { seq, stops }: { seq: number; stops: boolean },
): TermedRecord[] {
  const before = waiting(robot).filter((row) => row.seq < seq);
  return before.map((row) =>
    termedOfRow(
      robot.change(row, {
        state: stops ? "cancelled" : "superseded",
        reason: becauseOf(stops ? "stopped" : "replaced", seq),
      }),
    ),
  );
}

function becauseOf(cause: Cause, by: number | null = null): RelayReason {
  return { cause, by };
}

function waiting(robot: RobotCommands): CommandRow[] {
  return [...robot.open].filter(({ state }) => state === "accepted");
}

function isWithRobot({ state }: CommandRow): boolean {
  return state === "delivered" || state === "started";
}

/** Whether a command must not start any more. */
function isLate({ deadline, acceptedAt }: CommandRow, now: number): boolean {
  return deadline <= now || acceptedAt > now + CLOCK_TOLERANCE_MS;
}
