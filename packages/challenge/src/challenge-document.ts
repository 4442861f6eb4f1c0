/**
 * The challenge document, `corridor/challenge` version 1: one or more mazes, a goal, permissions,
 * checks, and texts in one language.
 */
import { mazeSchema } from "@corridor/maze";
import { MAX_NAME_LENGTH, MAX_RULES, programSchema } from "@corridor/program";
import {
  plainActions,
  readJson,
  readValue,
  sensorNames,
  type ReadResult,
} from "@corridor/protocol";
import { z } from "zod";
import {
  conditionNames,
  editKinds,
  MAX_CHALLENGE_MAZES,
  MAX_CHECK_BUMPS,
  MAX_CHECK_SECONDS,
  MAX_GOAL_DISTANCE,
  MAX_HINTS,
  MAX_SHORT_LENGTH,
  MAX_TASK_LENGTH,
} from "./challenge-limits.ts";

const textOf = (max: number) =>
  z
    .string({ error: `a text of at most ${max} characters` })
    .max(max, { error: `a text of at most ${max} characters` });

const whole = (min: number, max: number) => {
  const error = `a whole number from ${min} to ${max}`;
  return z.int({ error }).min(min, { error }).max(max, { error });
};

const real = (min: number, max: number) => {
  const error = `a number from ${min} to ${max}`;
  return z.number({ error }).min(min, { error }).max(max, { error });
};

/** Schema of a list of distinct strings from a fixed set. */
const subsetOf = <const Name extends string>(names: readonly Name[], plural: string) =>
  z
    .array(z.enum(names, { error: `one of ${names.join(", ")}` }), { error: `a list of ${plural}` })
    .check((context) => {
      if (new Set(context.value).size === context.value.length) return;
      context.issues.push({ code: "custom", input: context.value, message: "no duplicates" });
    })
    .meta({ uniqueItems: true });

const words = z.strictObject(
  {
    /** the task in one or two sentences */
    task: textOf(MAX_TASK_LENGTH),
    /** short form of the task, displayed above the maze */
    short: textOf(MAX_SHORT_LENGTH),
    /** revealed one by one */
    hints: z
      .array(textOf(MAX_TASK_LENGTH), { error: "a list of texts" })
      .max(MAX_HINTS, { error: `at most ${MAX_HINTS} hints` }),
  },
  { error: 'words: {"task": ..., "short": ..., "hints": [...]}' },
);
export type ChallengeWords = z.infer<typeof words>;

const goal = z.discriminatedUnion(
  "kind",
  [
    /** the whole robot is inside a goal cell */
    z.strictObject({ kind: z.literal("reach") }),
    /** the robot's centre has visited every open cell */
    z.strictObject({ kind: z.literal("visit") }),
    /** the robot has driven and stands still, with a sensor reading from `from` to `to` units */
    z.strictObject({
      kind: z.literal("stop"),
      sensor: z.enum(sensorNames, { error: `one of ${sensorNames.join(", ")}` }),
      from: real(0, MAX_GOAL_DISTANCE),
      to: real(0, MAX_GOAL_DISTANCE),
    }),
    /** the robot has driven this distance, forward and backward, in units */
    z.strictObject({ kind: z.literal("drive"), distance: real(1, MAX_GOAL_DISTANCE) }),
    /** no check fails for this time in seconds */
    z.strictObject({ kind: z.literal("last"), seconds: whole(1, MAX_CHECK_SECONDS) }),
  ],
  { error: 'a goal: {"kind": ...}, one of reach, visit, stop, drive, last' },
);
export type Goal = z.infer<typeof goal>;

const allowed = z.strictObject(
  {
    drivers: subsetOf(["me", "program", "remote"], "drivers").min(1, {
      error: "at least one driver",
    }),
    /** maximum number of lines of a program, without "otherwise" */
    lines: whole(0, MAX_RULES),
    /** null allows all conditions of the menu */
    conditions: subsetOf(conditionNames, "conditions").nullable(),
    /** null allows the actions of the paper */
    actions: subsetOf(plainActions, "actions").nullable(),
    /** parts of the starting program that can change */
    edits: subsetOf(editKinds, "edits"),
    /** whether the maze can change */
    maze: z.boolean({ error: "true or false" }),
  },
  {
    error:
      'what is allowed: {"drivers", "lines", "conditions", "actions", "edits", "maze"}, all of them',
  },
);

const checks = z.strictObject(
  {
    /** maximum number of bumps; null for no limit */
    bumps: whole(0, MAX_CHECK_BUMPS).nullable(),
    /** time limit per maze, in seconds of simulated time */
    seconds: whole(1, MAX_CHECK_SECONDS),
  },
  { error: 'checks: {"bumps": ..., "seconds": ...}' },
);

const par = z.strictObject(
  { lines: whole(0, MAX_RULES), seconds: real(0, MAX_CHECK_SECONDS) },
  { error: 'a par: {"lines": ..., "seconds": ...} or null' },
);

const shape = z.strictObject(
  {
    format: z.literal("corridor/challenge", { error: '"corridor/challenge"' }),
    version: z.literal(1, { error: "version 1, the newest that this Corridor reads" }),
    name: textOf(MAX_NAME_LENGTH),
    words,
    mazes: z
      .array(mazeSchema, { error: "a list of mazes" })
      .min(1, { error: "at least one maze" })
      .max(MAX_CHALLENGE_MAZES, { error: `at most ${MAX_CHALLENGE_MAZES} mazes` }),
    /** the starting program; null for an empty program that drives forward */
    program: programSchema.nullable(),
    goal,
    allowed,
    checks,
    /** reference values of a good solution, or null */
    par: par.nullable(),
  },
  { error: "a challenge: an object" },
);
export type ChallengeDocument = z.infer<typeof shape>;

/** The schema with its cross-field rules. */
export const challengeSchema = shape.check((context) => {
  const { mazes, goal: to, allowed: may, checks: checked, program } = context.value;
  const refuse = (path: (string | number)[], message: string): void => {
    context.issues.push({ code: "custom", path, message, input: context.value });
  };
  if (to.kind === "reach") {
    for (const [number, { goals }] of mazes.entries()) {
      if (goals.length === 0)
        refuse(["mazes", number, "goals"], "at least one goal, to be reached");
    }
  }
  if (to.kind === "stop" && to.from > to.to) refuse(["goal", "from"], "at most the value of `to`");
  if (to.kind === "last" && to.seconds > checked.seconds) {
    refuse(["goal", "seconds"], "at most the seconds of the checks");
  }
  if (program !== null && program.rules.length > may.lines) {
    refuse(["allowed", "lines"], `at least the ${program.rules.length} lines of its program`);
  }
});

/** Maximum text length in characters: the largest valid document plus indentation. */
const MAX_TEXT_LENGTH = 2_097_152;

/** Reads a challenge from a parsed value. */
export function parseChallenge(input: unknown): ReadResult<ChallengeDocument> {
  return readValue(challengeSchema, input);
}

/** Reads a challenge from JSON text. */
export function readChallenge(text: string): ReadResult<ChallengeDocument> {
  return readJson(challengeSchema, text, MAX_TEXT_LENGTH);
}
