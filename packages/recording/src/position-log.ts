/**
 * Places with the tick at whose end each was noted, packed, the newest of them: the corners of a trail,
 * or the bumps. Places are counted over the whole run, also those that are forgotten again.
 */
import { GrowingArray } from "./growing-array.ts";

/** An hour of a robot that drives in circles; after that the older half is forgotten. */
const MAX_POSITIONS = 262_144;

export class PositionLog {
  readonly #ticks = new GrowingArray("int32");
  readonly #xs = new GrowingArray("float64");
  readonly #ys = new GrowingArray("float64");
  /** how many were forgotten at the front */
  #evicted = 0;

  /** Bytes held. */
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

  /** How many places were noted up to the end of `tick`; as far as is known, the first of the forgotten too. */
  countUpTo(tick: number): number {
    return this.#evicted + this.#ticks.countUpTo(tick);
  }

  /** Places from one count to another, those that are not forgotten: x and y by turns. */
  slice(from: number, to: number): number[] {
    const places: number[] = [];
    const end = to - this.#evicted;
    for (let at = Math.max(0, from - this.#evicted); at < end; at++) {
      places.push(this.#xs.at(at), this.#ys.at(at));
    }
    return places;
  }

  /** Forgets what was noted after the end of `tick`. */
  truncateAfter(tick: number): void {
    const length = this.#ticks.countUpTo(tick);
    for (const values of [this.#ticks, this.#xs, this.#ys]) values.truncate(length);
  }
}
