/**
 * The challenge document, `corridor/challenge` version 1: one or more mazes, a goal, what is allowed
 * on the way, what is checked, and the words that say so in one language.
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

/** A list of words from a few, each at most once. */
const someOf = <const Word extends string>(words: readonly Word[], what: string) =>
  z
    .array(z.enum(words, { error: `one of ${words.join(", ")}` }), { error: `a list of ${what}` })
    .check((context) => {
      if (new Set(context.value).size === context.value.length) return;
      context.issues.push({ code: "custom", input: context.value, message: "each of them once" });
    })
    .meta({ uniqueItems: true });

const words = z.strictObject(
  {
    /** what to do, in a sentence or two */
    task: textOf(MAX_TASK_LENGTH),
    /** the same in a few words, for the line above the maze */
    short: textOf(MAX_SHORT_LENGTH),
    /** opened one after the other */
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
    /** the whole robot stands in a goal cell */
    z.strictObject({ kind: z.literal("reach") }),
    /** the robot's centre has been in every open cell */
    z.strictObject({ kind: z.literal("visit") }),
    /** it has driven and stands still where a sensor reads from `from` to `to` units */
    z.strictObject({
      kind: z.literal("stop"),
      sensor: z.enum(sensorNames, { error: `one of ${sensorNames.join(", ")}` }),
      from: real(0, MAX_GOAL_DISTANCE),
      to: real(0, MAX_GOAL_DISTANCE),
    }),
    /** it has driven so many units, forward and backward */
    z.strictObject({ kind: z.literal("drive"), distance: real(1, MAX_GOAL_DISTANCE) }),
    /** so many seconds pass and no check has failed */
    z.strictObject({ kind: z.literal("last"), seconds: whole(1, MAX_CHECK_SECONDS) }),
  ],
  { error: 'a goal: {"kind": ...}, one of reach, visit, stop, drive, last' },
);
export type Goal = z.infer<typeof goal>;

const allowed = z.strictObject(
  {
    drivers: someOf(["me", "program", "remote"], "drivers").min(1, {
      error: "at least one driver",
    }),
    /** most lines of a program, "otherwise" not counted */
    lines: whole(0, MAX_RULES),
    /** null: all of the menu */
    conditions: someOf(conditionNames, "conditions").nullable(),
    /** null: all of the menu */
    actions: someOf(plainActions, "actions").nullable(),
    /** what may be changed in the program that the challenge begins with */
    edits: someOf(editKinds, "edits"),
    /** whether the maze may be changed */
    maze: z.boolean({ error: "true or false" }),
  },
  {
    error:
      'what is allowed: {"drivers", "lines", "conditions", "actions", "edits", "maze"}, all of them',
  },
);

const checks = z.strictObject(
  {
    /** most bumps; null where they do not matter */
    bumps: whole(0, MAX_CHECK_BUMPS).nullable(),
    /** most seconds of simulated time that a maze may take */
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
    /** what the reader begins with; null: an empty program that goes forward */
    program: programSchema.nullable(),
    goal,
    allowed,
    checks,
    /** what a good solution takes; null where there is no such figure */
    par: par.nullable(),
  },
  { error: "a challenge: an object" },
);
export type ChallengeDocument = z.infer<typeof shape>;

/** The document with its rules between fields. */
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
  if (to.kind === "stop" && to.from > to.to) refuse(["goal", "from"], "at most what `to` says");
  if (to.kind === "last" && to.seconds > checked.seconds) {
    refuse(["goal", "seconds"], "at most the seconds of the checks");
  }
  if (program !== null && program.rules.length > may.lines) {
    refuse(["allowed", "lines"], `at least the ${program.rules.length} lines that it begins with`);
  }
});

/** The largest legal document with room for indentation. */
const MAX_TEXT_LENGTH = 2_097_152;

/** Reads a challenge from a parsed value. */
export function parseChallenge(input: unknown): ReadResult<ChallengeDocument> {
  return readValue(challengeSchema, input);
}

/** Reads a challenge from JSON text. */
export function readChallenge(text: string): ReadResult<ChallengeDocument> {
  return readJson(challengeSchema, text, MAX_TEXT_LENGTH);
}
