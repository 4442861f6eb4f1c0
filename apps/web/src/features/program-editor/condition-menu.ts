import { conditionKinds, kindOf, type Condition, type ConditionKind } from "@corridor/program";

/**
 * Value of the option without a condition, [Do nothing]. It is the first option of a line's menu.
 */
export const DO_NOTHING = "nothing";

/** An option's value in the menu: the index of its condition kind in the order of the paper. */
export function choiceOf(condition: Condition | null): string {
  return condition === null ? DO_NOTHING : String(conditionKinds.indexOf(kindOf(condition)));
}

/** The condition kind of an option; null for [Do nothing]. */
export function kindOfChoice(choice: string): ConditionKind | null {
  return choice === DO_NOTHING ? null : (conditionKinds[Number(choice)] ?? null);
}
