/**
 * What the coach says about a program before it runs: data only, the page makes the sentences.
 * A line gets at most one advice, the one that makes all others pointless first.
 */
import type { Condition, Rule } from "@corridor/program";
import type { LineRef, PlainAction } from "@corridor/protocol";

/** The sides that a turn goes to. */
export type Side = "left" | "right";

/**
 * A small edit that answers an advice. Lines are indices in the document that the advice is about;
 * `to` is the index that the moved line has afterwards.
 */
export type Mend =
  | { kind: "action"; line: LineRef; action: PlainAction }
  | { kind: "number"; line: number; number: number }
  | { kind: "condition"; line: number; when: Condition }
  | { kind: "move"; line: number; to: number }
  | { kind: "delete"; line: number }
  | { kind: "insert"; at: number; rule: Rule };

/** The line never decides: whenever its condition is true, one of `above` is true before it. */
export interface NeverDecides {
  kind: "never-decides";
  line: LineRef;
  /** a smallest set of lines that win, in their order; never empty */
  above: number[];
  mend: Mend | null;
}

/** No place of this maze makes the condition true. */
export interface NeverTrueHere {
  kind: "never-true-here";
  line: number;
  /**
   * farthest: the reading can not get above `bound`; nearest: not below; difference: left and right
   * never differ by as much as `bound`
   */
  limit: "farthest" | "nearest" | "difference";
  /** units */
  bound: number;
  mend: Mend | null;
}

/** A delayed turn that asks about the front: it drives on towards what it has just seen. */
export interface DelayedAboutFront {
  kind: "delayed-about-front";
  line: number;
  /** near: too little room ahead; free: the side that it turns to was not asked */
  why: "near" | "free";
  side: Side;
  /** units from the robot's middle that driving on takes, its own radius included */
  needs: number;
  mend: Mend | null;
}

/** A turn on the spot because its side is open: it begins at the edge of the opening. */
export interface ImmediateIntoOpening {
  kind: "immediate-into-opening";
  line: number;
  side: Side;
  /** units that the delayed turn drives on, to the middle of the opening */
  drivesOn: number;
  mend: Mend | null;
}

export type Advice = NeverDecides | NeverTrueHere | DelayedAboutFront | ImmediateIntoOpening;
