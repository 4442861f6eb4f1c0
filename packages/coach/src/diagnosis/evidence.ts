/** What a failed run itself shows about a mistake, whatever another change would do. */
import { CELL } from "@corridor/maze";
import { numberOf, type Condition, type ProgramDocument } from "@corridor/program";
import type { Fix } from "../advice.ts";
import { delayedTurn, isTurn, lineOfWallAhead } from "./candidates.ts";
import { OPENING } from "../turn-findings.ts";
import {
  causeOf,
  DELAY_NEEDS,
  isAtEdgeOfOpening,
  detailOf,
  otherSide,
  sideOf,
} from "./cause-of.ts";
import type { BumpEvent, Cause, FailureEvent, WrongComparison, WrongOrder } from "./diagnosis.ts";
import type { RunTrace } from "./run-trace.ts";
import { distanceFromMiddle, type TrialResult } from "./trial.ts";

/** At most this many units from the middle of a square, a turn leaves room on both sides. */
export const CENTRED = 5;

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
  /** in free play, whether the change only happens to help; see `isGuess` */
  isGuess: boolean;
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

export function isShownByReadings(trace: RunTrace, fix: Fix, from: number): boolean {
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
 * In free play, whether a change only happens to help: neither the decision nor the readings show
 * that it is the mistake.
 */
export function isGuess(
  trace: RunTrace,
  { fix, isShown, outcome }: Pick<Found, "fix" | "isShown" | "outcome">,
  tick: number,
): boolean {
  if (isShown || fix.kind === "move") return false;
  if (fix.kind === "number") return outcome === "past" && !isSamePlace(trace, fix);
  if (fix.kind === "insert") return !isForPlace(trace, fix.rule.when, tick);
  if (fix.kind === "condition" && isUnusedSensor(trace, fix)) return false;
  return !isToOnlyOpening(trace, fix, tick) && !isShownByReadings(trace, fix, tick);
}

/**
 * Whether the condition concerns about the same place with the other number. A number of a side that
 * is more than a square away only makes the line useless; one of the front is a place further on.
 */
function isSamePlace(
  { program }: RunTrace,
  { line, number }: Extract<Fix, { kind: "number" }>,
): boolean {
  const when = program.rules[line]?.when ?? null;
  if (when === null || when.sensor === "front" || when.sensor === "back") return true;
  return Math.abs(number - numberOf(when)) <= CELL;
}

/** Whether the change is another sensor for a condition that was never true. */
function isUnusedSensor(
  trace: RunTrace,
  { line, when }: Extract<Fix, { kind: "condition" }>,
): boolean {
  const own = trace.program.rules[line]?.when ?? null;
  return own !== null && own.sensor !== when.sensor && !trace.isEverTrue(own);
}

/** Whether a new line is for a wall, or for an opening that the robot reached. */
function isForPlace(trace: RunTrace, when: Condition | null, tick: number): boolean {
  const moment = trace.decisionAt(tick);
  if (when === null || moment === null) return false;
  const { sensor } = when;
  if (sensor !== "left" && sensor !== "right") return when.is === "<";
  return moment.readings.front < DELAY_NEEDS || isAtEdgeOfOpening(trace, moment, sensor);
}

/** Whether the change turns to the only open side at a wall, and the line turned elsewhere. */
function isToOnlyOpening(trace: RunTrace, fix: Fix, tick: number): boolean {
  const moment = trace.decisionAt(tick);
  const side = fix.kind === "action" ? sideOf(fix.action) : null;
  if (moment === null || side === null || side === sideOf(moment.action)) return false;
  const { action, readings } = moment;
  if (!isTurn(action) || readings.front >= DELAY_NEEDS) return false;
  return readings[side] >= OPENING && readings[otherSide(side)] < DELAY_NEEDS;
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
export function isMissingDelay(trace: RunTrace, fix: Fix, from: number): boolean {
  const cause = causeOf(trace, fix, from);
  if (cause?.kind !== "not-delayed" || !cause.isAtEdge) return false;
  return lineOfWallAhead(trace, cause.moment) === null;
}

/** Whether the change is a turn on the spot where the delayed turn had too little room. */
export function isDelayWithoutRoom(
  trace: RunTrace,
  event: FailureEvent,
  { fix, from }: Pick<Found, "fix" | "from">,
): boolean {
  if (event.kind !== "bump" || event.phase !== "delay") return false;
  const cause = causeOf(trace, fix, from);
  return cause?.kind === "delayed" && cause.moment.readings.front < cause.needs;
}

/**
 * Whether a line chose to drive straight into the wall. "otherwise: forward" did not choose it: a
 * line for that place may be missing.
 */
export function isStraight(event: FailureEvent): event is BumpEvent {
  if (event.kind !== "bump" || event.phase !== "steady") return false;
  return typeof event.line === "number" || event.action === "reverse";
}

export function isIntoWall(cause: Cause | null): boolean {
  return cause?.kind === "action" && cause.detail?.kind === "into-wall";
}
