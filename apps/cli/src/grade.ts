/**
 * `grade`: every program over every maze, on all cores. Results come in the order of the files,
 * whichever core finished first.
 */
import { availableParallelism } from "node:os";
import { Worker } from "node:worker_threads";
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import { gradeArguments } from "./arguments.ts";
import { readFiles } from "./read-files.ts";
import { csvTable, jsonLine, summaryLine, type GradedRun } from "./report.ts";
import { runProgram, type RunLimits, type RunResult } from "./run-result.ts";

/** What every worker is given once. */
export interface GradeJob {
  mazes: MazeDocument[];
  programs: ProgramDocument[];
  limits: RunLimits;
}

/** Below this many simulated seconds, starting workers costs more than they save. */
const WORTH_WORKERS_SECONDS = 20_000;
/** Batches a worker: small enough that no core waits long for the last one. */
const BATCHES_PER_WORKER = 16;

/** @returns the lines to print; throws InputError for bad input */
export async function grade(words: readonly string[]): Promise<string[]> {
  const { mazes: mazeFiles, programs: programFiles, limits, csv } = gradeArguments(words);
  const { mazes, programs } = readFiles({ mazes: mazeFiles, programs: programFiles });
  const results = await gradeAll({ mazes, programs, limits });
  const runs = results.map((result, pair): GradedRun => ({
    program: programFiles[Math.floor(pair / mazes.length)] ?? "",
    maze: mazeFiles[pair % mazes.length] ?? "",
    result,
  }));
  if (csv) return csvTable(runs);
  const lines = runs.map(({ program, maze, result }) => jsonLine(result, { program, maze }));
  return [...lines, summaryLine(runs)];
}

/** Results by pair: program * mazes + maze. */
export async function gradeAll(job: GradeJob): Promise<RunResult[]> {
  const pairs = job.programs.length * job.mazes.length;
  const workers = Math.min(availableParallelism(), pairs);
  if (workers < 2 || pairs * job.limits.seconds < WORTH_WORKERS_SECONDS) {
    return Array.from({ length: pairs }, (_, pair) => gradePair(job, pair));
  }
  return gradeOnWorkers(job, pairs, workers);
}

/** One pair of a job. */
export function gradePair(job: GradeJob, pair: number): RunResult {
  const program = job.programs[Math.floor(pair / job.mazes.length)];
  const maze = job.mazes[pair % job.mazes.length];
  if (program === undefined || maze === undefined) throw new RangeError(`no pair ${pair}`);
  return runProgram(maze, program, job.limits);
}

async function gradeOnWorkers(job: GradeJob, pairs: number, workers: number): Promise<RunResult[]> {
  const results: RunResult[] = [];
  const batch = Math.max(1, Math.ceil(pairs / (workers * BATCHES_PER_WORKER)));
  let next = 0;
  const runWorker = (): Promise<void> =>
    new Promise((resolve, reject) => {
      const worker = new Worker(new URL("./grade-worker.ts", import.meta.url), {
        workerData: job,
      });
      const feed = (): void => {
        if (next >= pairs) {
          worker.postMessage(null);
          return;
        }
        worker.postMessage({ from: next, to: Math.min(pairs, next + batch) });
        next += batch;
      };
      worker.on("message", ({ from, batchResults }: WorkerAnswer) => {
        for (const [index, result] of batchResults.entries()) results[from + index] = result;
        feed();
      });
      worker.on("error", reject);
      worker.on("exit", () => resolve());
      feed();
    });
  await Promise.all(Array.from({ length: workers }, runWorker));
  return results;
}

/** What a worker sends back for a batch of pairs. */
export interface WorkerAnswer {
  from: number;
  batchResults: RunResult[];
}
