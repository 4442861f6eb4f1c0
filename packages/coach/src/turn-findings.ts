/**
 * Turns that begin at the wrong moment: a delayed turn that asks about the front, and a turn on the
 * spot into a side opening. Each is looked at with the readings that reach its line, because a line
 * above may have asked what this one does not.
 */
import { numberOf, type Condition, type ProgramDocument, type Rule } from "@corridor/program";
import type { PlainAction } from "@corridor/protocol";
import { DELAY_DISTANCE, ROBOT_RADIUS } from "@corridor/simulation";
import type { DelayedAboutFront, ImmediateIntoOpening, Side } from "./advice.ts";
import type { MazeSight } from "./visibility.ts";
import type { ReachingReadings } from "./reaching-readings.ts";

type Unmended<A> = A extends { mend: unknown } ? Omit<A, "mend"> : never;
export type TurnFinding = Unmended<DelayedAboutFront> | Unmended<ImmediateIntoOpening>;

/** From the robot's middle to the wall: what a delayed turn needs ahead. */
const ROOM = DELAY_DISTANCE + ROBOT_RADIUS;

/** In a corridor one cell wide a wall at the side is at most as far as the robot's other side lets it. */
const CORRIDOR = 100;
/** In its middle a wall at the side is this far; a number below is true beside a wall, too. */
const MIDDLE = CORRIDOR / 2;
/** The nearest that the far wall of an opening can be: one cell behind the wall that ended. */
export const OPENING = CORRIDOR + ROBOT_RADIUS;

const delayed: Partial<Record<PlainAction, Side>> = {
  "delayed left 90": "left",
  "delayed right 90": "right",
};
const immediate: Partial<Record<PlainAction, Side>> = { "left 90": "left", "right 90": "right" };

/** Whether any line that can decide drives: a robot that only turns bumps nowhere. */
export function drives({ rules, default: otherwise }: ProgramDocument): boolean {
  const actions = [otherwise, ...rules.flatMap((rule) => (rule.when === null ? [] : [rule.do]))];
  return actions.some((action) => !(action in immediate) && !/^(?:stop|turn 180)$/.test(action));
}

/**
 * Looks at the turn of a line that can decide.
 * @param reaching the readings for which no line above decides
 * @param sight of the maze
 * @param isDriving whether the program drives at all
 */
export function turnFinding(
  rule: Rule,
  line: number,
  reaching: ReachingReadings,
  sight: MazeSight,
  isDriving: boolean,
): TurnFinding | null {
  if (rule.when === null) return null;
  const delayedSide = delayed[rule.do];
  if (delayedSide !== undefined) return delayedAboutFront(rule.when, line, delayedSide, reaching);
  const side = immediate[rule.do];
  if (side === undefined || !isDriving || !sight.hasOpenings) return null;
  if (!asksForOpening(rule.when, side)) return null;
  // Beside a wall ahead that is this near, the robot stands in front of the opening as it should.
  if (reaching.max("front") <= ROOM) return null;
  // Lines above have taken all readings that an opening gives.
  if (reaching.max(side) < OPENING) return null;
  return { kind: "immediate-into-opening", line, side, drivesOn: DELAY_DISTANCE };
}

/**
 * "front < n" with n up to the room that driving on takes bumps each time that it decides. A larger n
 * leaves room and is right where it is meant. "front > n" says nothing about the side that the robot
 * turns to, unless a line above has asked that side.
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

/** Whether a condition becomes true at the edge of an opening on this side, and not beside a wall. */
function asksForOpening(when: Condition, side: Side): boolean {
  const number = numberOf(when);
  if (when.than !== "right") return when.sensor === side && when.is === ">" && number >= MIDDLE;
  // In the middle of a corridor left and right are equal.
  return side === "left" ? when.is === ">" && number >= 0 : when.is === "<" && number <= 0;
}
