/**
 * The commands of the micromouse simulator mms, one a line. Names are case-sensitive, and spaces
 * separate words.
 */
import { isColorLetter, type ColorLetter } from "./mark-colors.ts";
import { isStatName, type StatName } from "./score.ts";

/** Eighths of a full turn clockwise from ahead. */
const wallDirections = {
  wallFront: 0,
  wallFrontRight: 1,
  wallRight: 2,
  wallBackRight: 3,
  wallBack: 4,
  wallBackLeft: 5,
  wallLeft: 6,
  wallFrontLeft: 7,
} as const;

/** Eighths of a full turn clockwise. */
const turns = {
  turnRight: 2,
  turnRight90: 2,
  turnRight45: 1,
  turnLeft: -2,
  turnLeft90: -2,
  turnLeft45: -1,
} as const;

/** Half steps of one step. */
const moves = { moveForward: 2, moveForwardHalf: 1 } as const;

/** The sides of a cell, clockwise from north. */
export const sideNames = ["n", "e", "s", "w"] as const;
export type SideName = (typeof sideNames)[number];

/** A command that has a response. They run one after the other. */
export type RobotCommand =
  | { do: "width" | "height" | "was-reset" | "acknowledge-reset" }
  /** `eighths`: direction clockwise from ahead; `halfSteps`: 1 or more */
  | { do: "wall"; eighths: number; halfSteps: number }
  /** `halfSteps` may be 0 or negative */
  | { do: "move"; halfSteps: number }
  | { do: "turn"; eighths: (typeof turns)[keyof typeof turns] }
  | { do: "stat"; name: StatName };

/** A command without a response, which takes effect at once. */
export type DisplayCommand =
  | { do: "set-wall" | "clear-wall"; x: number; y: number; side: SideName }
  | { do: "set-color"; x: number; y: number; color: ColorLetter }
  | { do: "set-text"; x: number; y: number; text: string }
  | { do: "clear-color" | "clear-text"; x: number; y: number }
  | { do: "clear-all-color" | "clear-all-text" };

export type MouseCommand =
  | { kind: "robot"; command: RobotCommand }
  | { kind: "display"; command: DisplayCommand };

/** @returns null for a line that is not a command */
export function readMouseCommand(line: string): MouseCommand | null {
  const display = readText(line) ?? readDisplay(line);
  if (display !== null) return { kind: "display", command: display };
  const command = readRobot(line);
  return command === null ? null : { kind: "robot", command };
}

function readRobot(line: string): RobotCommand | null {
  const [name = "", argument, ...others] = wordsOf(line);
  if (others.length > 0) return null;
  if (name === "getStat") {
    return argument !== undefined && isStatName(argument) ? { do: "stat", name: argument } : null;
  }
  const steps = numberOf(argument);
  if (isKeyOf(wallDirections, name)) {
    return { do: "wall", eighths: wallDirections[name], halfSteps: Math.max(1, steps) };
  }
  if (isKeyOf(moves, name)) return { do: "move", halfSteps: steps * moves[name] };
  if (argument !== undefined) return null;
  if (isKeyOf(turns, name)) return { do: "turn", eighths: turns[name] };
  switch (name) {
    case "mazeWidth":
      return { do: "width" };
    case "mazeHeight":
      return { do: "height" };
    case "wasReset":
      return { do: "was-reset" };
    case "ackReset":
      return { do: "acknowledge-reset" };
    default:
      return null;
  }
}

function readDisplay(line: string): DisplayCommand | null {
  const [name = "", ...words] = wordsOf(line);
  if (name === "clearAllColor" || name === "clearAllText") {
    if (words.length > 0) return null;
    return { do: name === "clearAllColor" ? "clear-all-color" : "clear-all-text" };
  }
  const [x, y] = words.slice(0, 2).map(integerOf);
  if (x === undefined || y === undefined || x === null || y === null) return null;
  const [, , value] = words;
  if (name === "clearColor" || name === "clearText") {
    if (words.length !== 2) return null;
    return { do: name === "clearColor" ? "clear-color" : "clear-text", x, y };
  }
  if (words.length !== 3 || value === undefined) return null;
  if (name === "setColor")
    return isColorLetter(value) ? { do: "set-color", x, y, color: value } : null;
  if (name !== "setWall" && name !== "clearWall") return null;
  const side = sideNames.find((each) => each === value);
  return side === undefined
    ? null
    : { do: name === "setWall" ? "set-wall" : "clear-wall", x, y, side };
}

/** Texts may contain spaces. */
function readText(line: string): DisplayCommand | null {
  const found = /^setText +(\S+) +(\S+)(?: (.*))?$/.exec(line);
  const [x, y] = [integerOf(found?.[1] ?? ""), integerOf(found?.[2] ?? "")];
  return x === null || y === null ? null : { do: "set-text", x, y, text: found?.[3] ?? "" };
}

function wordsOf(line: string): string[] {
  return line.split(" ").filter((word) => word !== "");
}

/** A missing number is 1, a word that is no integer is 0. */
function numberOf(word: string | undefined): number {
  return word === undefined ? 1 : (integerOf(word) ?? 0);
}

/** @returns null for a word that is no 32-bit integer */
function integerOf(word: string): number | null {
  if (!/^[+-]?\d{1,10}$/.test(word)) return null;
  const number = Number(word);
  return number === (number | 0) ? number : null;
}

function isKeyOf<T extends object>(table: T, name: string): name is keyof T & string {
  return Object.hasOwn(table, name);
}
