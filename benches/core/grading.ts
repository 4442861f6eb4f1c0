/**
 * Measures the overhead of `grade` over the ticks themselves: 10 programs in 100 mazes of 33 x 33,
 * two simulated minutes each. Includes the process start, reading files, starting workers and
 * printing.
 */
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { availableParallelism, tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { generateTree, type MazeDocument } from "@corridor/maze";
import { programPresets, type ProgramDocument } from "@corridor/program";
import { Product } from "./product.ts";
import { median } from "./measure.ts";

const PROGRAMS = 10;
const MAZES = 100;
const SIDE = 33;
const SECONDS = 120;
const TICKS = PROGRAMS * MAZES * SECONDS * 60;
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

/** @throws Error if the command fails, or does not print one line per run and a summary */
export function measureGrading(program: ProgramDocument): GradingCost {
  const folder = mkdtempSync(join(tmpdir(), "corridor-bench-"));
  try {
    const mazes = Array.from({ length: MAZES }, (_, seed) => tree(seed));
    const programs = Array.from(
      { length: PROGRAMS },
      (_, at) => programPresets[at % programPresets.length]?.program,
    );
    const programFiles = programs.map((each, at) =>
      writeDocument(folder, `program-${at}.json`, each),
    );
    const mazeFiles = mazes.map((each, at) => writeDocument(folder, `maze-${at}.json`, each));
    const args = ["--program", ...programFiles, "--maze", ...mazeFiles];
    const product = new Product(tree(0), program);
    product.run(TICKS * SAMPLE_SHARE);
    const cores = availableParallelism();
    const seconds: number[] = [];
    const timesIdeal: number[] = [];
    for (let round = 0; round < ROUNDS; round++) {
      const single = secondsOf(() => product.run(TICKS * SAMPLE_SHARE)) / SAMPLE_SHARE;
      const graded = secondsOf(() => grade(args));
      seconds.push(graded);
      timesIdeal.push((graded * cores) / single);
    }
    return { seconds: median(seconds), timesIdeal: median(timesIdeal), cores };
  } finally {
    rmSync(folder, { recursive: true });
  }
}

function grade(args: readonly string[]): void {
  const output = execFileSync(
    process.execPath,
    [cli, "grade", "--seconds", `${SECONDS}`, ...args],
    { encoding: "utf8" },
  );
  const lines = output.trimEnd().split("\n").length;
  if (lines !== PROGRAMS * MAZES + 1) {
    throw new Error(`grade printed ${lines} lines, expected ${PROGRAMS * MAZES + 1}`);
  }
}

function tree(seed: number): MazeDocument {
  return generateTree({ columns: SIDE, rows: SIDE, seed, name: `Tree ${seed}` });
}

function writeDocument(folder: string, name: string, document: unknown): string {
  const file = join(folder, name);
  writeFileSync(file, JSON.stringify(document));
  return file;
}

function secondsOf(action: () => void): number {
  const start = performance.now();
  action();
  return (performance.now() - start) / 1000;
}
