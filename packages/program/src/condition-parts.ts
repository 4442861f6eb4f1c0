/**
 * A condition taken apart into what the menu shows, its kind and its number, and put together again.
 */
import type { Condition } from "./program-document.ts";
import { conditionKinds, MAX_PLUS, MAX_THAN, type ConditionKind } from "./vocabulary.ts";

/** The entry of `conditionKinds` that a condition was chosen from: the very object of that list. */
export function kindOf(condition: Condition): ConditionKind {
  const than = condition.than === "right" ? "right" : "number";
  const kind = conditionKinds.find(
    (each) => each.sensor === condition.sensor && each.is === condition.is && each.than === than,
  );
  if (kind === undefined) throw new RangeError("expected a condition that the schema lets through");
  return kind;
}

/** The number beside the menu: what a sensor is compared with, or what is added to the right one. */
export function numberOf(condition: Condition): number {
  return condition.than === "right" ? condition.plus : condition.than;
}

/** A condition of a kind. The number has to be within `numberRange(kind)`. */
export function conditionOf(kind: ConditionKind, number: number): Condition {
  return kind.than === "right"
    ? { sensor: kind.sensor, is: kind.is, than: "right", plus: number }
    : { sensor: kind.sensor, is: kind.is, than: number };
}

/** The smallest and the largest number that a kind of condition takes, in units. */
export function numberRange(kind: ConditionKind): { min: number; max: number } {
  return kind.than === "right" ? { min: -MAX_PLUS, max: MAX_PLUS } : { min: 0, max: MAX_THAN };
}
