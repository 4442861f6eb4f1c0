/** Parses and validates the command-line arguments. */
import { parseArgs } from "node:util";
import { InputError } from "./input-error.ts";
import { runEnds, type RunLimits, type RunEnd } from "./run-limits.ts";

/** Bounds of --seconds in simulated time: one tick and one day. */
const MIN_SECONDS = 1 / 60;
const MAX_SECONDS = 86_400;

export interface SimulateArguments {
  maze: string;
  /** path of the program file; null when timed commands drive the robot */
  program: string | null;
  /** path of the file of timed commands; null when a program drives the robot */
  commands: string | null;
  limits: RunLimits;
  /** Print the digest of all snapshots instead of the result. */
  digest: boolean;
}

export interface GradeArguments {
  mazes: string[];
  programs: string[];
  limits: RunLimits;
  csv: boolean;
  /** Add the diagnosis of each failed run. */
  why: boolean;
}

export function simulateArguments(args: readonly string[]): SimulateArguments {
  const { values } = parse(args, {
    maze: { type: "string" },
    program: { type: "string" },
    commands: { type: "string" },
    seconds: { type: "string", default: "120" },
    until: { type: "string", default: "time" },
    digest: { type: "boolean", default: false },
  });
  const problems: string[] = [];
  const { maze, program, commands } = values;
  if (maze === undefined) problems.push("--maze: found nothing, expected a maze file");
  if (program === undefined && commands === undefined) {
    problems.push("--program: found nothing, expected a program file");
  }
  if (commands !== undefined && (program !== undefined || !values.digest)) {
    problems.push(
      "--commands: found with --program or without --digest, expected with --digest and without --program",
    );
  }
  const limits = parseLimits(values.seconds, values.until, problems);
  if (values.digest && limits.until !== "time") {
    problems.push(`--until: found "${limits.until}" with --digest, expected "time"`);
  }
  if (problems.length > 0 || maze === undefined) throw new InputError(problems);
  return {
    maze,
    program: program ?? null,
    commands: commands ?? null,
    limits,
    digest: values.digest,
  };
}

/** The options of `grade` before validation. */
export type GradeOptions = ReturnType<typeof gradeOptions>;

export function gradeOptions(args: readonly string[]) {
  // `--program a b c` accepts all files up to the next option, as a shell expands `*.json`.
  const { values } = parse(repeatOptions(args, ["--program", "--maze"]), {
    maze: { type: "string", multiple: true, default: [] },
    program: { type: "string", multiple: true, default: [] },
    seconds: { type: "string" },
    until: { type: "string" },
    csv: { type: "boolean", default: false },
    why: { type: "boolean", default: false },
    challenge: { type: "string" },
    handins: { type: "string" },
    unseen: { type: "string" },
    junit: { type: "string" },
    require: { type: "string" },
  });
  return values;
}

/** The arguments of `grade` without `--challenge`. */
export function gradeArguments(options: GradeOptions): GradeArguments {
  const { csv, why } = options;
  const problems: string[] = [];
  for (const name of ["handins", "unseen", "junit", "require"] as const) {
    if (options[name] !== undefined) {
      problems.push(`--${name}: found without --challenge, expected with --challenge`);
    }
  }
  if (options.program.length === 0) {
    problems.push("--program: found nothing, expected one or more program files");
  }
  if (options.maze.length === 0) {
    problems.push("--maze: found nothing, expected one or more maze files");
  }
  const limits = parseLimits(options.seconds ?? "300", options.until ?? "time", problems);
  if (csv && why)
    problems.push("--why: found with --csv, expected without --csv: a diagnosis is JSON");
  if (problems.length > 0) throw new InputError(problems);
  return { mazes: options.maze, programs: options.program, limits, csv, why };
}

function parse<T extends NonNullable<Parameters<typeof parseArgs>[0]>["options"] & object>(
  args: readonly string[],
  options: T,
) {
  try {
    return parseArgs({ args: [...args], options, allowPositionals: false, strict: true });
  } catch (error) {
    const found = error instanceof Error ? error.message : "Invalid options";
    const names = Object.keys(options).map((name) => `--${name}`);
    throw new InputError([`${found.replace(/\.?$/, ".")} The options are ${names.join(", ")}.`]);
  }
}

/** Repeats an option before each of its values: `--maze a b` becomes `--maze a --maze b`. */
function repeatOptions(args: readonly string[], options: readonly string[]): string[] {
  const result: string[] = [];
  let option: string | null = null;
  let isFirst = false;
  for (const arg of args) {
    if (arg.startsWith("--")) {
      option = options.includes(arg) ? arg : null;
      isFirst = true;
    } else {
      if (option !== null && !isFirst) result.push(option);
      isFirst = false;
    }
    result.push(arg);
  }
  return result;
}

function parseLimits(seconds: string, until: string, problems: string[]): RunLimits {
  const number = Number(seconds);
  if (seconds.trim() === "" || !(number >= MIN_SECONDS && number <= MAX_SECONDS)) {
    problems.push(
      `--seconds: found ${JSON.stringify(seconds)}, expected a number from 1/60 (one tick) to ${MAX_SECONDS}`,
    );
  }
  if (!isRunEnd(until)) {
    problems.push(`--until: found ${JSON.stringify(until)}, expected one of ${runEnds.join(", ")}`);
    return { seconds: number, until: "time" };
  }
  return { seconds: number, until };
}

function isRunEnd(value: string): value is RunEnd {
  return (runEnds as readonly string[]).includes(value);
}
