/**
 * State transitions of a robot's commands; see `SessionStore` for their meaning. Each transition
 * names the states that it starts from. An ended command never changes again.
 */
import { expiredReason, type CommandRecord, type Ending } from "@corridor/protocol";
import { isStop, recordOfRow, termedOfRow, type CommandRow } from "./command-row.ts";
import type { KnownCommand } from "./known-commands.ts";
import type { LiveRobot } from "../../store/live-robot.ts";
import {
  CLOCK_TOLERANCE_MS,
  type AddResult,
  type CancelResult,
  type NewCommand,
  type PageState,
  type TermedRecord,
} from "../../store/session-store.ts";

/** Checks whether the sender may send commands. @returns null if it may */
export function refusal({ standing }: LiveRobot, { driver, script }: NewCommand): AddResult | null {
  if (!standing.keys.has(driver)) return { outcome: "revoked" };
  return script !== null && standing.away.has(script) ? { outcome: "blocked" } : null;
}

/** Stores a command whose idempotency key is new. @param known the interned command */
export function add(robot: LiveRobot, command: NewCommand, known: KnownCommand): AddResult {
  const { standing } = robot;
  const { driver, script, key, acceptedAt, ttl, deadline, replace, lease } = command;
  const stops = isStop(known.text);
  if (standing.isPaused && !stops) return { outcome: "paused" };
  if (deadline <= acceptedAt) return { outcome: "late" };
  const seq = standing.lastSeq + 1;
  const ended = stops || replace ? overtake(robot, { seq, stops }) : [];
  if (!stops && robot.waitingCount >= command.maxWaiting) return { outcome: "full" };
  robot.forget(seq - command.keep);
  const row = robot.change({
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
  robot: LiveRobot,
  { epoch, window, now }: { epoch: number; window: number; now: number },
): TermedRecord[] {
  if (robot.standing.epoch !== epoch) return [];
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

/** accepted → expired. @returns the expired commands, and the next deadline of the waiting ones */
export function expire(
  robot: LiveRobot,
  now: number,
): { ended: TermedRecord[]; next: number | null } {
  const ended: TermedRecord[] = [];
  let next: number | null = null;
  for (const row of waiting(robot)) {
    if (isLate(row, now)) {
      const reason = expiredReason(row.ttl);
      ended.push(termedOfRow(robot.change(row, { state: "expired", reason })));
    } else next = Math.min(next ?? row.deadline, row.deadline);
  }
  return { ended, next };
}

/**
 * Cancels an open command: accepted → cancelled. A command that the robot has is marked as
 * recalled.
 */
export function cancel(robot: LiveRobot, row: CommandRow, reason: string): CancelResult {
  if (row.state !== "accepted") {
    robot.change(row, { recalled: row.recalled ?? reason });
    return { outcome: "delivered", record: recordOfRow(row) };
  }
  return {
    outcome: "cancelled",
    termed: termedOfRow(robot.change(row, { state: "cancelled", reason })),
  };
}

/** Cancels all commands of a key or a script, or all except stops. @returns those that ended */
export function recallAllOf(
  robot: LiveRobot,
  whose: { driver: string } | { script: string } | "all",
  reason: string,
): TermedRecord[] {
  const isMeant = ({ text, driver, script }: CommandRow): boolean => {
    if (whose === "all") return !isStop(text);
    return "driver" in whose ? driver === whose.driver : script === whose.script;
  };
  return [...robot.open].filter(isMeant).flatMap((row) => {
    const result = cancel(robot, row, reason);
    return result.outcome === "cancelled" ? result.termed : [];
  });
}

/** delivered → started. @returns null if it was not delivered or the epoch is not the newest */
export function begin(robot: LiveRobot, epoch: number, seq: number): CommandRecord | null {
  const row = robot.row(seq);
  if (row?.state !== "delivered" || robot.standing.epoch !== epoch) return null;
  return recordOfRow(robot.change(row, { state: "started" }));
}

/** delivered or started → its ending. @returns null if it was in neither state */
export function end(robot: LiveRobot, ending: Ending): CommandRecord | null {
  const { seq, state, reason, pose, distance } = ending;
  const row = robot.row(seq);
  if (row === null || !isWithRobot(row)) return null;
  return recordOfRow(robot.change(row, { state, reason, pose, distance }));
}

/** Cancels all delivered and started commands, because their page does not return. */
export function abandon(robot: LiveRobot, reason: string): CommandRecord[] {
  const left = [...robot.open].filter(isWithRobot);
  return left.map((row) => recordOfRow(robot.change(row, { state: "cancelled", reason })));
}

/**
 * Reconciles a robot's commands with the report of the page that acquires the robot.
 * @param known finds a record in memory or in the tables
 * @param newest finds the highest seq of a stop or a replacing command in memory or in the tables
 */
export function meetPage(
  robot: LiveRobot,
  page: PageState & { isSettled: boolean },
  known: (seq: number) => CommandRecord | null,
  newest: (what: "stop" | "replace") => number | null,
): { changed: CommandRecord[]; refused: CommandRecord[] } {
  const { lastApplied, fresh, isSettled, endings, pose, left } = page;
  // The new page's robot has not moved for these commands.
  const ending = { state: "cancelled", pose, distance: pose === null ? null : 0 } as const;
  const changed = new Map<number, CommandRecord>();
  const refused: CommandRecord[] = [];
  const change = (row: CommandRow, how: Partial<CommandRow>): void => {
    changed.set(row.seq, recordOfRow(robot.change(row, how)));
  };
  for (const ending of endings) {
    const record = end(robot, ending);
    if (record !== null) changed.set(record.seq, record);
    else {
      const before = known(ending.seq);
      if (before !== null && before.state !== ending.state) refused.push(before);
    }
  }
  for (const row of robot.open) {
    if (row.state !== "delivered") continue;
    const why = isSettled ? row.recalled : left.delivered;
    if (row.seq <= lastApplied) change(row, { state: "started", reason: null });
    else if (why === null) change(row, { state: "accepted", reason: null });
    else change(row, { ...ending, reason: why });
  }
  if (fresh || !isSettled) {
    const why = { ...ending, reason: left.started };
    for (const row of robot.open) if (row.state === "started") change(row, why);
  }
  // A delivered command may be accepted again now, although a stop or a replacement arrived after
  // it.
  for (const what of ["stop", "replace"] as const) {
    // The lookup is slow among ten thousand commands.
    const seq = waiting(robot).length === 0 ? null : newest(what);
    if (seq === null) continue;
    for (const { record } of overtake(robot, { seq, stops: what === "stop" }))
      changed.set(record.seq, record);
  }
  return { changed: [...changed.values()].toSorted((a, b) => a.seq - b.seq), refused };
}

/** Ends the accepted commands before a stop or a replacing command. */
function overtake(
  robot: LiveRobot,
  { seq, stops }: { seq: number; stops: boolean },
): TermedRecord[] {
  const before = waiting(robot).filter((row) => row.seq < seq);
  return before.map((row) =>
    termedOfRow(
      robot.change(row, {
        state: stops ? "cancelled" : "superseded",
        reason: `Command ${seq} ${stops ? "stopped" : "replaced"} this command.`,
      }),
    ),
  );
}

function waiting(robot: LiveRobot): CommandRow[] {
  return [...robot.open].filter(({ state }) => state === "accepted");
}

function isWithRobot({ state }: CommandRow): boolean {
  return state === "delivered" || state === "started";
}

/** Whether a command must not start any more. */
function isLate({ deadline, acceptedAt }: CommandRow, now: number): boolean {
  return deadline <= now || acceptedAt > now + CLOCK_TOLERANCE_MS;
}
