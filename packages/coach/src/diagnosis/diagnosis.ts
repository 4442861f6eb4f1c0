/**
 * Why a run failed: the event, the line that caused it, and changes that remove the failure. Data
 * only; page and command line create the sentences.
 *
 * Distances are in units from the robot's centre, as sensors measure. Ticks count from the start.
 */
import type { Condition } from "@corridor/program";
import type { Command, LineRef, PlainAction, SensorName, SensorReadings } from "@corridor/protocol";
import type { Contact } from "@corridor/simulation";
import type { Fix, Side } from "../advice.ts";
import type { LoopNotice } from "../loop-detector.ts";

/** A decision of a line. */
export interface Decision {
  /** tick at whose end the line decided, and at which `readings` were measured */
  tick: number;
  line: LineRef;
  /** the true condition of the line; null for the default action */
  when: Condition | null;
  action: PlainAction;
  readings: SensorReadings;
}

/** What the robot did when it met the wall. */
export type BumpPhase =
  /** the first part of a delayed turn, to the middle of the opening */
  | "delay"
  /** the last part of a delayed turn, out of the junction */
  | "way-out"
  /** a move of a script by a distance */
  | "measured"
  /** a motion that lasts until the next command */
  | "steady";

export interface BumpEvent {
  kind: "bump";
  tick: number;
  /** the line that drove into the wall; null if the driver was Me or Remote */
  line: LineRef | null;
  action: Command["action"];
  phase: BumpPhase;
  /** the direction of the robot */
  side: "front" | "back";
  /** tick at whose end the line last decided, or the driver requested the motion */
  decidedAt: number;
  /** tick at which the motion, or this part of it, started, even if other lines repeated it */
  startedAt: number;
  /** the reading on that side at that tick */
  reading: number;
  /** the reading that this part needs; null for an endless motion */
  needs: number | null;
  contact: Contact;
}

/** A bump, the end of the time, or a robot that makes no progress. */
export type FailureEvent = BumpEvent | { kind: "late"; tick: number } | StuckEvent;

export interface StuckEvent extends LoopNotice {
  tick: number;
}

/** A turn on the spot that should be delayed. */
export interface NotDelayed {
  kind: "not-delayed";
  moment: Decision;
  side: Side;
  /** units that the delayed turn drives first */
  drivesOn: number;
  /** whether the turn started at the edge of an opening on its side */
  isAtEdge: boolean;
}

/** A delayed turn that should be on the spot. */
export interface Delayed {
  kind: "delayed";
  moment: Decision;
  side: Side;
  /** the front reading that the delayed turn needs; it was `moment.readings.front` */
  needs: number;
}

/** The line was true, but a line above it decided. Moving it above that one removes the failure. */
export interface WrongOrder {
  kind: "order";
  /** the line that was true and did not decide */
  line: number;
  /** the condition of the lower line */
  when: Condition;
  /** the line above it that decided */
  moment: Decision;
}

/**
 * The number of a line is wrong: it decides too early or too long, or it is true too late or too
 * short.
 */
export interface WrongNumber {
  kind: "too-early" | "too-long" | "too-late" | "too-short";
  line: number;
  /** the number of the line, and the nearest number that removes the failure */
  number: number;
  better: number;
  when: Condition;
  /**
   * too early, too long: the line decides here; otherwise it decides here with the better number
   */
  moment: Decision;
  /**
   * always: the line is true for every possible reading; never: it never decided; missed: it
   * decided before the moment, and the robot drives on from the moment to no place where it is true
   */
  extreme: "always" | "never" | "missed" | null;
}

/** The comparison of a line has the wrong direction. */
export interface WrongComparison {
  kind: "comparison";
  line: number;
  when: Condition;
  /** the first moment at which the two comparisons decide differently */
  moment: Decision;
}

/** The condition has the wrong sensor. */
export interface WrongSensor {
  kind: "sensor";
  line: number;
  when: Condition;
  /** the first moment at which the two conditions decide differently */
  moment: Decision;
}

/** The action of the line is wrong: another one removes the failure. */
export interface WrongAction {
  kind: "action";
  moment: Decision;
  /**
   * no-room: a delayed turn with less room ahead than it needs; into-wall: a turn to a side with a
   * wall although `open` was free; undoing: it and another line alternately drive back and forward;
   * null: none of these
   */
  detail:
    | { kind: "no-room"; needs: number }
    | { kind: "into-wall"; side: Side; open: "front" | Side }
    | { kind: "undoing"; other: LineRef }
    | null;
}

/** A line is missing: a new line removes the failure. */
export interface MissingLine {
  kind: "missing";
  /** the first decision that the new line changes */
  moment: Decision;
  /** the sensor of the new line */
  sensor: SensorName;
  /** whether the new line is for a wall ahead or behind; otherwise for room ahead or at a side */
  isWall: boolean;
  /** whether the program has a line that turns to that side; false for front and back */
  hasTurn: boolean;
}

/** Deleting the line removes the failure. */
export interface ExtraLine {
  kind: "extra";
  line: number;
  moment: Decision;
}

export type Cause =
  | NotDelayed
  | Delayed
  | WrongOrder
  | WrongNumber
  | WrongComparison
  | WrongSensor
  | WrongAction
  | MissingLine
  | ExtraLine;

export interface Diagnosis {
  event: FailureEvent;
  /** null if no single permitted change removes the failure */
  cause: Cause | null;
  /** simulated changes that remove the failure; the first one belongs to the cause */
  fixes: readonly Fix[];
  /**
   * In free play: the robot reaches the goal from its start without a bump, so no line is the
   * cause. It failed here because another program or a person had driven it before.
   */
  solvesFromStart?: true;
}

/** The line that caused the failure; null if there is none, or it is unknown. */
export function causeLine({ cause }: Pick<Diagnosis, "cause">): LineRef | null {
  if (cause === null || cause.kind === "missing") return null;
  return "line" in cause ? cause.line : cause.moment.line;
}
