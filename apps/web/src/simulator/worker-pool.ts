/**
 * Workers that share the units of a job, one worker for each core. Shares are large at first and
 * small at the end. So a worker seldom waits for the page, which draws meanwhile, and all workers
 * finish at about the same time.
 */
import type { PoolJob, PoolPort, PoolResult } from "./protocol/pool-messages.ts";

export interface PoolListener {
  onResult: (result: PoolResult, unit: number) => void;
  /**
   * The job has no more results, although some units have none.
   * @param reason failed: a worker did not load or failed
   */
  onEnd: (reason: "stopped" | "failed") => void;
}

/** Smallest number of units that a worker receives at a time, except at the end of the job. */
const LEAST_SHARE = 2;

/** A worker, and the number of units that it still has to run. */
interface PooledWorker {
  port: PoolPort;
  waiting: number;
}

interface RunningJob {
  listener: PoolListener;
  count: number;
  /** number of units without a result */
  left: number;
  /** next unit that no worker has */
  next: number;
  isStopped: boolean;
}

export class WorkerPool {
  readonly #start: () => PoolPort;
  readonly #size: number;
  #workers: PooledWorker[] = [];
  /** increases with each job; results of an earlier job are ignored */
  #id = 0;
  #running: RunningJob | null = null;

  constructor(start: () => PoolPort, size: number) {
    this.#start = start;
    this.#size = size;
  }

  /**
   * Starts the workers, so that they are ready for a job.
   * @param count number of units of the job; it needs no more workers
   */
  open(count = this.#size): void {
    while (this.#workers.length < Math.min(count, this.#size)) {
      this.#workers.push(this.#startWorker());
    }
  }

  /**
   * Runs a job in place of the current one.
   * @param count number of units
   */
  run(job: PoolJob, count: number, listener: PoolListener): void {
    this.stop();
    if (count === 0) return;
    this.open(count);
    this.#running = { listener, count, left: count, next: 0, isStopped: false };
    for (const worker of this.#workers) {
      worker.waiting = 0;
      worker.port.postMessage({ type: "begin", id: this.#id, job });
      this.#give(worker);
    }
  }

  /** Ends the job. A worker finishes the unit that it has started, and the result is ignored. */
  stop(): void {
    const running = this.#running;
    if (running === null) return;
    for (const { port } of this.#workers) port.postMessage({ type: "stop" });
    running.isStopped = true;
    this.#end();
    running.listener.onEnd("stopped");
  }

  /** Terminates the workers; the next job starts new ones. */
  close(): void {
    this.stop();
    for (const { port } of this.#workers) port.terminate();
    this.#workers = [];
  }

  #end(): void {
    this.#id++;
    this.#running = null;
  }

  #startWorker(): PooledWorker {
    const port = this.#start();
    const worker = { port, waiting: 0 };
    port.onmessage = ({ data: { id, results } }) => {
      const running = this.#running;
      if (running === null || id !== this.#id) return;
      worker.waiting -= results.length;
      running.left -= results.length;
      this.#give(worker);
      if (running.left === 0) this.#end();
      for (const { unit, result } of results) {
        if (!running.isStopped) running.listener.onResult(result, unit);
      }
    };
    port.onerror = () => {
      const running = this.#running;
      this.#end();
      this.close();
      running?.listener.onEnd("failed");
    };
    return worker;
  }

  /**
   * Gives a worker its next share: half of the remaining units, divided by the number of workers. A
   * worker that still has more than half of a share receives none.
   */
  #give(worker: PooledWorker): void {
    const running = this.#running;
    if (running === null) return;
    const { count, next } = running;
    const share = Math.max(LEAST_SHARE, Math.ceil((count - next) / (2 * this.#workers.length)));
    if (next === count || worker.waiting > share / 2) return;
    const to = Math.min(count, next + share);
    running.next = to;
    worker.waiting += to - next;
    worker.port.postMessage({ type: "units", from: next, to });
  }
}

/** More workers than this cost more memory than they save time. */
const MOST_WORKERS = 16;

/** Creates a pool of the page: one worker for each core, and at most `MOST_WORKERS`. */
export function createWorkerPool(): WorkerPool {
  const cores = Math.max(1, Math.min(MOST_WORKERS, navigator.hardwareConcurrency || 1));
  return new WorkerPool(
    () => new Worker(new URL("./pool-worker/pool.worker.ts", import.meta.url), { type: "module" }),
    cores,
  );
}
