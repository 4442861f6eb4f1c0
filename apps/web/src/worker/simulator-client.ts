/**
 * The main thread's end of the simulator worker: commands in, events out.
 * The newest frame is kept for the canvas, which reads it on its own animation frames.
 */
import type { Frame, FromWorker, ToWorker } from "./worker-messages.ts";

/** As much of a Worker as is needed here. */
export interface WorkerPort {
  postMessage(message: ToWorker): void;
  onmessage: ((event: MessageEvent<FromWorker>) => void) | null;
}

/** A hidden page draws nothing, perhaps for hours: of what it missed, so many newest corners are kept. */
const MAX_CORNERS = 20_000;
const MAX_BUMPS = 100;

export class SimulatorClient {
  readonly #port: WorkerPort;
  readonly #listeners = new Set<(message: FromWorker) => void>();
  #corners: number[] = [];
  #bumps: number[] = [];
  #trailReset = false;
  #frame: Frame | null = null;

  constructor(port: WorkerPort) {
    this.#port = port;
    port.onmessage = ({ data }) => {
      if (data.type === "frame") this.#keep(data.frame);
      for (const listener of this.#listeners) listener(data);
    };
  }

  send(message: ToWorker): void {
    this.#port.postMessage(message);
  }

  /** Hears every message of the worker. @returns a function that ends it */
  listen(listener: (message: FromWorker) => void): () => void {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  /**
   * The newest frame, with all that the trail gained since the last call; null before the first
   * frame. For the one renderer: each call takes the corners away.
   */
  takeFrame(): Frame | null {
    if (this.#frame === null) return null;
    const frame: Frame = {
      ...this.#frame,
      corners: this.#corners,
      bumps: this.#bumps,
      trailReset: this.#trailReset,
    };
    this.#corners = [];
    this.#bumps = [];
    this.#trailReset = false;
    return frame;
  }

  #keep(frame: Frame): void {
    if (frame.trailReset) {
      this.#corners = [];
      this.#bumps = [];
      this.#trailReset = true;
    }
    for (const value of frame.corners) this.#corners.push(value);
    this.#bumps = [...this.#bumps, ...frame.bumps].slice(-2 * MAX_BUMPS);
    const tooMany = this.#corners.length - 2 * MAX_CORNERS;
    if (tooMany > 0) {
      this.#corners.splice(0, tooMany);
      // A line across what is missing would be a way that the robot never drove.
      this.#trailReset = true;
    }
    this.#frame = frame;
  }
}
