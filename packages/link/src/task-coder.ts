/**
 * Codes the fields that challenges and the tasks of lessons share, with one function for encoding
 * and decoding: texts, mazes, starting program, goal, permissions, checks and par.
 */
import {
  conditionNames,
  editKinds,
  MAX_CHALLENGE_MAZES,
  MAX_HINTS,
  MAX_SHORT_LENGTH,
  MAX_TASK_LENGTH,
  type ChallengeDocument,
  type Goal,
} from "@corridor/challenge";
import { MAX_NAME_LENGTH, type MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import { plainActions, sensorNames } from "@corridor/protocol";
import { codeUniform, type NumberModel, type RealModel } from "./numbers.ts";
import { placeholderMaze, placeholderProgram } from "./placeholders.ts";
import type { BitCoder } from "./range-coder.ts";

export type TaskFields = Omit<ChallengeDocument, "format" | "version">;

/** A part of a task, in the order of its bits. */
export const taskParts = ["texts", "mazes", "program", "rules"] as const;
export type TaskPart = (typeof taskParts)[number];

/** How parts are coded that differ between a challenge and the tasks of a lesson. */
export interface TaskCoders {
  numbers: NumberModel;
  reals: RealModel;
  text: (text: string, maxLength: number) => string;
  /** @returns null if the bits cannot come from an encoder */
  maze: (maze: MazeDocument, taskName: string) => MazeDocument | null;
  /** @returns null if the bits cannot come from an encoder */
  program: (program: ProgramDocument) => ProgramDocument | null;
  /** codes a list of entries of `names`, by their indices */
  indices: (names: readonly string[], chosen: readonly number[]) => readonly number[];
  /** called after each part, in order */
  onPart: (part: TaskPart) => void;
}

const goalKinds = ["reach", "visit", "stop", "drive", "last"] as const;
const driverNames = ["me", "program", "remote"] as const;

/**
 * Encodes or decodes the fields.
 * @param task the task to encode; a decoder ignores it, and its caller passes any valid one
 * @returns the decoded fields, not yet checked by a schema; null if the bits cannot come from an
 *   encoder
 */
export function codeTask(coder: BitCoder, task: TaskFields, parts: TaskCoders): TaskFields | null {
  const { numbers, reals } = parts;
  const name = parts.text(task.name, MAX_NAME_LENGTH);
  const words = codeWords(coder, task.words, parts);
  parts.onPart("texts");

  const mazeCount = codeUniform(coder, MAX_CHALLENGE_MAZES, task.mazes.length - 1) + 1;
  const mazes: MazeDocument[] = [];
  for (let at = 0; at < mazeCount; at += 1) {
    const maze = parts.maze(task.mazes[at] ?? placeholderMaze, name);
    if (maze === null) return null;
    mazes.push(maze);
  }
  parts.onPart("mazes");

  let program: ProgramDocument | null = null;
  if (codeBit(coder, task.program !== null)) {
    program = parts.program(task.program ?? placeholderProgram);
    if (program === null) return null;
  }
  parts.onPart("program");

  const goal = codeGoal(coder, task.goal, numbers, reals);
  const allowed = codeAllowed(coder, task.allowed, parts);
  const { checks, par } = task;
  const bumps = codeBit(coder, checks.bumps !== null)
    ? numbers.code(coder, checks.bumps ?? 0)
    : null;
  const seconds = numbers.code(coder, checks.seconds);
  const coded: TaskFields = {
    name,
    words,
    mazes,
    program,
    goal,
    allowed,
    checks: { bumps, seconds },
    par: null,
  };
  if (codeBit(coder, par !== null)) {
    const parLines = numbers.code(coder, par?.lines ?? 0);
    coded.par = { lines: parLines, seconds: reals.code(coder, par?.seconds ?? 0) };
  }
  parts.onPart("rules");
  return coded;
}

/** Codes a bit without a model. */
export function codeBit(coder: BitCoder, isSet: boolean): boolean {
  return coder.bit(1, 1, isSet ? 1 : 0) === 1;
}

/** Codes a list of indices below `limit`, in list order. */
export function codeIndices(
  coder: BitCoder,
  limit: number,
  indices: readonly number[],
): readonly number[] {
  const count = codeUniform(coder, limit + 1, indices.length);
  return Array.from({ length: count }, (_, at) => codeUniform(coder, limit, indices[at] ?? 0));
}

/** Codes a list of entries from a fixed set, in list order. */
export function codeList<const Name extends string>(
  parts: Pick<TaskCoders, "indices">,
  names: readonly Name[],
  chosen: readonly Name[],
): Name[] {
  const indices = chosen.map((each) => names.indexOf(each));
  return parts.indices(names, indices).flatMap((at) => names[at] ?? []);
}

/** The same, or null for all of them. */
export function codeOptionalList<const Name extends string>(
  coder: BitCoder,
  parts: Pick<TaskCoders, "indices">,
  names: readonly Name[],
  chosen: readonly Name[] | null,
): Name[] | null {
  return codeBit(coder, chosen !== null) ? codeList(parts, names, chosen ?? []) : null;
}

function codeWords(
  coder: BitCoder,
  words: TaskFields["words"],
  { text }: TaskCoders,
): TaskFields["words"] {
  const task = text(words.task, MAX_TASK_LENGTH);
  const short = text(words.short, MAX_SHORT_LENGTH);
  const count = codeUniform(coder, MAX_HINTS + 1, words.hints.length);
  const hints = Array.from({ length: count }, (_, at) =>
    text(words.hints[at] ?? "", MAX_TASK_LENGTH),
  );
  return { task, short, hints };
}

function codeAllowed(
  coder: BitCoder,
  allowed: TaskFields["allowed"],
  parts: TaskCoders,
): TaskFields["allowed"] {
  const drivers = codeList(parts, driverNames, allowed.drivers);
  const lines = parts.numbers.code(coder, allowed.lines);
  const conditions = codeOptionalList(coder, parts, conditionNames, allowed.conditions);
  const actions = codeOptionalList(coder, parts, plainActions, allowed.actions);
  const edits = codeList(parts, editKinds, allowed.edits);
  return { drivers, lines, conditions, actions, edits, maze: codeBit(coder, allowed.maze) };
}

function codeGoal(coder: BitCoder, goal: Goal, numbers: NumberModel, reals: RealModel): Goal {
  const kind = goalKinds[codeUniform(coder, goalKinds.length, goalKinds.indexOf(goal.kind))];
  switch (kind) {
    case "stop": {
      const values = goal.kind === kind ? goal : { sensor: "front" as const, from: 0, to: 0 };
      const at = codeUniform(coder, sensorNames.length, sensorNames.indexOf(values.sensor));
      const from = reals.code(coder, values.from);
      return { kind, sensor: sensorNames[at] ?? "front", from, to: reals.code(coder, values.to) };
    }
    case "drive":
      return { kind, distance: reals.code(coder, goal.kind === kind ? goal.distance : 0) };
    case "last":
      return { kind, seconds: numbers.code(coder, goal.kind === kind ? goal.seconds : 0) };
    case "visit":
      return { kind };
    case "reach":
    case undefined:
      break;
  }
  return { kind: "reach" };
}
