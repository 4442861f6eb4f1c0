/**
 * What `grade` costs beside the ticks themselves: 10 programs over 100 mazes of 33 x 33, two simulated
 * minutes each, by the command line with all that it brings: start, files, workers, printing.
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
/** The single core is timed over this part of the ticks, right before each grading. */
const SAMPLE = 0.25;

const cli = fileURLToPath(new URL("../../apps/cli/src/main.ts", import.meta.url));

export interface GradingCost {
  /** seconds from start to end of the command, the median of the rounds */
  seconds: number;
  /** the same in units of all ticks at the single-core speed, divided by the cores */
  timesIdeal: number;
  cores: number;
}

/** @throws Error when the command fails, or prints something else than a line a run and a summary */
export function measureGrading(program: ProgramDocument): GradingCost {
  const folder = mkdtempSync(join(tmpdir(), "corridor-bench-"));
  try {
    const mazes = Array.from({ length: MAZES }, (_, seed) => tree(seed));
    const programs = Array.from(
      { length: PROGRAMS },
      (_, at) => programPresets[at % programPresets.length]?.program,
    );
    const programFiles = programs.map((each, at) => save(folder, `program-${at}.json`, each));
    const mazeFiles = mazes.map((each, at) => save(folder, `maze-${at}.json`, each));
    const words = ["--program", ...programFiles, "--maze", ...mazeFiles];
    const product = new Product(tree(0), program);
    product.run(TICKS * SAMPLE);
    const cores = availableParallelism();
    const seconds: number[] = [];
    const timesIdeal: number[] = [];
    for (let round = 0; round < ROUNDS; round++) {
      const single = secondsOf(() => product.run(TICKS * SAMPLE)) / SAMPLE;
      const graded = secondsOf(() => grade(words));
      seconds.push(graded);
      timesIdeal.push((graded * cores) / single);
    }
    return { seconds: median(seconds), timesIdeal: median(timesIdeal), cores };
  } finally {
    rmSync(folder, { recursive: true });
  }
}

function grade(words: readonly string[]): void {
  const printed = execFileSync(
    process.execPath,
    [cli, "grade", "--seconds", `${SECONDS}`, ...words],
    { encoding: "utf8" },
  );
  const lines = printed.trimEnd().split("\n").length;
  if (lines !== PROGRAMS * MAZES + 1) {
    throw new Error(`grade: found ${lines} lines, expected one for each run and a summary`);
  }
}

function tree(seed: number): MazeDocument {
  return generateTree({ columns: SIDE, rows: SIDE, seed, name: `Tree ${seed}` });
}

function save(folder: string, name: string, document: unknown): string {
  const file = join(folder, name);
  writeFileSync(file, JSON.stringify(document));
  return file;
}

function secondsOf(work: () => void): number {
  const start = performance.now();
  work();
  return (performance.now() - start) / 1000;
}
