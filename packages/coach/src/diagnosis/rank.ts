/** Orders the changes that remove a failure by how likely each is the student's mistake. */
import type { ProgramDocument } from "@corridor/program";
import type { Fix } from "../advice.ts";
import { causeOf } from "./cause-of.ts";
import type { BumpEvent, Cause, FailureEvent } from "./diagnosis.ts";
import type { RunTrace } from "./run-trace.ts";
import { distanceFromLane, type TrialResult } from "./trial.ts";

/** At most this many units from the middle of a square, a turn leaves room on both sides. */
const CENTRED = 5;

/** A change that removes the failure. */
export interface Found {
  fix: Fix;
  from: number;
  program: ProgramDocument;
  outcome: TrialResult["outcome"];
  offCentre: number;
}

/**
 * Sorts the changes, the most plausible first, and leaves out those that only happen to help.
 *
 * - 0: another order of the lines that solves every maze of the task, unless a missing delay does
 * - 1: any other change that solves every maze, after which the robot turns in the middle of
 *   squares
 * - 2: a missing delay at the edge of an opening, and a delayed turn that drove into the wall with
 *   too little room ahead. Two mistakes need two changes, so these come before another action with
 *   which the run shows nothing wrong, and before the number of another line
 * - 3: other changes that solve every maze; last those after or before which the robot is beside the
 *   middle
 * - 4, 5: what the run itself shows: the line drove straight into the wall, or its readings
 *   contradict its action
 * - 6: an action that solves every maze although the run shows nothing wrong about it, where the run
 *   shows another mistake: it only avoids the place of the failure
 * - 7: a missing or extra line, or another order; in free play, every change that lasts
 * - 8: another action that solves this maze but not every maze: with two wrong lines, each maze may
 *   show one of them; in free play, a change after which another failure occurs
 * - 9: a missing delay with which the robot only gets further
 *
 * In a task, a sign, a sensor or a number that does not solve every maze is left out.
 */
export function ranked(
  trace: RunTrace,
  found: readonly Found[],
  solvesAll: ((program: ProgramDocument) => boolean) | null,
  event: FailureEvent,
  momentOf: (found: Found) => number,
): Found[] {
  const lacksDelay = found.some(({ fix, from }) => isMissingDelay(trace, fix, from));
  const isDelayEnough = found.some(
    ({ fix, from, outcome, program }) =>
      outcome === "solved" && solvesAll?.(program) === true && isMissingDelay(trace, fix, from),
  );
  const turnsIntoWall = found.some(({ fix, from }) => isIntoWall(causeOf(trace, fix, from)));
  const withoutRoom = found.find((each) => isDelayWithoutRoom(trace, event, each));
  const rank = (each: Found): number | null => {
    const { fix, from, outcome, program } = each;
    if (outcome === "further") return 9;
    const isSolution = outcome === "solved" && solvesAll?.(program) !== false;
    const isCentred = isSolution && !isBeside(trace, each);
    if (isMissingDelay(trace, fix, from)) return isCentred ? 1 : 2;
    if (each === withoutRoom) return isSolution ? 1 : 2;
    const droveIntoWall = isStraight(event) && "line" in fix && fix.line === event.line;
    const isShown = (droveIntoWall && fix.kind === "action") || isShownByRun(trace, fix, from);
    if (isSolution && fix.kind === "move" && solvesAll !== null) return isDelayEnough ? 1 : 0;
    const isActionWithoutEvidence = fix.kind === "action" && !isShown;
    if (isSolution && isActionWithoutEvidence && (isStraight(event) || turnsIntoWall)) return 6;
    const isOtherNumber = fix.kind === "number" && event.kind === "bump" && fix.line !== event.line;
    const isDoubtful =
      (isActionWithoutEvidence && lacksDelay) || (isOtherNumber && withoutRoom !== undefined);
    if (isSolution) return isCentred && !isDoubtful ? 1 : 3;
    if (solvesAll === null) return outcome === "past" ? 8 : 7;
    if (isShown || isShownByRun(trace, fix, momentOf(each))) return outcome === "past" ? 5 : 4;
    if (fix.kind === "insert" || fix.kind === "delete" || fix.kind === "move") return 7;
    return fix.kind === "action" && outcome === "solved" ? 8 : null;
  };
  return found
    .flatMap((each) => {
      const at = rank(each);
      const isLast = at === 3 && isBeside(trace, each);
      return at === null ? [] : [{ each, rank: at, isLast }];
    })
    .toSorted((a, b) => a.rank - b.rank || Number(a.isLast) - Number(b.isLast))
    .map(({ each }) => each);
}

/** Whether the change is a turn on the spot where the delayed turn had too little room. */
function isDelayWithoutRoom(trace: RunTrace, event: FailureEvent, { fix, from }: Found): boolean {
  if (event.kind !== "bump" || event.phase !== "delay") return false;
  const cause = causeOf(trace, fix, from);
  return cause?.kind === "delayed" && cause.moment.readings.front < cause.needs;
}

/**
 * Whether a line chose to drive straight into the wall. "otherwise: forward" did not choose it: a
 * line for that place may be missing.
 */
function isStraight(event: FailureEvent): event is BumpEvent {
  if (event.kind !== "bump" || event.phase !== "steady") return false;
  return typeof event.line === "number" || event.action === "reverse";
}

/**
 * Whether the robot turns beside the middle of squares after the change, or was there before
 * another number mattered, which then only compensates for an earlier turn.
 */
function isBeside(trace: RunTrace, { fix, from, offCentre }: Found): boolean {
  if (offCentre > CENTRED) return true;
  return fix.kind === "number" && distanceFromLane(trace.at(from).pose) > CENTRED;
}

function isIntoWall(cause: Cause | null): boolean {
  return cause?.kind === "action" && cause.detail?.kind === "into-wall";
}

/** Whether the readings of the run show the mistake, whatever another change would do. */
function isShownByRun(trace: RunTrace, fix: Fix, from: number): boolean {
  const cause = causeOf(trace, fix, from);
  if (cause === null) return false;
  if (cause.kind === "action") return cause.detail !== null;
  if (cause.kind === "delayed") return cause.moment.readings.front < cause.needs;
  if (cause.kind === "not-delayed") return cause.isAtEdge;
  return "extreme" in cause && cause.extreme === "always";
}

/**
 * A turn at the edge of an opening is wrong independent of other mistakes. It is named if the robot
 * gets further with the delay.
 */
export function isMissingDelay(trace: RunTrace, fix: Fix, from: number): boolean {
  const cause = causeOf(trace, fix, from);
  return cause?.kind === "not-delayed" && cause.isAtEdge;
}
