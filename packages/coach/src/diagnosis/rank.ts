/** Orders the changes that remove a failure by how likely each is the student's mistake. */
import type { ProgramDocument } from "@corridor/program";
import type { Fix } from "../advice.ts";
import { delayedTurn, lineOfWallAhead } from "./candidates.ts";
import { causeOf, detailOf } from "./cause-of.ts";
import type { BumpEvent, Cause, FailureEvent, WrongComparison, WrongOrder } from "./diagnosis.ts";
import type { RunTrace } from "./run-trace.ts";
import { distanceFromLane, distanceFromMiddle, type TrialResult } from "./trial.ts";

/** At most this many units from the middle of a square, a turn leaves room on both sides. */
const CENTRED = 5;

/** A change that removes the failure. */
export interface Found {
  fix: Fix;
  from: number;
  program: ProgramDocument;
  outcome: TrialResult["outcome"];
  offCentre: number;
  /** whether it solves every maze of the task; null in free play */
  isWhole: boolean | null;
  /** whether the run itself shows the mistake */
  isShown: boolean;
}

/** The kinds of changes, the most plausible first. */
const kinds = [
  /** another order of the lines that solves every maze of the task */
  "order",
  /** any other change that solves every maze, after which the robot turns in the middle of squares */
  "solution",
  /**
   * A missing delay at the edge of an opening, and a delayed turn that drove into the wall with too
   * little room ahead. Two mistakes need two changes, so these come before another action with which
   * the run shows nothing wrong, and before the number of another line.
   */
  "delay",
  /** a missing delay with which the robot only gets further */
  "further",
  /** a change that solves every maze, although the run shows nothing wrong about it */
  "doubtful",
  /** a change that solves every maze, after which the robot turns beside the middle of squares */
  "beside",
  /**
   * What the run itself shows: the line drove straight into the wall, its readings contradict its
   * action, or its number started a turn beside the middle of a square. After the second kind,
   * another failure occurs.
   */
  "shown",
  "shown-past",
  /** an action that only avoids the place of the failure, where the run shows another mistake */
  "evasion",
  /** a missing or extra line, or another order; in free play also a condition or a number */
  "other",
  /**
   * Another action that solves this maze but not every maze: with two wrong lines, each maze may show
   * one of them. In free play, one with which the run shows nothing wrong.
   */
  "action",
  /** in free play, a change after which another failure occurs */
  "past",
  /** a turn to a wall, with another action of which the robot only gets further */
  "further-turn",
] as const;
type Kind = (typeof kinds)[number];

/**
 * Sorts the changes, the most plausible first, and leaves out those that only happen to help: in a
 * task, a sign, a sensor or a number that does not solve every maze, and one that only compensates
 * for an earlier turn.
 */
export function ranked(
  trace: RunTrace,
  found: readonly Found[],
  event: FailureEvent,
  mazes: number,
  momentOf: (found: Found) => number,
): Found[] {
  const lacksDelay = found.some(({ fix, from }) => isMissingDelay(trace, fix, from));
  const isDelayEnough = found.some(
    ({ fix, from, isWhole }) => isWhole === true && isMissingDelay(trace, fix, from),
  );
  const turnsIntoWall = found.some(({ fix, from }) => isIntoWall(causeOf(trace, fix, from)));
  const withoutRoom = found.find((each) => isDelayWithoutRoom(trace, event, each));
  const solutionKind = (each: Found): Kind => {
    const { fix, isWhole } = each;
    const isBeside = turnsBeside(each);
    if (each === withoutRoom) return "solution";
    if (isMissingDelay(trace, fix, each.from)) return isBeside ? "delay" : "solution";
    if (fix.kind === "move" && isWhole === true) return isDelayEnough ? "solution" : "order";
    const isUnfounded = fix.kind === "action" && !each.isShown;
    const isProved = isWhole === true && mazes > 1;
    if (isUnfounded && !isProved && (isStraight(event) || turnsIntoWall)) return "evasion";
    if (isBeside) return "beside";
    const isOtherNumber = fix.kind === "number" && event.kind === "bump" && fix.line !== event.line;
    const isDoubtful = (isUnfounded && lacksDelay) || (isOtherNumber && withoutRoom !== undefined);
    return isDoubtful ? "doubtful" : "solution";
  };
  const kindOf = (each: Found): Kind | null => {
    const { fix, from, outcome, isWhole } = each;
    if (outcome === "further") {
      return isMissingDelay(trace, fix, from) ? "further" : "further-turn";
    }
    if (outcome === "solved" && isWhole !== false) return solutionKind(each);
    if (isMissingDelay(trace, fix, from) || each === withoutRoom) return "delay";
    if (each.isShown || isShownByReadings(trace, fix, momentOf(each))) {
      return outcome === "past" ? "shown-past" : "shown";
    }
    if (isWhole === null && outcome === "past") return "past";
    if (fix.kind !== "action" && fix.kind !== "move") return "other";
    if (isWhole !== null && outcome !== "solved") return null;
    return fix.kind === "action" ? "action" : "other";
  };
  return found
    .filter((each) => !isLeftOut(each) && !isCompensation(trace, each))
    .flatMap((each) => {
      const kind = kindOf(each);
      return kind === null ? [] : [{ each, rank: kinds.indexOf(kind) }];
    })
    .toSorted((a, b) => a.rank - b.rank)
    .map(({ each }) => each);
}

