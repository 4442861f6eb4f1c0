/**
 * State transitions of a robot's commands when a page acquires the robot, or when a page does not
 * return.
 */
import type { CommandRecord } from "@corridor/protocol";
import {
  recordOfRow,
  type CommandRow,
  overtakingKinds,
  type Overtaking,
  type RobotCommands,
} from "./robot-commands.ts";
import type { CommandLookup, RobotStep, Acquired, PageState } from "./robot-step.ts";
import { becauseOf, finish, isWithRobot, overtake, waiting } from "./state-machine.ts";

/**
 * Gives up the page of this epoch, because it does not return, and cancels all delivered and
 * started commands. Does nothing if a newer page exists.
 */
export function abandon(robot: RobotCommands, epoch: number): CommandRecord[] {
  if (robot.admissionState.epoch !== epoch) return [];
  robot.admissionState.epoch += 1;
  const left = [...robot.open].filter(isWithRobot);
  const ending = { state: "cancelled", reason: becauseOf("disconnected") } as const;
  return left.map((row) => recordOfRow(robot.change(row, ending)));
}

/** Makes a page the owner of the robot, and reconciles the commands with its report. */
export function acquire(
  robot: RobotCommands,
  page: PageState,
  known: Pick<CommandLookup, "row" | "newest">,
): Acquired {
  const { admissionState } = robot;
  const { lastApplied, fresh, knownEpoch, endings, pose, left } = page;
  const isKnown = knownEpoch !== null && knownEpoch >= admissionState.epoch;
  admissionState.epoch += 1;
  // A page with later commands than the store saw one that lost its newest commands.
  admissionState.lastSeq = Math.max(admissionState.lastSeq, lastApplied);
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
    const cause = isKnown ? row.recalled : (`${left}-unsure` as const);
    if (row.seq <= lastApplied) change(row, { state: "started", reason: null });
    else if (cause === null) change(row, { state: "accepted", reason: null });
    else change(row, { ...ending, reason: becauseOf(cause) });
  }
  if (fresh || !isKnown) {
    const why = { ...ending, reason: becauseOf(left) };
    for (const row of robot.open) if (row.state === "started") change(row, why);
  }
  // A delivered command may be accepted again now, although a stop or a replacement arrived after
  // it.
  for (const overtakes of overtakingKinds) {
    // The lookup is slow among ten thousand commands.
    const seq = waiting(robot).length === 0 ? null : known.newest(overtakes, lastApplied);
    if (seq === null) continue;
    for (const { record } of overtake(robot, { seq, overtakes })) changed.set(record.seq, record);
  }
  const { epoch } = admissionState;
  return { epoch, changed: [...changed.values()].toSorted((a, b) => a.seq - b.seq), refused };
}

/** The highest seq after `after` of these commands that overtakes in this way; null: there is none. */
export function newestOvertaking(
  rows: readonly CommandRow[],
  overtakes: Overtaking,
  after: number,
): number | null {
  const isMeant = (row: CommandRow): boolean => row.seq > after && row.overtakes === overtakes;
  const seqs = rows.filter(isMeant).map(({ seq }) => seq);
  return seqs.reduce<number | null>((most, seq) => Math.max(most ?? seq, seq), null);
}

// --- steps: see `RobotStore.commit` ---

/** @returns the commands that ended; null if another running relay is connected to the page */
export function abandonStep(epoch: number): RobotStep<CommandRecord[] | null> {
  return {
    none: [],
    changesRobot: true,
    lookup: ({ admissionState }) => ({ holder: admissionState.epoch === epoch }),
    apply: (robot) => (robot.isHeldElsewhere ? null : abandon(robot.commands, epoch)),
  };
}

/**
 * Makes a page the owner of the robot, and stores what the page has done. Commands that were not
 * started return to accepted, unless they were cancelled, stopped or superseded meanwhile. If it is
 * unknown whether they started, they end as cancelled: see `PageState.knownEpoch`.
 * @returns null if there is no such robot
 */
export function acquireStep(page: PageState): RobotStep<Acquired | null> {
  const seqs = page.endings.map(({ seq }) => seq);
  return {
    none: null,
    changesRobot: true,
    lookup: ({ open, openFrom }) => {
      const mayWait = [...open].some(({ state }) => state !== "started");
      return { seqs, after: mayWait ? Math.max(page.lastApplied, openFrom) : null };
    },
    apply: (robot) => {
      const acquired = acquire(robot.commands, page, robot);
      robot.setPage(page.page ?? "");
      return acquired;
    },
  };
}
