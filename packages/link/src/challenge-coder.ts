/**
 * Codes a challenge as bits, with one function for encoding and decoding: texts, mazes, starting
 * program, goal, permissions, checks and par.
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
import { MAX_NAME_LENGTH } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import { plainActions, sensorNames } from "@corridor/protocol";
import type { Choices } from "./edit-coder.ts";
import { codeMaze } from "./maze-coder.ts";
import { codeName } from "./name-coder.ts";
import { codeUniform, NumberModel, RealModel } from "./numbers.ts";
import { codeProgram } from "./program-coder.ts";
import type { BitCoder } from "./range-coder.ts";

const goalKinds = ["reach", "visit", "stop", "drive", "last"] as const;
const driverNames = ["me", "program", "remote"] as const;

/** Program that a decoder passes to `codeProgram`, which ignores it. */
const placeholderProgram: ProgramDocument = {
  format: "corridor/program",
  version: 1,
  name: "",
  default: "forward",
  rules: [],
};

/**
 * Encodes or decodes a challenge.
 * @param challenge the challenge to encode; a decoder ignores it, and its caller passes any valid
 *   one
 * @returns the decoded challenge, not yet checked by its schema; null if the bits cannot come from
 *   an encoder
 */
export function codeChallenge(
  coder: BitCoder,
  challenge: ChallengeDocument,
  choices: Choices,
): ChallengeDocument | null {
  const numbers = new NumberModel();
  const reals = new RealModel();
  const codeText = (text: string, max: number): string =>
    codeName(coder, text, max, choices.isPlainName(text));
  const codeBit = (isSet: boolean): boolean => coder.bit(1, 1, isSet ? 1 : 0) === 1;

  const name = codeText(challenge.name, MAX_NAME_LENGTH);
  const task = codeText(challenge.words.task, MAX_TASK_LENGTH);
  const short = codeText(challenge.words.short, MAX_SHORT_LENGTH);
  const hintCount = codeUniform(coder, MAX_HINTS + 1, challenge.words.hints.length);
  const hints = Array.from({ length: hintCount }, (_, at) =>
    codeText(challenge.words.hints[at] ?? "", MAX_TASK_LENGTH),
  );

  const mazeCount = codeUniform(coder, MAX_CHALLENGE_MAZES, challenge.mazes.length - 1) + 1;
  const mazes: ChallengeDocument["mazes"] = [];
  for (let at = 0; at < mazeCount; at += 1) {
    const maze = challenge.mazes[at] ?? challenge.mazes[0];
    if (maze === undefined) return null;
    // Most mazes have the name of their challenge.
    const isNamed = codeBit(maze.name !== name);
    const written = isNamed ? maze : { ...maze, name: "" };
    const read = codeMaze(coder, written, choices.mazeChoicesOf(written));
    if (read === null) return null;
    mazes.push(isNamed ? read : { ...read, name });
  }

  let program: ProgramDocument | null = null;
  if (codeBit(challenge.program !== null)) {
    const written = challenge.program ?? placeholderProgram;
    program = codeProgram(coder, written, choices.isPlainName(written.name));
    if (program === null) return null;
  }

  const goal = codeGoal(coder, challenge.goal, numbers, reals);
  const { allowed, checks, par } = challenge;
  const drivers = codeList(coder, driverNames, allowed.drivers);
  const lines = numbers.code(coder, allowed.lines);
  const conditions = codeBit(allowed.conditions !== null)
    ? codeList(coder, conditionNames, allowed.conditions ?? [])
    : null;
  const actions = codeBit(allowed.actions !== null)
    ? codeList(coder, plainActions, allowed.actions ?? [])
    : null;
  const edits = codeList(coder, editKinds, allowed.edits);
  const maze = codeBit(allowed.maze);
  const bumps = codeBit(checks.bumps !== null) ? numbers.code(coder, checks.bumps ?? 0) : null;
  const seconds = numbers.code(coder, checks.seconds);
  const coded: ChallengeDocument = {
    format: "corridor/challenge",
    version: 1,
    name,
    words: { task, short, hints },
    mazes,
    program,
    goal,
    allowed: { drivers, lines, conditions, actions, edits, maze },
    checks: { bumps, seconds },
    par: null,
  };
  if (codeBit(par !== null)) {
    const parLines = numbers.code(coder, par?.lines ?? 0);
    coded.par = { lines: parLines, seconds: reals.code(coder, par?.seconds ?? 0) };
  }
  return coded;
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

/** Codes a list of entries from a fixed set, in list order. */
function codeList<const Name extends string>(
  coder: BitCoder,
  names: readonly Name[],
  chosen: readonly Name[],
): Name[] {
  const count = codeUniform(coder, names.length + 1, chosen.length);
  return Array.from({ length: count }, (_, at) => {
    const index = codeUniform(coder, names.length, names.indexOf(chosen[at] as Name));
    return names[index] as Name;
  });
}
