/** The generated mazes of a task, which a student does not see before the check. */
import { generateMaze, mazeKinds, type MazeDocument } from "@corridor/maze";
import { z } from "zod";
import {
  MAX_UNSEEN_COUNT,
  MAX_UNSEEN_SEED,
  MAX_UNSEEN_SIDE,
  MIN_UNSEEN_SIDE,
} from "./challenge-limits.ts";
import { whole } from "./task-schema.ts";

const side = whole(MIN_UNSEEN_SIDE, MAX_UNSEEN_SIDE).refine((length) => length % 2 === 1, {
  error: `an odd number from ${MIN_UNSEEN_SIDE} to ${MAX_UNSEEN_SIDE}`,
});

export const unseenSchema = z
  .strictObject(
    {
      kind: z.enum(mazeKinds, { error: `one of ${mazeKinds.join(", ")}` }),
      columns: side,
      rows: side,
      seed: whole(0, MAX_UNSEEN_SEED),
      /** number of mazes */
      count: whole(1, MAX_UNSEEN_COUNT),
      /** minimum number of mazes in which an attempt must pass */
      pass: whole(1, MAX_UNSEEN_COUNT),
    },
    {
      error:
        'unseen mazes: {"kind", "columns", "rows", "seed", "count", "pass"}, all of them, or null',
    },
  )
  .check(({ value, issues }) => {
    if (value.pass <= value.count) return;
    const message = "at most the value of `count`";
    issues.push({ code: "custom", path: ["pass"], message, input: value.pass });
  });
export type UnseenMazes = z.infer<typeof unseenSchema>;

/** Seeds of one group of unseen mazes. */
const SEEDS = 1_000;

/** Generates an unseen maze. @param number from 1 to `count` */
export function unseenMaze(
  { kind, columns, rows, seed }: UnseenMazes,
  number: number,
): MazeDocument {
  const name = unseenName({ kind, seed }, number);
  return generateMaze({ kind, columns, rows, seed: seed * SEEDS + number, name });
}

/** The English name of an unseen maze, such as "tree 31 of seed 7". */
export function unseenName(
  { kind, seed }: Pick<UnseenMazes, "kind" | "seed">,
  number: number,
): string {
  return `${kind} ${number} of seed ${seed}`;
}
