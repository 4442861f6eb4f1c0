/**
 * `grade`: every program over every maze, on all cores. Results come in the order of the files,
 * whichever core finished first.
 */
import { availableParallelism } from "node:os";
import { Worker } from "node:worker_threads";
import { gradeArguments, type GradeArguments } from "./arguments.ts";
import type { GradedPair, GradeJob, GradeShare } from "./grade-share.ts";
import type { GradedRun } from "./report.ts";

/** Below this many simulated seconds, starting workers costs more than they save. */
const WORTH_WORKERS_SECONDS = 20_000;

/** @returns the lines to print; throws InputError for bad input */
export async function grade(words: readonly string[]): Promise<string[]> {
  const request = gradeArguments(words);
  const { programs: programFiles, mazes: mazeFiles, limits, csv, why } = request;
  // They load their modules while this thread loads its own, hence the late imports.
  const workers = startWorkers(request);
  try {
    const { readFiles } = await import("./read-files.ts");
    const { csvTable, jsonLine, summaryLine } = await import("./report.ts");
    const documents = readFiles({ mazes: mazeFiles, programs: programFiles });
    const graded = await gradeOnAll(workers, { ...documents, limits, why });
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

/** One worker for each core but this thread's own; none where the work is small. */
function startWorkers({ programs, mazes, limits }: GradeArguments): Worker[] {
  const pairs = programs.length * mazes.length;
  if (pairs * limits.seconds < WORTH_WORKERS_SECONDS) return [];
  const count = Math.min(availableParallelism(), pairs) - 1;
  const entry = new URL("./grade-worker.ts", import.meta.url);
  return Array.from({ length: count }, () => new Worker(entry));
}

/** Grades on the workers and on this thread. @returns the results in the order of the pairs */
async function gradeOnAll(workers: readonly Worker[], job: GradeJob): Promise<GradedPair[]> {
  const { gradeShare } = await import("./grade-share.ts");
  const share: GradeShare = { job, taken: new Int32Array(new SharedArrayBuffer(4)) };
  const answers = workers.map((worker) => {
    worker.postMessage(share);
    return new Promise<GradedPair[]>((resolve, reject) => {
      worker.once("message", resolve);
      worker.once("error", reject);
    });
  });
  const graded = [gradeShare(share), ...(await Promise.all(answers))].flat();
  return graded.toSorted((a, b) => a.pair - b.pair);
}
