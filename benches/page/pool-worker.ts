/**
 * The baseline of checks and of other mazes: what the cores can do at most. Not one worker divided by
 * the cores: two processors of a virtual machine often share a core, and its speed.
 */
import type { ProgramDocument } from "@corridor/program";

declare global {
  /** URL of the script of the pool's workers; set when the page has started one */
  var poolWorkerUrl: string | undefined;
}

/** Runs in the page before its own scripts. */
export function capturePoolWorkerUrl(): void {
  const PlainWorker = globalThis.Worker;
  globalThis.Worker = class extends PlainWorker {
    constructor(address: string | URL, options?: WorkerOptions) {
      super(address, options);
      if (String(address).includes("pool.worker")) globalThis.poolWorkerUrl = String(address);
    }
  };
}

/**
 * Runs in the page. Shares all mazes among workers of its pool that are warmed up, one for each core.
 * @returns milliseconds
 */
export async function runOnCores(job: {
  program: ProgramDocument;
  side: number;
  mazes: number;
  /** seed of the first maze */
  first: number;
}): Promise<number> {
  /** Mazes that a worker receives at a time. So all workers finish at about the same time. */
  const SHARE = 5;
  const { poolWorkerUrl } = globalThis;
  if (poolWorkerUrl === undefined) throw new Error("the page has not started a worker");
  const workers = Array.from(
    { length: navigator.hardwareConcurrency },
    () => new Worker(poolWorkerUrl, { type: "module" }),
  );
  const mazes = { kind: "tree", side: job.side };
  const trial = { kind: "trial", program: job.program, mazes, first: job.first };
  const run = async (): Promise<number> => {
    const start = performance.now();
    let next = 0;
    let results = 0;
    await new Promise<void>((resolve) => {
      for (const worker of workers) {
        let left = 0;
        const give = (): void => {
          const from = next;
          next = Math.min(job.mazes, from + SHARE);
          left += next - from;
          if (next > from) worker.postMessage({ type: "units", from, to: next });
        };
        worker.onmessage = ({ data }: MessageEvent<{ results: unknown[] }>) => {
          left -= data.results.length;
          results += data.results.length;
          if (left <= SHARE) give();
          if (results === job.mazes) resolve();
        };
        worker.postMessage({ type: "begin", id: 0, job: trial });
        give();
        give();
      }
    });
    return performance.now() - start;
  };
  await run();
  const elapsed = await run();
  for (const worker of workers) worker.terminate();
  return elapsed;
}
