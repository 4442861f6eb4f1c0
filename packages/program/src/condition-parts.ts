/** Splits a condition into its kind and its number, which the menu displays, and combines them. */
import { MAX_PLUS, MAX_THAN } from "@corridor/protocol";
import type { Condition } from "./program-document.ts";
import { conditionKinds, type ConditionKind } from "./vocabulary.ts";

/** Returns the entry of `conditionKinds` for a condition: the same object as in the list. */
export function kindOf(condition: Condition): ConditionKind {
  const than = condition.than === "right" ? "right" : "number";
  const kind = conditionKinds.find(
    (each) => each.sensor === condition.sensor && each.is === condition.is && each.than === than,
  );
  if (kind === undefined) throw new RangeError("expected a condition that matches the schema");
  return kind;
}

/** The number of a condition: the compared number, or the number added to the right reading. */
export function numberOf(condition: Condition): number {
  return condition.than === "right" ? condition.plus : condition.than;
}

/** Creates a condition. The number must be within `numberRange(kind)`. */
export function conditionOf(kind: ConditionKind, number: number): Condition {
  return kind.than === "right"
    ? { sensor: kind.sensor, is: kind.is, than: "right", plus: number }
    : { sensor: kind.sensor, is: kind.is, than: number };
}

/** The range of numbers of a condition kind, inclusive, in units. */
export function numberRange(kind: ConditionKind): { min: number; max: number } {
  return kind.than === "right" ? { min: -MAX_PLUS, max: MAX_PLUS } : { min: 0, max: MAX_THAN };
}
