/**
 * State transitions of a robot's commands. These rules are only here and in `page-transitions.ts`.
 * Each transition names the states that it starts from. An ended command never changes again.
 *
 * A function receives what it needs of ended commands that are not in memory from its caller. The
 * steps at the end of this file apply the functions to the robot of a store.
 */
import { hasEnded, type CommandRecord, type Ending, type RecallCause } from "@corridor/protocol";
import {
  recordOfRow,
  termedOfRow,
  commandIn,
  type CommandRow,
  type InternedCommand,
  overtakingOf,
  type Overtaking,
  type RobotCommands,
  type TermedRecord,
} from "./robot-commands.ts";
import type { Cause, RelayReason } from "./reasons.ts";
import {
  type RobotStep,
  CLOCK_TOLERANCE_MS,
  type AddResult,
  type CancelResult,
  type EndResult,
  type Expired,
  type NewCommand,
} from "./robot-step.ts";
import { isSameCommand, shorten, shownRecordIn, toShorten } from "./stored-conditions.ts";

/**
 * Adds a command, unless its sender may not send commands or its idempotency key is known.
 * @param earlier finds the command with this idempotency key
 */
export function add(
  robot: RobotCommands,
  command: NewCommand,
  earlier: (driver: string, key: string) => CommandRow | null,
): AddResult {
  const { admissionState } = robot;
  const { driver, script, key } = command;
  const known = commandIn(JSON.stringify(command.command));
  if (!admissionState.keys.has(driver)) return { outcome: "revoked" };
  if (script !== null && admissionState.blocked.has(script)) return { outcome: "blocked" };
  const before = key === null ? null : earlier(driver, key);
  if (before !== null) {
    const outcome = isSameCommand(before, known.text) ? "duplicate" : "conflict";
    return { outcome, record: shownRecordIn(robot, before) };
  }
  return addNew(robot, command, known);
}

function addNew(robot: RobotCommands, command: NewCommand, known: InternedCommand): AddResult {
  const { admissionState } = robot;
  const { driver, script, key, acceptedAt, ttl, deadline, replace, lease } = command;
  const overtakes = overtakingOf(known.command, replace);
  const stops = overtakes === "stop";
  if (admissionState.isPaused && !stops) return { outcome: "paused" };
  const isReset = known.command.action === "reset";
  if (isReset && !admissionState.mayReset) return { outcome: "reset-disabled" };
  if (deadline <= acceptedAt) return { outcome: "late" };
  if (isReset && acceptedAt < command.resetFrom) return { outcome: "too-soon" };
  const seq = admissionState.lastSeq + 1;
  const ended = overtakes === null ? [] : overtake(robot, { seq, overtakes });
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
    overtakes,
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
  if (robot.admissionState.epoch !== epoch) return [];
  if (robot.isWindowFull(window)) return [];
  const free = window - robot.deliveredCount;
  const due: CommandRow[] = [];
  let at = 0;
  for (const row of robot.open) {
    if (row.state !== "accepted" || isLate(row, now)) continue;
    if (row.overtakes !== null) due.push(row);
    else if (at++ < free) due.push(row);
  }
  return due.map((row) => termedOfRow(robot.change(row, { state: "delivered", epoch })));
}

/**
 * accepted → expired.
 * @param isAbsent whether no page is connected as the robot, for the cause
 * @returns the expired commands, and the next deadline of the waiting ones
 */
export function expire(robot: RobotCommands, now: number, isAbsent = false): Expired {
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
  if (hasEnded(row.state)) return { outcome: "over", record: shownRecordIn(robot, row) };
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
  const isMeant = ({ overtakes, driver, script }: CommandRow): boolean => {
    if (whose === "all") return overtakes !== "stop";
    return "driver" in whose ? driver === whose.driver : script === whose.script;
  };
  const meant = [...robot.open].filter(isMeant);
  return meant.map((row) => recall(robot, row, cause)).filter((termed) => termed !== null);
}

/** Pauses remote driving and recalls all commands except stops, or resumes it. */
export function pause(robot: RobotCommands, isPaused: boolean): TermedRecord[] {
  robot.admissionState.isPaused = isPaused;
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
  if (row?.state !== "delivered" || robot.admissionState.epoch !== epoch) return null;
  return recordOfRow(robot.change(row, { state: "started" }));
}

