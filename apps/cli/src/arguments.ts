/** The words of the command line, checked. */
import { parseArgs } from "node:util";
import { InputError } from "./input-error.ts";
import { untils, type RunLimits, type Until } from "./run-limits.ts";

/** One tick, and a day of simulated time. */
const MIN_SECONDS = 1 / 60;
const MAX_SECONDS = 86_400;

export interface SimulateArguments {
  maze: string;
  /** the program's file; null when commands drive */
  program: string | null;
  /** the file of timed commands; null when a program drives */
  commands: string | null;
  limits: RunLimits;
  /** print the digest of all snapshots instead of the result */
  digest: boolean;
}

export interface GradeArguments {
  mazes: string[];
  programs: string[];
  limits: RunLimits;
  csv: boolean;
  /** adds why each run failed */
  why: boolean;
}

export function simulateArguments(words: readonly string[]): SimulateArguments {
  const { values } = parse(words, {
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
    problems.push("--commands: found beside --program or without --digest, expected with --digest");
  }
  const limits = limitsOf(values.seconds, values.until, problems);
  if (values.digest && limits.until !== "time") {
    problems.push(`--until: found "${limits.until}" beside --digest, expected "time"`);
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

export function gradeArguments(words: readonly string[]): GradeArguments {
  // `--program a b c` takes all files up to the next option, as a shell's `*.json` gives them.
  const { values } = parse(spread(words, ["--program", "--maze"]), {
    maze: { type: "string", multiple: true, default: [] },
    program: { type: "string", multiple: true, default: [] },
    seconds: { type: "string", default: "300" },
    until: { type: "string", default: "time" },
    csv: { type: "boolean", default: false },
    why: { type: "boolean", default: false },
  });
  const problems: string[] = [];
  if (values.program.length === 0) {
    problems.push("--program: found nothing, expected one or more program files");
  }
  if (values.maze.length === 0) {
    problems.push("--maze: found nothing, expected one or more maze files");
  }
  const limits = limitsOf(values.seconds, values.until, problems);
  const { csv, why } = values;
  if (csv && why)
    problems.push("--why: found beside --csv, expected without it: a diagnosis is JSON");
  if (problems.length > 0) throw new InputError(problems);
  return { mazes: values.maze, programs: values.program, limits, csv, why };
}

function parse<T extends NonNullable<Parameters<typeof parseArgs>[0]>["options"] & object>(
  words: readonly string[],
  options: T,
) {
  try {
    return parseArgs({ args: [...words], options, allowPositionals: false, strict: true });
  } catch (error) {
    const found = error instanceof Error ? error.message : "unreadable options";
    const names = Object.keys(options).map((name) => `--${name}`);
    throw new InputError([`options: found ${found} Expected only ${names.join(", ")}`]);
  }
}

/** Repeats an option before each of its values: `--maze a b` becomes `--maze a --maze b`. */
function spread(words: readonly string[], options: readonly string[]): string[] {
  const result: string[] = [];
  let option: string | null = null;
  let isFirst = false;
  for (const word of words) {
    if (word.startsWith("--")) {
      option = options.includes(word) ? word : null;
      isFirst = true;
    } else {
      if (option !== null && !isFirst) result.push(option);
      isFirst = false;
    }
    result.push(word);
  }
  return result;
}

function limitsOf(seconds: string, until: string, problems: string[]): RunLimits {
  const number = Number(seconds);
  if (seconds.trim() === "" || !(number >= MIN_SECONDS && number <= MAX_SECONDS)) {
    problems.push(
      `--seconds: found ${JSON.stringify(seconds)}, expected a number from 1/60 (one tick) to ${MAX_SECONDS}`,
    );
  }
  if (!isUntil(until)) {
    problems.push(`--until: found ${JSON.stringify(until)}, expected one of ${untils.join(", ")}`);
    return { seconds: number, until: "time" };
  }
  return { seconds: number, until };
}

function isUntil(word: string): word is Until {
  return (untils as readonly string[]).includes(word);
}
