/**
 * Complete states of a run at intervals, so that seeking to any tick recomputes few ticks. The
 * initial interval is ten seconds. Above the maximum number, every second keyframe is dropped and
 * the interval doubles.
 */
import type { RunState } from "./run.ts";
import type { PenState } from "./trail-pen.ts";

/** State of a run at the end of a tick, before the inputs at that tick. */
export interface Keyframe {
  state: RunState;
  pen: PenState;
}

/** Initial interval between keyframes, in ticks. */
const INITIAL_GAP = 600;
const MAX_KEYFRAMES = 512;
/** Size of a keyframe without its arrays, in bytes: measured, rounded up. */
const PLAIN_BYTES = 2560;

export class Keyframes {
  #frames: Keyframe[];
  #gap = INITIAL_GAP;
  #dueAt = INITIAL_GAP;

  /** @param first the keyframe at the start of the run */
  constructor(first: Keyframe) {
    this.#frames = [first];
  }

  /** Tick at whose end the next keyframe is due. */
  get dueAt(): number {
    return this.#dueAt;
  }

  /** Approximate memory use in bytes. */
  get byteLength(): number {
    let bytes = 0;
    for (const { state } of this.#frames) {
      const { physics } = state.simulation;
      bytes += physics.corners.byteLength + state.decisions.decisions.byteLength + PLAIN_BYTES;
    }
    return bytes;
  }

  add(frame: Keyframe): void {
    this.#frames.push(frame);
    if (this.#frames.length > MAX_KEYFRAMES) {
      this.#frames = this.#frames.filter((_, index) => index % 2 === 0);
      this.#gap *= 2;
    }
    this.#dueAt = tickOf(this.#last()) + this.#gap;
  }

  /** Returns the last keyframe at or before a tick. */
  before(tick: number): Keyframe {
    return this.#frames[this.#count((frame) => tickOf(frame) <= tick) - 1] ?? this.#first();
  }

  /** Returns the last keyframe whose last decision is at or before a tick. */
  decidedBefore(tick: number): Keyframe {
    const count = this.#count(({ state }) => state.approach.decidedAt <= tick);
    return this.#frames[count - 1] ?? this.#first();
  }

  truncateAfter(tick: number): void {
    this.#frames.length = Math.max(
      1,
      this.#count((frame) => tickOf(frame) <= tick),
    );
    this.#dueAt = tickOf(this.#last()) + this.#gap;
  }

  #first(): Keyframe {
    const [first] = this.#frames;
    if (first === undefined) throw new Error("the run has no first keyframe");
    return first;
  }

  #last(): Keyframe {
    return this.#frames.at(-1) ?? this.#first();
  }

  /** Binary search: the number of leading keyframes that satisfy a monotonic predicate. */
  #count(isBefore: (frame: Keyframe) => boolean): number {
    let low = 0;
    let high = this.#frames.length;
    while (low < high) {
      const middle = (low + high) >>> 1;
      const frame = this.#frames[middle];
      if (frame !== undefined && isBefore(frame)) low = middle + 1;
      else high = middle;
    }
    return low;
  }
}

function tickOf({ state }: Keyframe): number {
  return state.simulation.tick;
}
