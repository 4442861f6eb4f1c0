/** Runs a job on the worker threads of `grade` and on this thread. */
import { availableParallelism } from "node:os";
import { Worker } from "node:worker_threads";
import { runShare, type FinishedUnit, type Units, type WorkShare } from "./work-share.ts";

/** What the units of a job are: a program in a maze file, or a program in a maze of a task. */
export type JobKind = "runs" | "checks";

/** Below this total of simulated seconds, starting workers takes longer than they save. */
const MIN_SECONDS_FOR_WORKERS = 20_000;

/**
 * Starts one worker for each core except this thread's; none if the job is small.
 * @param size of the job: its number of units, and the maximum of simulated seconds of all of them
 * @param entry see `Context`
 */
export function startWorkers(
  kind: JobKind,
  { units, seconds }: { units: number; seconds: number },
  entry: URL,
): Worker[] {
  if (seconds < MIN_SECONDS_FOR_WORKERS) return [];
  const count = Math.min(availableParallelism(), units) - 1;
  return Array.from({ length: count }, () => new Worker(entry, { workerData: kind }));
}

export async function terminate(workers: readonly Worker[]): Promise<void> {
  await Promise.all(workers.map((worker) => worker.terminate()));
}

/**
 * Runs all units of a job.
 * @param workers of the job's kind
 * @param unitsOf returns the units of the job; the workers use the same function
 * @returns the results in the order of the units
 */
export async function runOnAllCores<Job, Result>(
  workers: readonly Worker[],
  job: Job,
  unitsOf: (job: Job) => Units<Result>,
): Promise<Result[]> {
  const share: WorkShare<Job> = { job, claimed: new Int32Array(new SharedArrayBuffer(4)) };
  const others = workers.map((worker) => {
    worker.postMessage(share);
    return new Promise<FinishedUnit<Result>[]>((resolve, reject) => {
      worker.once("message", resolve);
      worker.once("error", reject);
    });
  });
  const finished = [runShare(unitsOf(job), share.claimed), ...(await Promise.all(others))].flat();
  return finished.toSorted((a, b) => a.unit - b.unit).map(({ result }) => result);
}
