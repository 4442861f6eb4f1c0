/**
 * The words and bounds of the challenge document, apart from its schema: who only reads what is
 * allowed need not load a schema library.
 */
import { conditionKinds, type ConditionKind } from "@corridor/program";

export const MAX_CHALLENGE_MAZES = 10;
export const MAX_HINTS = 6;
/** Longest texts, in UTF-16 units. */
export const MAX_TASK_LENGTH = 400;
export const MAX_SHORT_LENGTH = 120;
/** Longest run of one maze, in seconds of simulated time. */
export const MAX_CHECK_SECONDS = 600;
export const MAX_CHECK_BUMPS = 1_000;
/** Longest way that a goal can ask for, in units. */
export const MAX_GOAL_DISTANCE = 100_000;

/** What may be changed in the program that a challenge begins with. */
export const editKinds = ["condition", "number", "action", "otherwise", "order", "lines"] as const;
export type EditKind = (typeof editKinds)[number];

/** The conditions of the menu by name, in its order, such as "front >". */
export const conditionNames = [
  "front >",
  "front <",
  "back >",
  "back <",
  "left >",
  "left <",
  "right >",
  "right <",
  "left < right",
  "left > right",
] as const;
export type ConditionName = (typeof conditionNames)[number];

/** The name of a kind of condition: its sensor, its sign and, where there is one, the other sensor. */
export function conditionNameOf(kind: ConditionKind): ConditionName {
  const name = conditionNames[conditionKinds.indexOf(kind)];
  if (name === undefined) throw new RangeError("expected a kind of the menu's own list");
  return name;
}
