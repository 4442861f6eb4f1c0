/**
 * Derives the cause from a change that removes the failure: the line, the moment and the readings.
 * All values are from the trace.
 */
import {
  numberOf,
  evaluateCondition,
  type Condition,
  type ProgramDocument,
} from "@corridor/program";
import type { LineRef } from "@corridor/protocol";
import { DELAY_DISTANCE, ROBOT_RADIUS } from "@corridor/simulation";
import type { Fix, Side } from "../advice.ts";
import { OPENING } from "../turn-findings.ts";
import { actionOf, delayedTurn, isTurn, turnOnTheSpot } from "./candidates.ts";
import type { Cause, Decision, WrongAction, WrongNumber } from "./diagnosis.ts";
import type { RunTrace } from "./run-trace.ts";

/** The front reading that a delayed turn needs. */
export const DELAY_NEEDS = DELAY_DISTANCE + ROBOT_RADIUS;
/**
 * Ticks after the side opened, within 20 cm, during which the robot is at the edge of the opening.
 */
const EDGE_TICKS = 12;
/** Units that the robot drives in a few ticks. */
const NEAR = 5;
/** Number of reversals that count as driving forward and back. */
const MANY_REVERSALS = 10;

/**
 * @param fix a change that removes the failure
 * @param from the tick of its first different decision
 */
export function causeOf(trace: RunTrace, fix: Fix, from: number): Cause | null {
  const moment = trace.decisionAt(from);
  if (moment === null) return null;
  const { program } = trace;
  switch (fix.kind) {
    case "action":
      return actionCause(trace, fix, moment);
    case "number":
      return numberCause(trace, fix.line, fix.number, moment);
    case "condition": {
      const when = program.rules[fix.line]?.when ?? null;
      if (when === null) return null;
      const kind = fix.when.sensor === when.sensor ? "comparison" : "sensor";
      return { kind, line: fix.line, when, moment };
    }
    case "move": {
      const when = program.rules[fix.line]?.when ?? null;
      // The line must be true there although another one decided.
      if (when === null || evaluateCondition(when, moment.readings)?.isTrue !== true) return null;
      return { kind: "order", line: fix.line, when, moment };
    }
    case "insert": {
      const { when } = fix.rule;
      if (when === null) return null;
      const { sensor } = when;
      const isSide = sensor === "left" || sensor === "right";
      const hasTurn = isSide && turnsTo(program, sensor);
      return { kind: "missing", moment, sensor, isWall: when.is === "<", hasTurn };
    }
    case "delete":
      return { kind: "extra", line: fix.line, moment };
  }
}

function actionCause(
  trace: RunTrace,
  { action }: Extract<Fix, { kind: "action" }>,
  moment: Decision,
): Cause | null {
  const side = sideOf(moment.action);
  if (side !== null && delayedTurn[moment.action] === action) {
    const isAtEdge = isAtEdgeOfOpening(trace, moment, side);
    return { kind: "not-delayed", moment, side, drivesOn: DELAY_DISTANCE, isAtEdge };
  }
  const detail = detailOf(trace, moment);
  if (side !== null && turnOnTheSpot[moment.action] === action) {
    // A turn to a wall is wrong with and without a delay.
    if (detail?.kind === "into-wall") return null;
    return { kind: "delayed", moment, side, needs: DELAY_NEEDS };
  }
  // The text about lines that undo each other recommends a turn.
  const isOther = detail?.kind === "undoing" && !isTurn(action);
  return { kind: "action", moment, detail: isOther ? null : detail };
}

/** Whether the side opened just before the moment. In a room it is always open. */
export function isAtEdgeOfOpening(
  trace: RunTrace,
  { tick, readings }: Decision,
  side: Side,
): boolean {
  if (readings[side] < OPENING) return false;
  for (let at = tick; at > tick - EDGE_TICKS; at--) {
    const before = trace.decisionBefore(at);
    if (before === null) return false;
    if (before.readings[side] < OPENING) return true;
  }
  return false;
}

