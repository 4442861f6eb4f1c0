/** Validates the arguments of `grade --challenge`. */
import { unseenSchema, type UnseenMazes } from "@corridor/challenge";
import { describeProblem, readValue } from "@corridor/protocol";
import type { GradeOptions } from "../arguments.ts";
import { InputError } from "../input-error.ts";

export interface LessonArguments {
  /** file or link of the lesson */
  challenge: string;
  programs: string[];
  /** file of links, "-" for standard input, or null */
  handIns: string | null;
  /** replaces the unseen mazes of every task, unless null */
  unseen: UnseenMazes | null;
  csv: boolean;
  /** file of the JUnit report, or null */
  junit: string | null;
  /** share of the lines that must pass, in per cent, or null */
  required: number | null;
}

/** Options of `grade` that a lesson replaces, and by what. */
const replaced = {
  maze: "the lesson contains its mazes",
  seconds: "the lesson contains its time limits",
  until: "each goal of the lesson ends its run",
  why: "a lesson's lines have a code instead",
} as const;

/** @throws InputError with every problem */
export function lessonArguments(challenge: string, options: GradeOptions): LessonArguments {
  const { program, handins, csv, junit } = options;
  const problems: string[] = [];
  for (const name of ["maze", "seconds", "until", "why"] as const) {
    const value = options[name];
    const isGiven = Array.isArray(value)
      ? value.length > 0
      : value !== undefined && value !== false;
    if (isGiven) {
      problems.push(
        `--${name}: found with --challenge, expected without --challenge: ${replaced[name]}`,
      );
    }
  }
  if (program.length === 0 && handins === undefined) {
    problems.push("--program: found nothing, expected program files, or --handins with links");
  }
  if (csv && junit !== undefined) {
    problems.push("--junit: found with --csv, expected without --csv");
  }
  const unseen = options.unseen === undefined ? null : parseUnseen(options.unseen, problems);
  const required = options.require === undefined ? null : parseRequired(options.require, problems);
  if (problems.length > 0) throw new InputError(problems);
  return {
    challenge,
    programs: program,
    handIns: handins ?? null,
    unseen,
    csv,
    junit: junit ?? null,
    required,
  };
}

/** Parses the value of `--unseen`, such as "tree:11x11:50:7": an attempt must pass in all mazes. */
function parseUnseen(text: string, problems: string[]): UnseenMazes | null {
  const match = /^([^:]*):(\d{1,9})x(\d{1,9}):(\d{1,9}):(\d{1,9})$/.exec(text);
  if (match === null) {
    const found = JSON.stringify(text);
    problems.push(
      `--unseen: found ${found}, expected KIND:COLUMNSxROWS:COUNT:SEED, such as tree:11x11:50:7`,
    );
    return null;
  }
  const [, kind, ...numbers] = match;
  const [columns, rows, count, seed] = numbers.map(Number);
  const read = readValue(unseenSchema, { kind, columns, rows, seed, count, pass: count });
  if (read.ok) return read.value;
  const described = read.problems.filter(({ path }) => path !== "pass").map(describeProblem);
  problems.push(...described.map((each) => `--unseen: ${each}`));
  return null;
}

/** Parses the value of `--require`. @returns the share in per cent */
function parseRequired(text: string, problems: string[]): number | null {
  if (text === "all") return 100;
  const percent = Number(/^(\d{1,3})%$/.exec(text)?.[1]);
  if (percent >= 1 && percent <= 100) return percent;
  const found = JSON.stringify(text);
  problems.push(`--require: found ${found}, expected all, or a whole number from 1% to 100%`);
  return null;
}
