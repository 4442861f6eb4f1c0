/** The baseline of checks and of other mazes: one worker of the page's pool that runs alone. */
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

/** Runs in the page. Runs all mazes in one worker that is warmed up. @returns milliseconds */
export async function runAlone(job: {
  program: ProgramDocument;
  side: number;
  mazes: number;
  /** seed of the first maze */
  first: number;
}): Promise<number> {
  const { poolWorkerUrl } = globalThis;
  if (poolWorkerUrl === undefined) throw new Error("the page has not started a worker");
  const worker = new Worker(poolWorkerUrl, { type: "module" });
  const run = async (): Promise<number> => {
    const start = performance.now();
    const mazes = { kind: "tree", side: job.side };
    const trial = { kind: "trial", program: job.program, mazes, first: job.first };
    worker.postMessage({ type: "begin", id: 0, job: trial });
    worker.postMessage({ type: "units", from: 0, to: job.mazes });
    await new Promise<void>((resolve) => {
      let results = 0;
      worker.onmessage = ({ data }: MessageEvent<{ results: unknown[] }>) => {
        results += data.results.length;
        if (results === job.mazes) resolve();
      };
    });
    return performance.now() - start;
  };
  await run();
  const elapsed = await run();
  worker.terminate();
  return elapsed;
}
