/**
 * Conditions and actions of the menus.
 * Conditions: Figure 15 of the 2013 thesis; actions: Figure 16 and `stop`; defaults: Figure 14.
 */
import type { PlainAction, SensorName } from "@corridor/protocol";

export type Comparator = ">" | "<";

/** A condition without its number: compares a sensor with a number, or left with right. */
export type ConditionKind =
  | { sensor: SensorName; is: Comparator; than: "number" }
  | { sensor: "left"; is: Comparator; than: "right" };

/** The conditions of the menu in the order of Figure 15, without `[Do nothing]`, which is null. */
export const conditionKinds: readonly ConditionKind[] = [
  { sensor: "front", is: ">", than: "number" },
  { sensor: "front", is: "<", than: "number" },
  { sensor: "back", is: ">", than: "number" },
  { sensor: "back", is: "<", than: "number" },
  { sensor: "left", is: ">", than: "number" },
  { sensor: "left", is: "<", than: "number" },
  { sensor: "right", is: ">", than: "number" },
  { sensor: "right", is: "<", than: "number" },
  { sensor: "left", is: "<", than: "right" },
  { sensor: "left", is: ">", than: "right" },
];

/**
 * The actions of the paper in the order of Figure 16, the default of a challenge without a list.
 */
export const paperActions: readonly PlainAction[] = [
  "forward",
  "reverse",
  "delayed left 90",
  "left 90",
  "delayed right 90",
  "right 90",
  "turn 180",
];

/** The actions of the menu: the actions of the paper, and `stop`. */
export const menuActions: readonly PlainAction[] = [...paperActions, "stop"];

/** Number and action of a new line. */
export const DEFAULT_NUMBER = 50;
export const DEFAULT_ACTION: PlainAction = "forward";

export const MAX_RULES = 200;
export const MAX_NAME_LENGTH = 100;
