/**
 * Opens recorded runs: replays one a slice at a time, so that the worker handles other messages
 * meanwhile, and answers each request exactly once.
 */
import { Replay, type Recording } from "@corridor/recording";
import type { LoadedRun, LoadRun } from "../protocol/worker-messages.ts";

/** Longest slice, so that a driving robot does not stutter. */
const SLICE_MS = 12;
/** Least time between two progress reports. */
const REPORT_MS = 200;

export interface RunLoaderPorts {
  /** monotonic milliseconds */
  now: () => number;
  /** calls back after the messages that are already queued */
  later: () => void;
  /** progress from 0 to 1 */
  onPart: (id: number, part: number) => void;
  answer: (id: number, loaded: LoadedRun) => void;
}

/** Displays the run from now on, or returns why not. */
export type OpenRecording = (recording: Recording) => LoadedRun;

interface Load {
  id: number;
  replay: Replay;
  open: OpenRecording;
  reportedAt: number;
}

export class RunLoader {
  readonly #ports: RunLoaderPorts;
  #load: Load | null = null;

  constructor(ports: RunLoaderPorts) {
    this.#ports = ports;
  }

  /** Starts to open a run, and cancels one that is being opened. */
  load({ id, run }: Pick<LoadRun, "id" | "run">, open: OpenRecording): void {
    this.cancel();
    this.#answering(id, () => {
      this.#load = { id, replay: new Replay(run), open, reportedAt: this.#ports.now() };
      this.#slice(this.#load);
    });
  }

  /**
   * Cancels the run that is being opened.
   * @param id only this request; without it, any
   */
  cancel(id?: number): void {
    const load = this.#load;
    if (load === null || (id !== undefined && id !== load.id)) return;
    this.#answer(load.id, { ok: false, reason: "cancelled" });
  }

  /** Runs the next slice, if there is one. */
  next(): void {
    const load = this.#load;
    if (load !== null) this.#answering(load.id, () => this.#slice(load));
  }

  #slice(load: Load): void {
    const { now, later, onPart } = this.#ports;
    const { id, replay, open } = load;
    const until = now() + SLICE_MS;
    const end = replay.advance(() => now() < until);
    if (end !== null) {
      const loaded: LoadedRun = end.ok ? open(end.value) : { ...end, reason: "refused" };
      this.#answer(id, loaded);
      return;
    }
    if (now() - load.reportedAt >= REPORT_MS) {
      load.reportedAt = now();
      onPart(id, replay.tick / replay.ticks);
    }
    later();
  }

  /** Answers the request even if the task throws. */
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
