/**
 * Why a run failed: what happened, which line caused it and which changes remove the failure. Data
 * only; every surface makes its words from this one object.
 *
 * Distances are in units from the robot's centre, as sensors measure. Ticks count from the start.
 */
import type { Condition } from "@corridor/program";
import type { Command, LineRef, PlainAction, SensorName, SensorReadings } from "@corridor/protocol";
import type { Contact } from "@corridor/simulation";
import type { Mend, Side } from "../advice.ts";
import type { LoopNotice } from "../loop-detector.ts";

/** A moment at which a line decided. */
export interface DecisionMoment {
  /** tick at whose end the line decided: the readings are those of that moment */
  tick: number;
  line: LineRef;
  /** what the line asks, and was true; null for "otherwise" */
  when: Condition | null;
  action: PlainAction;
  readings: SensorReadings;
}

/** What the robot was doing when it met the wall. */
export type BumpPhase =
  /** the first part of a delayed turn: it drove on to the middle of the opening */
  | "delay"
  /** the last part of a delayed turn: it drove out of the junction */
  | "way-out"
  /** a measured distance of a script */
  | "measured"
  /** a motion that goes on until something else is chosen */
  | "steady";

export interface BumpEvent {
  kind: "bump";
  tick: number;
  /** the line that drove into the wall; null where a hand or a script drove */
  line: LineRef | null;
  action: Command["action"];
  phase: BumpPhase;
  /** which way the robot drove */
  side: "front" | "back";
  /** tick at which the motion, or this part of it, began, whichever lines repeated it */
  begunAt: number;
  /** what the sensor on that side read then */
  reading: number;
  /** the reading that this part needs; null for a motion without an end of its own */
  needs: number | null;
  contact: Contact;
}

/** The time was over, or the robot gets nowhere. */
export type FailureEvent = BumpEvent | { kind: "late"; tick: number } | StuckEvent;

export interface StuckEvent extends LoopNotice {
  tick: number;
}

/** A turn on the spot; delayed, it gets past the place. */
export interface NotDelayed {
  kind: "not-delayed";
  moment: DecisionMoment;
  side: Side;
  /** units that the delayed turn drives on first */
  drivesOn: number;
  /** whether the turn began at the edge of an opening on its side */
  isAtEdge: boolean;
}

/** A delayed turn; on the spot, it gets past the place. */
export interface Delayed {
  kind: "delayed";
  moment: DecisionMoment;
  side: Side;
  /** the reading ahead that the delayed turn needs; it had `moment.readings.front` */
  needs: number;
}

/** The line was true, but a line above it decided; moved above that one, it removes the failure. */
export interface WrongOrder {
  kind: "order";
  /** the line that was true and did not decide */
  line: number;
  /** what the lower line asks */
  when: Condition;
  /** the line above it that decided */
  moment: DecisionMoment;
}

/**
 * The number of a line is wrong: it decides too early, still decides where it should not any more, is not
 * yet true where it should decide, or is true no longer there.
 */
export interface WrongNumber {
  kind: "too-early" | "too-long" | "too-late" | "too-short";
  line: number;
  /** the number of the line, and the nearest one that removes the failure */
  number: number;
  better: number;
  when: Condition;
  /** too early, too long: the line decides here; otherwise it would decide here with the better number */
  moment: DecisionMoment;
  /**
   * always: the line is true for every reading that a robot can have; never: it decided at no time; missed: it
   * decided before the moment, and is true at no time after it
   */
  extreme: "always" | "never" | "missed" | null;
}

/** The comparison of a line points the wrong way. */
export interface WrongComparison {
  kind: "comparison";
  line: number;
  when: Condition;
  /** the first moment at which the two comparisons decide differently */
  moment: DecisionMoment;
}

/** The line asks another sensor than it should. */
export interface WrongSensor {
  kind: "sensor";
  line: number;
  when: Condition;
  /** the first moment at which the two conditions decide differently */
  moment: DecisionMoment;
}

/** The line chose an action with which the run fails; another one removes the failure. */
export interface WrongAction {
  kind: "action";
  moment: DecisionMoment;
  /**
   * no-room: a delayed turn that had less room ahead than it needs; into-wall: it turned to a side with a wall although `open` was free; undoing: it and another line
   * drive back and forward by turns; null: none of these
   */
  detail:
    | { kind: "no-room"; needs: number }
    | { kind: "into-wall"; side: Side; open: "front" | Side }
    | { kind: "undoing"; other: LineRef }
    | null;
}

/** No line answers a situation; a new line removes the failure. */
export interface MissingLine {
  kind: "missing";
  /** what was measured where the new line decides first */
  moment: DecisionMoment;
  /** the sensor that the new line asks: a wall ahead or behind, or room at a side */
  sensor: SensorName;
  /** whether the program has a line that turns to that side; false for a wall */
  hasTurn: boolean;
}

/** Without the line, the failure is gone. */
export interface ExtraLine {
  kind: "extra";
  line: number;
  moment: DecisionMoment;
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
  /** null where no single allowed change removes the failure: then only what happened is said */
  cause: Cause | null;
  /** changes that were simulated and remove the failure, the one that names the cause first */
  fixes: readonly Mend[];
}

/** The line that caused the failure; null where none did, or none is known. */
export function causeLine({ cause }: Pick<Diagnosis, "cause">): LineRef | null {
  if (cause === null || cause.kind === "missing") return null;
  return "line" in cause ? cause.line : cause.moment.line;
}
