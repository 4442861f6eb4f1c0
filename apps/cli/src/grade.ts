/**
 * `grade`: runs every program in every maze, on all cores. Prints results in the order of the
 * files.
 */
import { availableParallelism } from "node:os";
import { Worker } from "node:worker_threads";
import { gradeArguments, type GradeArguments } from "./arguments.ts";
import { exitCodes, type Command } from "./command.ts";
import type { GradedPair, GradeJob, GradeShare } from "./grade-share.ts";
import type { GradedRun } from "./report.ts";

/** Below this total of simulated seconds, starting workers takes longer than they save. */
const MIN_SECONDS_FOR_WORKERS = 20_000;

const help = `Usage:
  corridor grade --program FILE... --maze FILE... [--seconds N] [--until time|goal|bump]
                 [--csv | --why]

Runs every program in every maze, on all cores. Prints one line of JSON for each pair, in the order
of the files, and a summary.

Options:
  --program FILE...  programs, such as submissions/*.json
  --maze FILE...     mazes, such as mazes/*.json
  --seconds N        maximum simulated time of a run, from 1/60 (one tick) to 86400; default: 300
  --until time       run for all seconds (default)
  --until goal       stop when the robot reaches a goal
  --until bump       stop at the first bump
  --csv              print a CSV table without a summary
  --why              add a diagnosis: what happened, the line that caused the failure, and changes
                     that fix it; null if the run did not fail
  --help             print this text

corridor simulate --help describes the fields of a result.

${exitCodes("success, even if the robot bumps or misses the goal", null)}`;

export const command: Command = {
  help,
  run: async (args, { print, entry }) => {
    print(await grade(args, entry));
    return 0;
  },
};

/** @returns the lines to print @throws InputError if the arguments or files are invalid */
async function grade(args: readonly string[], entry: URL): Promise<string[]> {
  const parsed = gradeArguments(args);
  const { programs: programFiles, mazes: mazeFiles, limits, csv, why } = parsed;
  // Dynamic imports follow, so that the workers load their modules concurrently with this thread.
  const workers = startWorkers(parsed, entry);
  try {
    const { readFiles } = await import("./read-files.ts");
    const { csvTable, jsonLine, summaryLine } = await import("./report.ts");
    const documents = readFiles({ mazes: mazeFiles, programs: programFiles });
    const graded = await gradeOnAllCores(workers, { ...documents, limits, why });
    const runs = graded.map(({ pair, result, diagnosis }): GradedRun => ({
      program: programFiles[Math.floor(pair / mazeFiles.length)] ?? "",
      maze: mazeFiles[pair % mazeFiles.length] ?? "",
      result,
      diagnosis,
    }));
    if (csv) return csvTable(runs);
    const lines = runs.map(({ program, maze, result, diagnosis }) =>
      jsonLine(result, { program, maze }, why ? { diagnosis } : {}),
    );
    return [...lines, summaryLine(runs)];
  } finally {
    await Promise.all(workers.map((worker) => worker.terminate()));
  }
}

/** Starts one worker for each core except this thread's; none if the job is small. */
function startWorkers({ programs, mazes, limits }: GradeArguments, entry: URL): Worker[] {
  const pairs = programs.length * mazes.length;
  if (pairs * limits.seconds < MIN_SECONDS_FOR_WORKERS) return [];
  const count = Math.min(availableParallelism(), pairs) - 1;
  return Array.from({ length: count }, () => new Worker(entry));
}

/** Grades on the workers and on this thread. @returns the results in the order of the pairs */
async function gradeOnAllCores(workers: readonly Worker[], job: GradeJob): Promise<GradedPair[]> {
  const { gradeShare } = await import("./grade-share.ts");
  const share: GradeShare = { job, nextPair: new Int32Array(new SharedArrayBuffer(4)) };
  const results = workers.map((worker) => {
    worker.postMessage(share);
    return new Promise<GradedPair[]>((resolve, reject) => {
      worker.once("message", resolve);
      worker.once("error", reject);
    });
  });
  const graded = [gradeShare(share), ...(await Promise.all(results))].flat();
  return graded.toSorted((a, b) => a.pair - b.pair);
}
