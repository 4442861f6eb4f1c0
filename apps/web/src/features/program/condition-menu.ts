/** The condition menu of a line: its choices in the order of the paper, [Do nothing] first. */
import { conditionKinds, kindOf, type Condition, type ConditionKind } from "@corridor/program";

/** Value of the choice that has no condition. */
export const DO_NOTHING = "nothing";

/** A choice's value in the menu: its place among the paper's conditions. */
export function choiceOf(condition: Condition | null): string {
  return condition === null ? DO_NOTHING : String(conditionKinds.indexOf(kindOf(condition)));
}

/** The kind of condition that a choice stands for; null for [Do nothing]. */
export function kindOfChoice(choice: string): ConditionKind | null {
  return choice === DO_NOTHING ? null : (conditionKinds[Number(choice)] ?? null);
}
