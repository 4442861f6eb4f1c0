/**
 * Moments of a run that are kept whole, so that any other is a short way from one of them. Taken every
 * ten seconds; where a run of hours has too many, every second one is dropped and the gap doubles.
 */
import type { RunState } from "./run.ts";
import type { PenState } from "./trail-pen.ts";

/** A run as its tick ended, before any input that came there. */
export interface Keyframe {
  state: RunState;
  pen: PenState;
}

const INITIAL_GAP = 600;
const MAX_KEYFRAMES = 512;
/** Numbers and small objects of a keyframe beside its arrays, in bytes: measured, rounded up. */
const PLAIN_BYTES = 2560;

export class Keyframes {
  #frames: Keyframe[];
  #gap = INITIAL_GAP;
  #dueAt = INITIAL_GAP;

  /** @param first the run's beginning */
  constructor(first: Keyframe) {
    this.#frames = [first];
  }

  /** Tick at whose end the next keyframe is to be taken. */
  get dueAt(): number {
    return this.#dueAt;
  }

  /** Bytes held, roughly. */
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

  /** The last keyframe at or before a tick. */
  before(tick: number): Keyframe {
    return this.#frames[this.#count((frame) => tickOf(frame) <= tick) - 1] ?? this.#first();
  }

  /** The last keyframe whose own last decision is at or before a tick. */
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
    if (first === undefined) throw new Error("a run begins with a keyframe");
    return first;
  }

  #last(): Keyframe {
    return this.#frames.at(-1) ?? this.#first();
  }

  /** How many keyframes from the first one on satisfy what only they and none after them do. */
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
