/**
 * Workers that share a list of mazes, one worker for each core. Shares are large at first and small
 * at the end. So a worker seldom waits for the page, which draws meanwhile, and all workers finish
 * at about the same time.
 */
import type { ProgramDocument } from "@corridor/program";
import type { WrittenRun } from "@corridor/recording";
import type { TrialMazes, TrialResult } from "../../simulator/protocol/trial-messages.ts";
import type { FromTrialWorker, ToTrialWorker } from "../../simulator/protocol/trial-messages.ts";

/** The part of `Worker` that is used. */
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
  /** a worker did not load or failed: this job has no more results */
  onFailure: () => void;
}

/** Smallest number of mazes that a worker receives at a time, except at the end of the list. */
const LEAST_SHARE = 2;

/** A worker, and the number of mazes that it still has to try. */
interface Crew {
  port: TrialPort;
  waiting: number;
}

export class TrialPool {
  readonly #start: () => TrialPort;
  readonly #size: number;
  #crews: Crew[] = [];
  #recorders: ((written: WrittenRun | null) => void)[] = [];
  /** increases with each job; results of an earlier job are ignored */
  #id = 0;
  #job: TrialJob | null = null;
  #listener: TrialListener | null = null;
  #next = 0;

  constructor(start: () => TrialPort, size: number) {
    this.#start = start;
    this.#size = size;
  }

  /** Starts the workers, so that they are ready for a job. */
  open(): void {
    if (this.#crews.length > 0) return;
    this.#crews = Array.from({ length: this.#size }, () => this.#openCrew());
  }

  /** Runs a job in place of the current one. */
  run(job: TrialJob, listener: TrialListener): void {
    this.stop();
    this.open();
    this.#job = job;
    this.#listener = listener;
    this.#next = 0;
    for (const crew of this.#crews) {
      crew.waiting = 0;
      this.#give(crew);
    }
  }

  /** Ends the job. A worker finishes the maze that it has started, and the result is ignored. */
  stop(): void {
    if (this.#job !== null) for (const { port } of this.#crews) port.postMessage({ type: "stop" });
    this.#id++;
    this.#job = null;
    this.#listener = null;
  }

  /** Runs a program once more and returns the recorded run; null if no worker could record it. */
  async record(
    maze: TrialResult["maze"],
    program: ProgramDocument,
    ticks: number,
  ): Promise<WrittenRun | null> {
    this.stop();
    this.open();
    const [crew] = this.#crews;
    if (crew === undefined) return null;
    return new Promise((resolve) => {
      this.#recorders.push(resolve);
      crew.port.postMessage({ type: "record", maze, program, ticks });
    });
  }

  /** Terminates the workers; the next job starts new ones. */
  close(): void {
    this.stop();
    for (const { port } of this.#crews) port.terminate();
    this.#crews = [];
    for (const resolve of this.#recorders.splice(0)) resolve(null);
  }

  #openCrew(): Crew {
    const port = this.#start();
    const crew = { port, waiting: 0 };
    port.onmessage = ({ data }) => {
      if (data.type === "recorded") {
        this.#recorders.shift()?.(data.written);
        return;
      }
      if (data.job !== this.#id) return;
      crew.waiting--;
      this.#give(crew);
      this.#listener?.onResult(data.result);
    };
    port.onerror = () => {
      const listener = this.#listener;
      this.close();
      listener?.onFailure();
    };
    return crew;
  }

  /**
   * Gives a worker its next share: half of the remaining mazes, divided by the number of workers. A
   * worker that still has more than half of a share receives none.
   */
  #give(crew: Crew): void {
    if (this.#job === null) return;
    const { program, mazes, seeds } = this.#job;
    const left = seeds.length - this.#next;
    const share = Math.max(LEAST_SHARE, Math.ceil(left / (2 * this.#crews.length)));
    if (left === 0 || crew.waiting > share / 2) return;
    const given = seeds.slice(this.#next, this.#next + share);
    this.#next += given.length;
    crew.waiting += given.length;
    crew.port.postMessage({ type: "try", job: this.#id, program, mazes, seeds: given });
  }
}

/** More workers than this cost more memory than they save time. */
const MOST_WORKERS = 16;

/** Creates the pool of the page: one worker for each core, and at most `MOST_WORKERS`. */
export function createTrialPool(): TrialPool {
  const cores = Math.max(1, Math.min(MOST_WORKERS, navigator.hardwareConcurrency || 1));
  return new TrialPool(
    () =>
      new Worker(new URL("../../simulator/trial-worker/maze-trial.worker.ts", import.meta.url), {
        type: "module",
      }),
    cores,
  );
}
