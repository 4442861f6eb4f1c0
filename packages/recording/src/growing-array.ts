/**
 * A typed array that grows: numbers of a run of hours, packed, so that they cost bytes and not objects.
 */

/** The kinds of typed array that a recording needs. */
interface Kinds {
  int16: Int16Array<ArrayBuffer>;
  int32: Int32Array<ArrayBuffer>;
  float64: Float64Array<ArrayBuffer>;
}

const makers: { [K in keyof Kinds]: (length: number) => Kinds[K] } = {
  int16: (length) => new Int16Array(length),
  int32: (length) => new Int32Array(length),
  float64: (length) => new Float64Array(length),
};

const FIRST_LENGTH = 64;
/** A half more each time: few copies, and at most a third of it empty. */
const GROWTH = 1.5;

export class GrowingArray<K extends keyof Kinds> {
  readonly #kind: K;
  #values: Kinds[K];
  #length = 0;

  constructor(kind: K) {
    this.#kind = kind;
    this.#values = makers[kind](FIRST_LENGTH);
  }

  get length(): number {
    return this.#length;
  }

  /** Bytes held, the empty end included. */
  get byteLength(): number {
    return this.#values.byteLength;
  }

  /** The number at an index; NaN outside. */
  at(index: number): number {
    return index < this.#length ? (this.#values[index] ?? Number.NaN) : Number.NaN;
  }

  /** Changes the number at an index that is there. */
  set(index: number, value: number): void {
    if (index < this.#length) this.#values[index] = value;
  }

  push(value: number): void {
    if (this.#length === this.#values.length) this.#grow(this.#length + 1);
    this.#values[this.#length++] = value;
  }

  /** Keeps the first `length` numbers. */
  truncate(length: number): void {
    this.#length = Math.min(this.#length, length);
  }

  /** Forgets the first `count` numbers; those after them move to the front. */
  dropFirst(count: number): void {
    this.#values.copyWithin(0, count, this.#length);
    this.#length = Math.max(0, this.#length - count);
  }

  /** A copy of the numbers from an index on. */
  copyFrom(index: number): Kinds[K] {
    const copy = makers[this.#kind](Math.max(0, this.#length - index));
    copy.set(this.#values.subarray(index, this.#length));
    return copy;
  }

  /** Keeps the first `keep` numbers and appends others. */
  replaceFrom(keep: number, values: Kinds[K]): void {
    this.truncate(keep);
    const length = this.#length + values.length;
    if (length > this.#values.length) this.#grow(length);
    this.#values.set(values, this.#length);
    this.#length = length;
  }

  /** How many of the numbers, which rise or stay, are at most `value`: the index after the last of them. */
  countUpTo(value: number): number {
    let low = 0;
    let high = this.#length;
    while (low < high) {
      const middle = (low + high) >>> 1;
      if ((this.#values[middle] ?? 0) <= value) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  #grow(least: number): void {
    const values = makers[this.#kind](Math.max(least, Math.ceil(this.#values.length * GROWTH)));
    values.set(this.#values.subarray(0, this.#length));
    this.#values = values;
  }
}
