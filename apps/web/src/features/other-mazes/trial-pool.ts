/**
 * Workers that share a list of mazes, one for each core. A worker gets its next maze while it is still
 * busy with the one before, so that it never waits for the page.
 */
import type { ProgramDocument } from "@corridor/program";
import type { WrittenRun } from "@corridor/recording";
import type { TrialMazes, TrialResult } from "../../worker/maze-trial.ts";
import type { FromTrialWorker, ToTrialWorker } from "../../worker/trial-messages.ts";

/** As much of a Worker as is needed here. */
export interface TrialPort {
  postMessage: (message: ToTrialWorker) => void;
  onmessage: ((event: MessageEvent<FromTrialWorker>) => void) | null;
  onerror: ((event: ErrorEvent) => void) | null;
  terminate: () => void;
}

export interface TrialJob {
  program: ProgramDocument;
  mazes: TrialMazes;
  seeds: readonly number[];
}

export interface TrialListener {
  onResult: (result: TrialResult) => void;
  /** a worker did not load or broke: nothing more comes of this job */
  onFailure: () => void;
}

/** Mazes that a worker has at a time. */
const AHEAD = 2;

export class TrialPool {
  readonly #start: () => TrialPort;
  readonly #size: number;
  #ports: TrialPort[] = [];
  #recorders: ((written: WrittenRun | null) => void)[] = [];
  /** rises with each job: results of another one are late, and ignored */
  #id = 0;
  #job: TrialJob | null = null;
  #listener: TrialListener | null = null;
  #next = 0;

  constructor(start: () => TrialPort, size: number) {
    this.#start = start;
    this.#size = size;
  }

  /** Starts the workers, so that a job finds them ready. */
  open(): void {
    if (this.#ports.length > 0) return;
    this.#ports = Array.from({ length: this.#size }, () => this.#openPort());
  }

  /** Runs a job in place of the one that runs. */
  run(job: TrialJob, listener: TrialListener): void {
    this.open();
    this.#id++;
    this.#job = job;
    this.#listener = listener;
    this.#next = 0;
    for (let ahead = 0; ahead < AHEAD; ahead++) {
      for (const port of this.#ports) this.#give(port);
    }
  }

  /** Ends the job. What a worker has begun is finished and ignored. */
  stop(): void {
    this.#id++;
    this.#job = null;
    this.#listener = null;
  }

  /** Runs a program once more and gives the run; null where no worker could. */
  async record(
    maze: TrialResult["maze"],
    program: ProgramDocument,
    ticks: number,
  ): Promise<WrittenRun | null> {
    this.stop();
    this.open();
    const [port] = this.#ports;
    if (port === undefined) return null;
    return new Promise((resolve) => {
      this.#recorders.push(resolve);
      port.postMessage({ type: "record", maze, program, ticks });
    });
  }

  /** Ends the workers; the next job starts new ones. */
  close(): void {
    this.stop();
    for (const port of this.#ports) port.terminate();
    this.#ports = [];
    for (const resolve of this.#recorders.splice(0)) resolve(null);
  }

  #openPort(): TrialPort {
    const port = this.#start();
    port.onmessage = ({ data }) => {
      if (data.type === "recorded") {
        this.#recorders.shift()?.(data.written);
        return;
      }
      if (data.job !== this.#id) return;
      this.#give(port);
      this.#listener?.onResult(data.result);
    };
    port.onerror = () => {
      const listener = this.#listener;
      this.close();
      listener?.onFailure();
    };
    return port;
  }

  #give(port: TrialPort): void {
    const job = this.#job;
    const seed = job?.seeds[this.#next];
    if (job === null || seed === undefined) return;
    this.#next++;
    const { program, mazes } = job;
    port.postMessage({ type: "try", job: this.#id, program, mazes, seed });
  }
}

/** More workers than this cost more memory than they save time. */
const MOST_WORKERS = 16;

/** The pool of the page: a worker for each core. */
export function createTrialPool(): TrialPool {
  const cores = Math.max(1, Math.min(MOST_WORKERS, navigator.hardwareConcurrency || 1));
  return new TrialPool(
    () =>
      new Worker(new URL("../../worker/maze-trial.worker.ts", import.meta.url), {
        type: "module",
      }),
    cores,
  );
}
