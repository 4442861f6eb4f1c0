/**
 * Opens recorded runs: repeats one a slice at a time, so that the worker hears other messages
 * meanwhile, and answers each request once, whatever happens.
 */
import { Replay, type Recording } from "@corridor/recording";
import type { LoadedRun, LoadRun } from "./worker-messages.ts";

/** So long a slice may take: a robot that drives meanwhile does not stumble. */
const SLICE_MS = 12;
/** How far it is, is told at most this often. */
const TELL_MS = 200;

export interface RunLoaderPorts {
  /** monotonic milliseconds */
  now: () => number;
  /** comes back after the messages that wait already */
  later: () => void;
  /** how much of the run is opened, from 0 to 1 */
  tellPart: (id: number, part: number) => void;
  answer: (id: number, loaded: LoadedRun) => void;
}

/** Shows the run from now on, or says why not. */
type Open = (recording: Recording) => LoadedRun;

interface Load {
  id: number;
  replay: Replay;
  open: Open;
  toldAt: number;
}

export class RunLoader {
  readonly #ports: RunLoaderPorts;
  #load: Load | null = null;

  constructor(ports: RunLoaderPorts) {
    this.#ports = ports;
  }

  /** Begins to open a run; one that is being opened is given up. */
  load({ id, run }: Pick<LoadRun, "id" | "run">, open: Open): void {
    this.cancel();
    this.#answering(id, () => {
      this.#load = { id, replay: new Replay(run), open, toldAt: this.#ports.now() };
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
    const { now, later, tellPart } = this.#ports;
    const { id, replay, open } = load;
    const until = now() + SLICE_MS;
    const end = replay.advance(() => now() < until);
    if (end !== null) {
      const loaded: LoadedRun = end.ok ? open(end.value) : { ...end, reason: "refused" };
      this.#answer(id, loaded);
      return;
    }
    if (now() - load.toldAt >= TELL_MS) {
      load.toldAt = now();
      tellPart(id, replay.tick / replay.ticks);
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
    this.#ports.answer(id, loaded);
  }
}
