/**
 * The schema of a task: one or more mazes, a goal, permissions, checks, and texts in one language. A
 * challenge document of version 1 is one task; a lesson, version 2, has several.
 */
import { mazeSchema, type MazeDocument } from "@corridor/maze";
import { MAX_NAME_LENGTH, MAX_RULES, programSchema, type ProgramDocument } from "@corridor/program";
import { plainActions, sensorNames } from "@corridor/protocol";
import { z } from "zod";
import {
  conditionNames,
  editKinds,
  helpKinds,
  MAX_CHALLENGE_MAZES,
  MAX_CHECK_BUMPS,
  MAX_GOAL_DISTANCE,
  MAX_HINTS,
  MAX_SHORT_LENGTH,
  MAX_TASK_LENGTH,
  toolNames,
} from "./challenge-limits.ts";

/** Schema of a bounded text. */
export const textOf = (max: number) =>
  z
    .string({ error: `a text of at most ${max} characters` })
    .max(max, { error: `a text of at most ${max} characters` });

/** Schema of a bounded whole number. */
export const whole = (min: number, max: number) => {
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

const goalWithin = (maxSeconds: number) =>
  z.discriminatedUnion(
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
      z.strictObject({ kind: z.literal("last"), seconds: whole(1, maxSeconds) }),
    ],
    { error: 'a goal: {"kind": ...}, one of reach, visit, stop, drive, last' },
  );
export type Goal = z.infer<ReturnType<typeof goalWithin>>;

const allowedFields = {
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
};

/** Schema of the permissions in a challenge document of version 1. */
export const allowedInChallenge = z.strictObject(allowedFields, {
  error:
    'what is allowed: {"drivers", "lines", "conditions", "actions", "edits", "maze"}, all of them',
});

/** Schema of the permissions in a task of a lesson. */
export const allowedInLesson = z.strictObject(
  {
    ...allowedFields,
    /** tools of the page besides maze and program; null allows all */
    tools: subsetOf(toolNames, "tools").nullable(),
    /** what the page explains; null allows all */
    help: subsetOf(helpKinds, "kinds of help").nullable(),
  },
  {
    error:
      'what is allowed: {"drivers", "lines", "conditions", "actions", "edits", "maze", "tools", "help"}, all of them',
  },
);

/**
 * Fields that the tasks of both versions share.
 * @param maxSeconds maximum time limit per maze, in seconds of simulated time
 */
export function taskFields(maxSeconds: number) {
  return {
    name: textOf(MAX_NAME_LENGTH),
    words,
    mazes: z
      .array(mazeSchema, { error: "a list of mazes" })
      .min(1, { error: "at least one maze" })
      .max(MAX_CHALLENGE_MAZES, { error: `at most ${MAX_CHALLENGE_MAZES} mazes` }),
    /** the starting program; null for an empty program that drives forward */
    program: programSchema.nullable(),
    goal: goalWithin(maxSeconds),
    checks: z.strictObject(
      {
        /** maximum number of bumps; null for no limit */
        bumps: whole(0, MAX_CHECK_BUMPS).nullable(),
        /** time limit per maze, in seconds of simulated time */
        seconds: whole(1, maxSeconds),
      },
      { error: 'checks: {"bumps": ..., "seconds": ...}' },
    ),
    /** reference values of a good solution, or null */
    par: z
      .strictObject(
        { lines: whole(0, MAX_RULES), seconds: real(0, maxSeconds) },
        { error: 'a par: {"lines": ..., "seconds": ...} or null' },
      )
      .nullable(),
  };
}

/** The parts of a task of either version that the check of an attempt depends on. */
export interface Task {
  name: string;
  mazes: readonly MazeDocument[];
  program: ProgramDocument | null;
  goal: Goal;
  allowed: z.infer<typeof allowedInChallenge>;
  checks: { bumps: number | null; seconds: number };
}

/** A problem at a path of a document, in the words of a schema's error. */
type Refuse = (path: (string | number)[], message: string) => void;

/** The rules that concern several fields of a task. */
export function findContradictions(
  { mazes, goal, allowed, checks, program }: Task,
  refuse: Refuse,
) {
  if (goal.kind === "reach") {
    for (const [number, { goals }] of mazes.entries()) {
      if (goals.length === 0)
        refuse(["mazes", number, "goals"], "at least one goal, to be reached");
    }
  }
  if (goal.kind === "stop" && goal.from > goal.to) {
    refuse(["goal", "from"], "at most the value of `to`");
  }
  if (goal.kind === "last" && goal.seconds > checks.seconds) {
    refuse(["goal", "seconds"], "at most the seconds of the checks");
  }
  if (program !== null && program.rules.length > allowed.lines) {
    refuse(["allowed", "lines"], `at least the ${program.rules.length} lines of its program`);
  }
}
