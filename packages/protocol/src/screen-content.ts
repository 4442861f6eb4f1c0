/**
 * What a dashboard sends to the big screens of its class: numbers, and at most one run. It names no
 * student. The relay forwards it unread.
 */
import { z } from "zod";
import { MAX_CODE } from "./class-quantities.ts";
import { MAX_PROGRAM_LINK } from "./class.ts";
import { tileSchema } from "./class-tile.ts";
import { MAX_RACERS } from "./max-racers.ts";

const MAX_CELLS = 400;
const count = z.int().min(0).max(1_000_000);

/** A robot in a maze, as the page of a student displays it. */
const runFields = { task: true, maze: true, pose: true, path: true, line: true } as const;
const runSchema = tileSchema.pick(runFields).extend({
  /** link text of the program without names; null: not known, or a drive */
  program: z.string().max(MAX_PROGRAM_LINK).nullable(),
  /** whether the teacher's page has verified the solution */
  isSolved: z.boolean(),
});
export type ScreenRun = z.infer<typeof runSchema>;

/** A program that solves the task. */
const racerSchema = z.strictObject({
  /** completion code */
  code: z.string().min(1).max(MAX_CODE),
  /** students with this program */
  count: count.min(1),
});
export type Racer = z.infer<typeof racerSchema>;

export const screenContentSchema = z.strictObject({
  task: tileSchema.shape.task,
  solved: count,
  /** students */
  all: count,
  /** to solve the task; null: nobody has */
  medianMs: z.number().min(0).nullable(),
  /** most common number of lines, in `count` of `all` solutions; null: none with a program */
  lines: z.strictObject({ value: count, count, all: count }).nullable(),
  /** the maze of `bumps`, as in tiles */
  maze: tileSchema.shape.maze,
  bumps: z.array(z.strictObject({ column: count, row: count, count })).max(MAX_CELLS),
  /** number of bumps in that maze, in other given ones, and in other unseen ones */
  bumpCounts: z.strictObject({ most: count, given: count, unseen: count }),
  run: runSchema.nullable(),
  /** the verified programs of the task, and the maze in which they race, as in tiles */
  racers: z.array(racerSchema).max(MAX_RACERS),
  raceMaze: tileSchema.shape.maze.unwrap(),
  /** students whose programs have no room in the race */
  missing: count,
});
export type ScreenContent = z.infer<typeof screenContentSchema>;

/** The same without the run, which the worker adds. */
export type ScreenNumbers = Omit<ScreenContent, "run">;
