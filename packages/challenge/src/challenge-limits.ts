/**
 * Names and bounds of the challenge document. They are separate from the schema so that modules
 * that only read permissions do not load the schema library.
 */
import { conditionKinds, type ConditionKind } from "@corridor/program";

export const MAX_CHALLENGE_MAZES = 10;
export const MAX_HINTS = 6;
/** Maximum lengths of texts, in UTF-16 code units. */
export const MAX_TASK_LENGTH = 400;
export const MAX_SHORT_LENGTH = 120;
/** Maximum time limit per maze, in seconds of simulated time. */
export const MAX_CHECK_SECONDS = 600;
export const MAX_CHECK_BUMPS = 1_000;
/** Maximum distance of a goal, in units. */
export const MAX_GOAL_DISTANCE = 100_000;

/** Parts of the starting program that a challenge can allow to change. */
export const editKinds = ["condition", "number", "action", "otherwise", "order", "lines"] as const;
export type EditKind = (typeof editKinds)[number];

/** Names of the menu's conditions, in menu order. */
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

/** The name of a condition kind: its sensor, its comparator and, if present, the other sensor. */
export function conditionNameOf(kind: ConditionKind): ConditionName {
  const name = conditionNames[conditionKinds.indexOf(kind)];
  if (name === undefined) throw new RangeError("expected an entry of conditionKinds");
  return name;
}
