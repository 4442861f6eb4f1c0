/**
 * Opens recorded runs: repeats one a slice at a time, so that the worker hears other messages
 * meanwhile, and answers each request once, whatever happens.
 */
import { Replay, type Recording } from "@corridor/recording";
import type { FromWorker, LoadedRun, LoadRun } from "./worker-messages.ts";

/** So long a slice may take: a robot that drives meanwhile does not stumble. */
const SLICE_MS = 12;
/** How far it is, is told at most this often. */
const TELL_MS = 200;

export interface RunLoaderPorts {
  /** monotonic milliseconds */
  now: () => number;
  /** comes back after the messages that wait already */
  later: () => void;
  post: (message: Extract<FromWorker, { type: "run-loading" | "run-loaded" }>) => void;
  /** shows the run from now on */
  open: (recording: Recording) => Extract<LoadedRun, { ok: true }>;
}

interface Load {
  id: number;
  replay: Replay;
  toldAt: number;
}

export class RunLoader {
  readonly #ports: RunLoaderPorts;
  #load: Load | null = null;

  constructor(ports: RunLoaderPorts) {
    this.#ports = ports;
  }

  /** Begins to open a run; one that is being opened is given up. */
  load({ id, run, until }: LoadRun): void {
    this.cancel();
    this.#answering(id, () => {
      this.#load = { id, replay: new Replay(run, until), toldAt: this.#ports.now() };
      this.#slice(this.#load);
    });
  }

  /** Gives up what is being opened. @param id only this request; without it, any */
  cancel(id?: number): void {
    const load = this.#load;
    if (load === null || (id !== undefined && id !== load.id)) return;
    this.#answer(load.id, { ok: false, reason: "cancelled" });
  }

  /** Does the next slice, if there is one. */
  goOn(): void {
    const load = this.#load;
    if (load !== null) this.#answering(load.id, () => this.#slice(load));
  }

  #slice(load: Load): void {
    const { now, later, post, open } = this.#ports;
    const { id, replay } = load;
    const until = now() + SLICE_MS;
    const end = replay.goOn(() => now() < until);
    if (end !== null) {
      const loaded: LoadedRun = end.ok ? open(end.value) : { ...end, reason: "refused" };
      this.#answer(id, loaded);
      return;
    }
    if (now() - load.toldAt >= TELL_MS) {
      load.toldAt = now();
      post({ type: "run-loading", id, part: replay.tick / replay.ticks });
    }
    later();
  }

  /** Whoever asked hears of it as well where it goes wrong. */
  #answering(id: number, work: () => void): void {
    try {
      work();
    } catch (error) {
      this.#answer(id, { ok: false, reason: "fault" });
      throw error;
    }
  }

  #answer(id: number, loaded: LoadedRun): void {
    this.#load = null;
    this.#ports.post({ type: "run-loaded", id, loaded });
  }
}