/** delivered or started → its ending. @param known finds a command, whatever its state */
export function end(
  robot: RobotCommands,
  epoch: number,
  ending: Ending,
  known: (seq: number) => CommandRow | null,
): EndResult {
  const record = robot.admissionState.epoch === epoch ? finish(robot, ending) : null;
  if (record !== null) return { outcome: "ended", record };
  const row = known(ending.seq);
  return { outcome: "over", record: row && recordOfRow(row) };
}

/** @returns null if it was neither delivered nor started */
export function finish(robot: RobotCommands, ending: Ending): CommandRecord | null {
  const { seq, state, reason, pose, distance } = ending;
  const row = robot.row(seq);
  if (row === null || !isWithRobot(row)) return null;
  return recordOfRow(robot.change(row, { state, reason, pose, distance }));
}

/** Ends the accepted commands before a command that overtakes. */
export function overtake(
  robot: RobotCommands,
  { seq, overtakes }: { seq: number; overtakes: Overtaking },
): TermedRecord[] {
  const stops = overtakes === "stop";
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

export function becauseOf(cause: Cause, by: number | null = null): RelayReason {
  return { cause, by };
}

export function waiting(robot: RobotCommands): CommandRow[] {
  return [...robot.open].filter(({ state }) => state === "accepted");
}

export function isWithRobot({ state }: CommandRow): boolean {
  return state === "delivered" || state === "started";
}

/** Whether a command must not start any more. */
function isLate({ deadline, acceptedAt }: CommandRow, now: number): boolean {
  return deadline <= now || acceptedAt > now + CLOCK_TOLERANCE_MS;
}

// --- steps: see `RobotStore.commit` ---

/**
 * Stores a command as accepted with the next seq, and deletes old ended commands. A known
 * idempotency key returns its earlier record, even after the deadline and while scripts are paused.
 * Robots can be stopped on a full disk.
 */
export function addStep(command: NewCommand): RobotStep<AddResult> {
  const { driver, key } = command;
  const isStop = command.command.action === "stop";
  // A stop writes as little as possible, because the disk may be full.
  const rangeOf = (commands: RobotCommands) => (isStop ? null : toShorten(commands));
  return {
    none: { outcome: "no-robot" },
    needsSpace: !isStop,
    lookup: (commands) => ({
      key: key === null ? null : { driver, key },
      ended: rangeOf(commands),
    }),
    apply: (robot) => {
      const range = rangeOf(robot.commands);
      if (range !== null) shorten(robot.commands, robot.ended(range));
      return add(robot.commands, command, (ofDriver, withKey) => robot.withKey(ofDriver, withKey));
    },
  };
}

/**
 * Marks the next accepted commands as delivered. At most `window` commands are delivered at a time.
 * Stops and replacing commands do not count and do not wait. Commands that are due to expire are
 * skipped.
 */
export function deliverStep(epoch: number, window: number, now: number): RobotStep<TermedRecord[]> {
  return { none: [], apply: ({ commands }) => deliver(commands, { epoch, window, now }) };
}

/**
 * Expires commands whose deadline has passed or whose acceptance is in the future. The latter shows
 * that the clock was set back, so their age is unknown.
 */
export function expireStep(now: number, isAbsent?: boolean): RobotStep<Expired> {
  return {
    none: { ended: [], next: null },
    apply: ({ commands }) => expire(commands, now, isAbsent),
  };
}

/**
 * Cancels a command for the driver that sent it. If the robot has the command, the request is stored
 * and the robot is asked to end it. If the robot turns out not to have received it, it is cancelled.
 */
export function cancelStep(seq: number, driver: string): RobotStep<CancelResult> {
  return {
    none: { outcome: "no-command" },
    lookup: () => ({ seqs: [seq] }),
    apply: (robot) => cancel(robot.commands, robot.row(seq), driver),
  };
}

/** @returns the accepted commands that ended; null if there is no such robot */
export function pauseStep(isPaused: boolean): RobotStep<TermedRecord[] | null> {
  return {
    none: null,
    changesRobot: true,
    apply: ({ commands }) => pause(commands, isPaused),
  };
}

export function recalledStep(): RobotStep<{ seq: number; cause: RecallCause }[]> {
  return { none: [], apply: ({ commands }) => recalled(commands.open) };
}

export function startStep(epoch: number, seq: number): RobotStep<CommandRecord | null> {
  return { none: null, apply: ({ commands }) => start(commands, epoch, seq) };
}

export function endStep(epoch: number, ending: Ending): RobotStep<EndResult> {
  return {
    none: { outcome: "over", record: null },
    lookup: () => ({ seqs: [ending.seq] }),
    apply: (robot) => end(robot.commands, epoch, ending, (seq) => robot.row(seq)),
  };
}
