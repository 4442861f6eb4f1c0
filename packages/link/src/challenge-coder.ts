/**
 * A challenge as bits, written and read by one function: words, mazes, the program it begins with,
 * goal, what is allowed, checks and par.
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

/** What a decoder hands to `codeProgram`; it is not read. */
const anyProgram: ProgramDocument = {
  format: "corridor/program",
  version: 1,
  name: "",
  default: "forward",
  rules: [],
};

/**
 * Writes or reads a challenge.
 * @param challenge what to write; a decoder is given any legal challenge and ignores it
 * @returns the challenge as a decoder will read it, still to be checked by its schema; null where a
 * link asks for what no encoder writes
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
    // Most mazes of a challenge are called like it.
    const isNamed = codeBit(maze.name !== name);
    const written = isNamed ? maze : { ...maze, name: "" };
    const read = codeMaze(coder, written, choices.waysOf(written));
    if (read === null) return null;
    mazes.push(isNamed ? read : { ...read, name });
  }

  let program: ProgramDocument | null = null;
  if (codeBit(challenge.program !== null)) {
    const written = challenge.program ?? anyProgram;
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
      const wanted = goal.kind === kind ? goal : { sensor: "front" as const, from: 0, to: 0 };
      const at = codeUniform(coder, sensorNames.length, sensorNames.indexOf(wanted.sensor));
      const from = reals.code(coder, wanted.from);
      return { kind, sensor: sensorNames[at] ?? "front", from, to: reals.code(coder, wanted.to) };
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

/** Words from a short list, in the order in which they stand. */
function codeList<const Word extends string>(
  coder: BitCoder,
  words: readonly Word[],
  chosen: readonly Word[],
): Word[] {
  const count = codeUniform(coder, words.length + 1, chosen.length);
  return Array.from({ length: count }, (_, at) => {
    const place = codeUniform(coder, words.length, words.indexOf(chosen[at] as Word));
    return words[place] as Word;
  });
}
