/**
 * Advice on a program before it runs, as data; the page creates the sentences. Each line has at
 * most one advice: the most fundamental one.
 */
import type { Condition, Rule } from "@corridor/program";
import type { LineRef, PlainAction } from "@corridor/protocol";

/** The side of a turn. */
export type Side = "left" | "right";

/**
 * A small edit that resolves an advice. Lines are indices in the document of the advice; `to` is
 * the index of the moved line afterwards.
 */
export type Fix =
  | { kind: "action"; line: LineRef; action: PlainAction }
  | { kind: "number"; line: number; number: number }
  | { kind: "condition"; line: number; when: Condition }
  | { kind: "move"; line: number; to: number }
  | { kind: "delete"; line: number }
  | { kind: "insert"; at: number; rule: Rule };

/** The line never decides: whenever its condition is true, a line of `above` is true as well. */
export interface NeverDecides {
  kind: "never-decides";
  line: LineRef;
  /** a smallest set of such lines in order; never empty */
  above: number[];
  fix: Fix | null;
}

/** The condition is true nowhere in this maze. */
export interface NeverTrueHere {
  kind: "never-true-here";
  line: number;
  /**
   * farthest: the reading never exceeds `bound`; nearest: it is never below; difference: left and
   * right always differ by less
   */
  limit: "farthest" | "nearest" | "difference";
  /** units */
  bound: number;
  fix: Fix | null;
}

/**
 * A delayed turn with a condition on the front sensor: it drives towards a wall that it detected.
 */
export interface DelayedAboutFront {
  kind: "delayed-about-front";
  line: number;
  /** near: too little room ahead; free: no condition checks the side of the turn */
  why: "near" | "free";
  side: Side;
  /** the front reading that the delay needs, in units */
  needs: number;
  fix: Fix | null;
}

/** A turn on the spot into an opening: it starts at the edge of the opening. */
export interface ImmediateIntoOpening {
  kind: "immediate-into-opening";
  line: number;
  side: Side;
  /** units that a delayed turn drives first, to the middle of the opening */
  drivesOn: number;
  fix: Fix | null;
}

export type Advice = NeverDecides | NeverTrueHere | DelayedAboutFront | ImmediateIntoOpening;