/** What the readings of a decision show about its action. */
export function detailOf(trace: RunTrace, moment: Decision): WrongAction["detail"] {
  const { line, action, readings } = moment;
  const side = sideOf(action);
  if (action in turnOnTheSpot && readings.front < DELAY_NEEDS) {
    return { kind: "no-room", needs: DELAY_NEEDS };
  }
  if (side !== null && readings[side] < DELAY_NEEDS && turnsToWall(trace, moment, side)) {
    const other = otherSide(side);
    if (readings[other] >= OPENING) return { kind: "into-wall", side, open: other };
    if (readings.front >= OPENING) return { kind: "into-wall", side, open: "front" };
  }
  const other = action === "reverse" ? alternatingLine(trace, line) : null;
  return other === null ? null : { kind: "undoing", other };
}

/** Whether a wall is at the side where the robot turns. A delayed turn drives on first. */
function turnsToWall(trace: RunTrace, { tick, action, readings }: Decision, side: Side): boolean {
  if (!(action in turnOnTheSpot)) return true;
  for (let at = tick + 1; at < trace.until; at++) {
    const now = trace.readingsAt(at);
    if (readings.front - now.front > DELAY_DISTANCE - 1) return now[side] < DELAY_NEEDS;
  }
  return false;
}

/**
 * The line that repeatedly drove forward before or after this one drove back; null if there is
 * none.
 */
function alternatingLine({ decisions }: RunTrace, line: LineRef): LineRef | null {
  const times = new Map<LineRef, number>();
  for (const [at, { line: forward, action }] of decisions.entries()) {
    if (action !== "forward") continue;
    const around = [decisions[at - 1], decisions[at + 1]];
    const reversals = around.filter((each) => each?.line === line && each.action === "reverse");
    times.set(forward, (times.get(forward) ?? 0) + reversals.length);
  }
  const [most] = [...times].toSorted((one, next) => next[1] - one[1]);
  return most !== undefined && most[1] >= MANY_REVERSALS ? most[0] : null;
}

function numberCause(
  trace: RunTrace,
  line: number,
  better: number,
  moment: Decision,
): WrongNumber | null {
  const when = trace.program.rules[line]?.when ?? null;
  if (when === null) return null;
  const kind = numberKind(trace, line, moment);
  return {
    kind,
    line,
    number: numberOf(when),
    better,
    when,
    moment,
    extreme: extremeOf(trace, line, kind, moment.tick),
  };
}

function extremeOf(
  trace: RunTrace,
  line: number,
  kind: WrongNumber["kind"],
  tick: number,
): WrongNumber["extreme"] {
  const when = trace.program.rules[line]?.when ?? null;
  if (!trace.decisions.some((each) => each.line === line)) return "never";
  if (when === null || when.than === "right") return null;
  if (when.is === ">" && when.than < ROBOT_RADIUS - 1) return "always";
  return kind === "too-late" && !isTrueFurtherOn(trace, when, tick) ? "missed" : null;
}

/** Whether the robot drives on from the tick to the place where the condition becomes true. */
function isTrueFurtherOn(trace: RunTrace, when: Condition, tick: number): boolean {
  const at = trace.firstTrue(when, tick);
  if (at === null) return false;
  return Math.abs(trace.readingsAt(at)[when.sensor] - numberOf(when)) <= NEAR;
}

/**
 * Whether the line decides at the moment shows if it is true too much or too little. The previous
 * decision shows whether the beginning or the end is wrong.
 */
function numberKind(
  trace: RunTrace,
  line: number,
  { tick, line: decided }: Decision,
): WrongNumber["kind"] {
  const hasDecidedBefore = trace.decisionBefore(tick)?.line === line;
  if (decided === line) return hasDecidedBefore ? "too-long" : "too-early";
  return hasDecidedBefore ? "too-short" : "too-late";
}

export function otherSide(side: Side): Side {
  return side === "left" ? "right" : "left";
}

/** The side of a turn; null for other actions. */
export function sideOf(action: string): Side | null {
  if (!action.endsWith("90")) return null;
  return action.includes("left") ? "left" : "right";
}

/** Whether any line that can decide turns to this side. */
export function turnsTo(program: ProgramDocument, side: Side): boolean {
  const lines: LineRef[] = ["default", ...program.rules.keys()];
  return lines.some((line) => {
    if (line !== "default" && program.rules[line]?.when === null) return false;
    const action = actionOf(program, line);
    return isTurn(action) && sideOf(action) === side;
  });
}
