/**
 * The newest positions of a run, each with the tick at whose end it was recorded, in packed arrays:
 * the corners of the trail, or the bumps. Indices count from the start of the run, including
 * evicted positions.
 */
import { GrowingArray } from "./growing-array.ts";

/**
 * Maximum number of positions: an hour of driving in circles. Above it, the older half is evicted.
 */
const MAX_POSITIONS = 262_144;

export class PositionLog {
  readonly #ticks = new GrowingArray("int32");
  readonly #xs = new GrowingArray("float64");
  readonly #ys = new GrowingArray("float64");
  /** number of evicted positions */
  #evicted = 0;

  /** Allocated bytes. */
  get byteLength(): number {
    return this.#ticks.byteLength + this.#xs.byteLength + this.#ys.byteLength;
  }

  push(tick: number, x: number, y: number): void {
    this.#ticks.push(tick);
    this.#xs.push(x);
    this.#ys.push(y);
    if (this.#ticks.length <= MAX_POSITIONS) return;
    for (const values of [this.#ticks, this.#xs, this.#ys]) values.dropFirst(MAX_POSITIONS / 2);
    this.#evicted += MAX_POSITIONS / 2;
  }

  /** Number of positions up to the end of `tick`, including all evicted ones. */
  countUpTo(tick: number): number {
    return this.#evicted + this.#ticks.countUpTo(tick);
  }

  /** Returns the positions from one index to another, without evicted ones: x and y alternating. */
  slice(from: number, to: number): number[] {
    const coordinates: number[] = [];
    const end = to - this.#evicted;
    for (let at = Math.max(0, from - this.#evicted); at < end; at++) {
      coordinates.push(this.#xs.at(at), this.#ys.at(at));
    }
    return coordinates;
  }

  /** Deletes the positions after the end of `tick`. */
  truncateAfter(tick: number): void {
    const length = this.#ticks.countUpTo(tick);
    for (const values of [this.#ticks, this.#xs, this.#ys]) values.truncate(length);
  }
}
