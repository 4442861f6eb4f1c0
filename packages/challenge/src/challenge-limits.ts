/**
 * Names and bounds of the challenge document. They are separate from the schema so that modules
 * that only read permissions do not load the schema library.
 */
import { conditionKinds, type ConditionKind } from "@corridor/program";

/** Maximum length of a document's text of either version, in characters, with indentation. */
export const MAX_CHALLENGE_TEXT_LENGTH = 2_097_152;
export const MAX_CHALLENGE_MAZES = 10;
export const MAX_HINTS = 6;
/** Maximum lengths of texts, in UTF-16 code units. */
export const MAX_TASK_LENGTH = 400;
export const MAX_SHORT_LENGTH = 120;
/** Maximum time limit per maze in a challenge document of version 1, in simulated seconds. */
export const MAX_CHECK_SECONDS = 600;
/** The same in a lesson. */
export const MAX_LESSON_SECONDS = 3_600;
export const MAX_CHECK_BUMPS = 1_000;
/** Maximum distance of a goal, in units. */
export const MAX_GOAL_DISTANCE = 100_000;

/** Parts of the starting program that a challenge can allow to change. */
export const editKinds = ["condition", "number", "action", "otherwise", "order", "lines"] as const;
export type EditKind = (typeof editKinds)[number];

/** Tools of the page that a lesson can hide. */
export const toolNames = [
  "presets",
  "measure",
  "timeline",
  "speed",
  "remote",
  "share",
  "files",
] as const;
export type ToolName = (typeof toolNames)[number];

/**
 * Help of the page that a lesson can hide: marks of true and false lines, advice while editing,
 * changes that fix a program, the line that caused a failure, and hints.
 */
export const helpKinds = ["truth", "advice", "fixes", "blame", "hints"] as const;
export type HelpKind = (typeof helpKinds)[number];

export const MAX_TASKS = 12;
/** Maximum number of characters of a BCP 47 language tag. */
export const MAX_LANGUAGE_LENGTH = 35;
export const MAX_SURVEY_QUESTIONS = 8;
export const MAX_QUESTION_LENGTH = 200;
/** Bounds of the unseen mazes of a task. */
export const MIN_UNSEEN_SIDE = 5;
export const MAX_UNSEEN_SIDE = 33;
export const MAX_UNSEEN_SEED = 999_999;
export const MAX_UNSEEN_COUNT = 1_000;

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
