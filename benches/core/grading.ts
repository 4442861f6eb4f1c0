/**
 * Measures the overhead of `grade` over the ticks themselves: 10 programs in 100 mazes of 33 x 33,
 * two simulated minutes each; and 5 programs in 1,000 unseen mazes of a lesson. Includes the
 * process start, reading files, starting workers and printing.
 */
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { availableParallelism, tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { checkMazeOf, countMazes, type LessonTask } from "@corridor/challenge";
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
/**
 * The share of all ticks over which the single-core speed is measured, right before each grading.
 */
const SAMPLE_SHARE = 0.25;

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
    const product = new Product(tree(0), program);
    return {
      runs: costOf(product, PROGRAMS * MAZES * SECONDS * 60, () => {
        const limits = ["--seconds", `${SECONDS}`];
        grade([...limits, "--program", ...programFiles, "--maze", ...mazeFiles], PROGRAMS * MAZES);
      }),
      lesson: costOf(product, ticksOf(task, programs.slice(0, LESSON_PROGRAMS)), () => {
        const options = ["--challenge", lessonFile, "--unseen", `tree:11x11:${UNSEEN}:7`];
        const files = programFiles.slice(0, LESSON_PROGRAMS);
        grade([...options, "--program", ...files], LESSON_PROGRAMS);
      }),
    };
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** @param ticks number of ticks that the grading runs */
function costOf(product: Product, ticks: number, run: () => void): GradingCost {
  const sample = Math.round(ticks * SAMPLE_SHARE);
  product.run(sample);
  const cores = availableParallelism();
  const seconds: number[] = [];
  const timesIdeal: number[] = [];
  for (let round = 0; round < ROUNDS; round++) {
    const single = secondsOf(() => product.run(sample)) / SAMPLE_SHARE;
    const graded = secondsOf(run);
    seconds.push(graded);
    timesIdeal.push((graded * cores) / single);
  }
  return { seconds: median(seconds), timesIdeal: median(timesIdeal), cores };
}

/** Number of ticks of all checks of a task. */
function ticksOf(task: LessonTask, programs: readonly ProgramDocument[]): number {
  let ticks = 0;
  for (let maze = 0; maze < countMazes(task); maze++) {
    for (const program of programs) ticks += checkMazeOf(task, maze, program).ticks;
  }
  return ticks;
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