/** Whether the change says nothing about the task, because it only happens to help in this maze. */
export function isLeftOut({ fix, isWhole, isShown }: Found): boolean {
  if (isWhole !== false) return false;
  return fix.kind === "condition" || (fix.kind === "number" && !isShown);
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

/** Whether the robot turns beside the middle of squares after the change. */
function turnsBeside({ offCentre }: Found): boolean {
  return offCentre > CENTRED;
}

/**
 * Whether the robot was beside the middle of squares before the change mattered: then the change only
 * compensates for an earlier turn.
 */
function isCompensation(trace: RunTrace, { from, isWhole }: Found): boolean {
  if (isWhole === null) return false;
  return distanceFromLane(trace.at(from).pose) > CENTRED;
}

function isIntoWall(cause: Cause | null): boolean {
  return cause?.kind === "action" && cause.detail?.kind === "into-wall";
}

/** Whether the run shows the mistake, whatever another change would do. */
export function isShownByRun(
  trace: RunTrace,
  event: FailureEvent,
  fix: Fix,
  { from, offCentre, outcome }: Pick<TrialResult, "from" | "offCentre" | "outcome">,
): boolean {
  if (from === null) return false;
  if (isStraight(event)) {
    if (fix.kind === "action" && fix.line === event.line) return true;
    // Below the line that drove into the wall, the moved line did not decide.
    if (fix.kind === "move" && fix.to === event.line && outcome !== "past") return true;
  }
  if (fix.kind === "number" && offCentre <= CENTRED && turnsBesideMiddle(trace, fix.line, from))
    return true;
  return isShownByReadings(trace, fix, from);
}

/** Whether the number of a wall ahead started a turn on the spot beside the middle of a square. */
function turnsBesideMiddle(trace: RunTrace, line: number, from: number): boolean {
  const moment = trace.decisionAt(from);
  if (moment === null || !(moment.action in delayedTurn)) return false;
  if (lineOfWallAhead(trace, moment) !== line) return false;
  return distanceFromMiddle(trace.at(from).pose) > CENTRED;
}

function isShownByReadings(trace: RunTrace, fix: Fix, from: number): boolean {
  const cause = causeOf(trace, fix, from);
  if (cause === null) return false;
  if (cause.kind === "action") return cause.detail !== null;
  if (cause.kind === "delayed") return cause.moment.readings.front < cause.needs;
  if (cause.kind === "not-delayed") return isMissingDelay(trace, fix, from);
  if (cause.kind === "order") return isOrderOfWall(trace, cause);
  if (cause.kind === "comparison") return isIntoWallAhead(trace, cause);
  return "extreme" in cause && cause.extreme === "always";
}

/** Whether the upper line turned to a wall where the lower one drives forward. */
function isOrderOfWall(trace: RunTrace, { line, moment }: WrongOrder): boolean {
  if (trace.program.rules[line]?.do !== "forward") return false;
  return detailOf(trace, moment)?.kind === "into-wall";
}

/** Whether the line turned to a wall because there was room ahead. */
function isIntoWallAhead(trace: RunTrace, { line, when, moment }: WrongComparison): boolean {
  if (moment.line !== line || when.sensor !== "front") return false;
  return detailOf(trace, moment)?.kind === "into-wall";
}

/**
 * Whether the action is wrong independent of other mistakes. It is named even if the robot only gets
 * further with another one.
 */
export function isWrongAnyway(
  trace: RunTrace,
  fix: Fix,
  { from, hasBumped }: Pick<TrialResult, "from" | "hasBumped">,
): boolean {
  if (from === null) return false;
  return isMissingDelay(trace, fix, from) || (!hasBumped && isIntoWall(causeOf(trace, fix, from)));
}

/**
 * A turn at the edge of an opening lacks its delay. If a wall ahead was the reason for the turn, its
 * distance is wrong.
 */
function isMissingDelay(trace: RunTrace, fix: Fix, from: number): boolean {
  const cause = causeOf(trace, fix, from);
  if (cause?.kind !== "not-delayed" || !cause.isAtEdge) return false;
  return lineOfWallAhead(trace, cause.moment) === null;
}
