/**
 * Measures the overhead of `grade` over the ticks themselves: 10 programs in 100 mazes of 33 x 33,
 * two simulated minutes each; and 5 programs in 1,000 unseen mazes of a lesson. Includes the
 * process start, reading files, starting workers and printing. The baseline runs the same ticks of
 * the same programs in the same mazes.
 */
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { availableParallelism, tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { checkMazeOf, countMazes, mazeOf, type LessonTask } from "@corridor/challenge";
import { generateTree, type MazeDocument } from "@corridor/maze";
import { programPresets, type ProgramDocument } from "@corridor/program";
import { median } from "./measure.ts";
import { Product } from "./product.ts";
import { taskIn } from "./task.ts";

const PROGRAMS = 10;
const MAZES = 100;
const SIDE = 33;
const SECONDS = 120;
const LESSON_PROGRAMS = 5;
const UNSEEN = 1_000;
const ROUNDS = 5;
/** The single-core speed is measured in every fourth maze, right before each grading. */
const SAMPLED_MAZE = 4;

const cli = fileURLToPath(new URL("../../apps/cli/src/main.ts", import.meta.url));

export interface GradingCost {
  /** elapsed seconds from start to end of the command, median of the rounds */
  seconds: number;
  /**
   * elapsed time relative to the ideal: the time of all ticks on a single core, divided by `cores`
   */
  timesIdeal: number;
  cores: number;
}

/** @throws Error if a command fails, or does not print one line per run and a summary */
export function measureGrading(program: ProgramDocument): {
  runs: GradingCost;
  lesson: GradingCost;
} {
  const folder = mkdtempSync(join(tmpdir(), "corridor-bench-"));
  const write = (name: string, document: unknown): string => {
    const file = join(folder, name);
    writeFileSync(file, JSON.stringify(document));
    return file;
  };
  try {
    const programs = Array.from(
      { length: PROGRAMS },
      (_, at) => programPresets[at % programPresets.length]?.program ?? program,
    );
    const programFiles = programs.map((each, at) => write(`program-${at}.json`, each));
    const mazeFiles = Array.from({ length: MAZES }, (_, at) => write(`maze-${at}.json`, tree(at)));
    const lesson = taskIn(tree(0), SECONDS);
    const task: LessonTask = {
      ...lesson.task,
      unseen: { kind: "tree", columns: 11, rows: 11, seed: 7, count: UNSEEN, pass: UNSEEN },
    };
    const lessonFile = write("lesson.json", lesson.document);
    const mazes = Array.from({ length: MAZES }, (_, at) => tree(at));
    return {
      runs: costOf(runsOf(mazes, programs, SECONDS * 60), () => {
        const limits = ["--seconds", `${SECONDS}`];
        grade([...limits, "--program", ...programFiles, "--maze", ...mazeFiles], PROGRAMS * MAZES);
      }),
      lesson: costOf(checksOf(task, programs.slice(0, LESSON_PROGRAMS)), () => {
        const options = ["--challenge", lessonFile, "--unseen", `tree:11x11:${UNSEEN}:7`];
        const files = programFiles.slice(0, LESSON_PROGRAMS);
        grade([...options, "--program", ...files], LESSON_PROGRAMS);
      }),
    };
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** @param runs what the grading runs, maze by maze */
function costOf(runs: readonly RawRun[], grading: () => void): GradingCost {
  const mazes = [...new Set(runs.map(({ maze }) => maze))];
  const sampled = new Set(mazes.filter((_, at) => at % SAMPLED_MAZE === 0));
  const sample = runs.filter(({ maze }) => sampled.has(maze));
  const share = ticksOf(sample) / ticksOf(runs);
  secondsOfTicks(sample);
  const cores = availableParallelism();
  const seconds: number[] = [];
  const timesIdeal: number[] = [];
  for (let round = 0; round < ROUNDS; round++) {
    const single = secondsOfTicks(sample) / share;
    const graded = secondsOf(grading);
    seconds.push(graded);
    timesIdeal.push((graded * cores) / single);
  }
  return { seconds: median(seconds), timesIdeal: median(timesIdeal), cores };
}

interface RawRun {
  maze: MazeDocument;
  program: ProgramDocument;
  ticks: number;
}

function runsOf(
  mazes: readonly MazeDocument[],
  programs: readonly ProgramDocument[],
  ticks: number,
): RawRun[] {
  return mazes.flatMap((maze) => programs.map((program) => ({ maze, program, ticks })));
}

/** The runs of all checks of a task: each ends where its check ends. */
function checksOf(task: LessonTask, programs: readonly ProgramDocument[]): RawRun[] {
  return Array.from({ length: countMazes(task) }, (_, at) => at).flatMap((at) => {
    const maze = mazeOf(task, at);
    return programs.map((program) => {
      const { ticks } = checkMazeOf(task, at, program);
      return { maze, program, ticks };
    });
  });
}

function ticksOf(runs: readonly RawRun[]): number {
  return runs.reduce((sum, { ticks }) => sum + ticks, 0);
}

/** Runs the ticks on this thread. Creating the simulations does not count. */
function secondsOfTicks(runs: readonly RawRun[]): number {
  const products = runs.map(({ maze, program }) => new Product(maze, program));
  return secondsOf(() => {
    for (const [at, product] of products.entries()) product.run(runs[at]?.ticks ?? 0);
  });
}

/** @param expected number of lines besides the summary */
function grade(args: readonly string[], expected: number): void {
  const output = execFileSync(process.execPath, [cli, "grade", ...args], { encoding: "utf8" });
  const lines = output.trimEnd().split("\n").length - 1;
  if (lines !== expected) throw new Error(`grade printed ${lines} lines, expected ${expected}`);
}

function tree(seed: number): MazeDocument {
  return generateTree({ columns: SIDE, rows: SIDE, seed, name: `Tree ${seed}` });
}

function secondsOf(action: () => void): number {
  const start = performance.now();
  action();
  return (performance.now() - start) / 1000;
}
