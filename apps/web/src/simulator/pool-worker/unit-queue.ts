/**
 * Runs the queued units of a job in short slices. Between two slices the worker receives messages,
 * so a stop takes effect at once. All results of a slice are one message, so that the page is not
 * flooded.
 */
import type {
  FromPoolWorker,
  PoolJob,
  PoolResult,
  ToPoolWorker,
  UnitRange,
} from "../protocol/pool-messages.ts";

/**
 * Minimum length of a slice in ms. The unit that runs at its end is completed. Slices of 10 ms took
 * the page a third more time, on a core that the workers use.
 */
const SLICE_MS = 25;

interface UnitPorts {
  run: (job: PoolJob, unit: number) => PoolResult;
  post: (message: FromPoolWorker) => void;
  /** time in ms */
  now: () => number;
}

export class UnitQueue {
  readonly #ports: UnitPorts;
  #current: { id: number; job: PoolJob } | null = null;
  #ranges: UnitRange[] = [];

  constructor(ports: UnitPorts) {
    this.#ports = ports;
  }

  /** Number of queued units. */
  get size(): number {
    return this.#ranges.reduce((sum, { from, to }) => sum + to - from, 0);
  }

  receive(message: ToPoolWorker): void {
    switch (message.type) {
      case "begin":
        this.#current = { id: message.id, job: message.job };
        this.#ranges = [];
        break;
      case "units":
        this.#ranges.push({ from: message.from, to: message.to });
        break;
      case "stop":
        this.#ranges = [];
        break;
    }
  }

  /** Runs at least one queued unit, until the slice is over, and posts the results. */
  runSlice(): void {
    const { run, post, now } = this.#ports;
    if (this.#current === null) return;
    const { id, job } = this.#current;
    const results: { unit: number; result: PoolResult }[] = [];
    const end = now() + SLICE_MS;
    do {
      const unit = this.#shift();
      if (unit === null) break;
      results.push({ unit, result: run(job, unit) });
    } while (now() < end);
    if (results.length > 0) post({ id, results });
  }

  /** Removes the first queued unit; null if there is none. */
  #shift(): number | null {
    const [range] = this.#ranges;
    if (range === undefined) return null;
    const unit = range.from++;
    if (range.from === range.to) this.#ranges.shift();
    return unit;
  }
}
