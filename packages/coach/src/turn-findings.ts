/**
 * Finds turns that start at the wrong moment: a delayed turn with a condition on the front sensor,
 * and a turn on the spot into a side opening. Considers only readings that reach the line, because
 * lines above exclude others.
 */
import { numberOf, type Condition, type ProgramDocument, type Rule } from "@corridor/program";
import type { PlainAction } from "@corridor/protocol";
import { DELAY_DISTANCE, ROBOT_RADIUS } from "@corridor/simulation";
import type { DelayedAboutFront, ImmediateIntoOpening, Side } from "./advice.ts";
import type { MazeVisibility } from "./visibility.ts";
import type { ReachingReadings } from "./reaching-readings.ts";

type WithoutFix<A> = A extends { fix: unknown } ? Omit<A, "fix"> : never;
export type TurnFinding = WithoutFix<DelayedAboutFront> | WithoutFix<ImmediateIntoOpening>;

/** The front reading that a delayed turn needs. */
const ROOM = DELAY_DISTANCE + ROBOT_RADIUS;

/** Upper bound of a side reading in a corridor of one cell. */
const CORRIDOR = 100;
/** The side reading in the middle of a corridor; lower numbers are true beside a wall as well. */
const MIDDLE = CORRIDOR / 2;
/** Smallest side reading in an opening: the wall is one cell further. */
export const OPENING = CORRIDOR + ROBOT_RADIUS;

const delayed: Partial<Record<PlainAction, Side>> = {
  "delayed left 90": "left",
  "delayed right 90": "right",
};
const immediate: Partial<Record<PlainAction, Side>> = { "left 90": "left", "right 90": "right" };

/** Whether any line drives: a robot that only turns never bumps. */
export function drives({ rules, default: otherwise }: ProgramDocument): boolean {
  const actions = [otherwise, ...rules.flatMap((rule) => (rule.when === null ? [] : [rule.do]))];
  return actions.some((action) => !(action in immediate) && !/^(?:stop|turn 180)$/.test(action));
}

/**
 * Checks the turn of a line that can decide.
 * @param reaching the readings for which no line above decides
 * @param visibility of the maze
 * @param isDriving whether any line drives
 */
export function turnFinding(
  rule: Rule,
  line: number,
  reaching: ReachingReadings,
  visibility: MazeVisibility,
  isDriving: boolean,
): TurnFinding | null {
  if (rule.when === null) return null;
  const delayedSide = delayed[rule.do];
  if (delayedSide !== undefined) return delayedAboutFront(rule.when, line, delayedSide, reaching);
  const side = immediate[rule.do];
  if (side === undefined || !isDriving || !visibility.hasOpenings) return null;
  if (!isTrueAtOpening(rule.when, side)) return null;
  // With a wall this near ahead, the robot stands in the middle of the opening.
  if (reaching.max("front") <= ROOM) return null;
  // Lines above decide for all readings of an opening.
  if (reaching.max(side) < OPENING) return null;
  return { kind: "immediate-into-opening", line, side, drivesOn: DELAY_DISTANCE };
}

/**
 * "front < n" bumps each time that it decides if n is at most the room that the delay needs. A
 * larger n may be right. "front > n" does not check the side of the turn, unless a line above does.
 */
function delayedAboutFront(
  when: Condition,
  line: number,
  side: Side,
  reaching: ReachingReadings,
): TurnFinding | null {
  if (when.sensor !== "front") return null;
  const finding = { kind: "delayed-about-front" as const, line, side, needs: ROOM };
  if (when.is === "<") return numberOf(when) <= ROOM ? { ...finding, why: "near" } : null;
  return reaching.min(side) >= MIDDLE ? null : { ...finding, why: "free" };
}

/** Whether a condition is true at the edge of an opening on this side, and false beside a wall. */
function isTrueAtOpening(when: Condition, side: Side): boolean {
  const number = numberOf(when);
  if (when.than !== "right") return when.sensor === side && when.is === ">" && number >= MIDDLE;
  // In the middle of a corridor left and right are equal.
  return side === "left" ? when.is === ">" && number >= 0 : when.is === "<" && number <= 0;
}
