/** A typed array that grows, for the packed numbers of long runs. */

/** The kinds of typed arrays that a recording uses. */
interface Kinds {
  int16: Int16Array<ArrayBuffer>;
  int32: Int32Array<ArrayBuffer>;
  float64: Float64Array<ArrayBuffer>;
}

const constructors: { [K in keyof Kinds]: (length: number) => Kinds[K] } = {
  int16: (length) => new Int16Array(length),
  int32: (length) => new Int32Array(length),
  float64: (length) => new Float64Array(length),
};

const INITIAL_LENGTH = 64;
/** Growth factor: few copies, and at most a third of the array is unused. */
const GROWTH = 1.5;

export class GrowingArray<K extends keyof Kinds> {
  readonly #kind: K;
  #values: Kinds[K];
  #length = 0;

  constructor(kind: K) {
    this.#kind = kind;
    this.#values = constructors[kind](INITIAL_LENGTH);
  }

  get length(): number {
    return this.#length;
  }

  /** Allocated bytes, including unused capacity. */
  get byteLength(): number {
    return this.#values.byteLength;
  }

  /** Returns the number at an index, or NaN outside the array. */
  at(index: number): number {
    return index < this.#length ? (this.#values[index] ?? Number.NaN) : Number.NaN;
  }

  /** Changes the number at an existing index. */
  set(index: number, value: number): void {
    if (index < this.#length) this.#values[index] = value;
  }

  push(value: number): void {
    if (this.#length === this.#values.length) this.#grow(this.#length + 1);
    this.#values[this.#length++] = value;
  }

  /** Retains the first `length` numbers. */
  truncate(length: number): void {
    this.#length = Math.min(this.#length, length);
  }

  /** Removes the first `count` numbers and moves the others to the front. */
  dropFirst(count: number): void {
    this.#values.copyWithin(0, count, this.#length);
    this.#length = Math.max(0, this.#length - count);
  }

  /** Returns a copy of the numbers from an index on. */
  copyFrom(index: number): Kinds[K] {
    const copy = constructors[this.#kind](Math.max(0, this.#length - index));
    copy.set(this.#values.subarray(index, this.#length));
    return copy;
  }

  /** Replaces the numbers from an index on. */
  replaceFrom(index: number, values: Kinds[K]): void {
    this.truncate(index);
    const length = this.#length + values.length;
    if (length > this.#values.length) this.#grow(length);
    this.#values.set(values, this.#length);
    this.#length = length;
  }

  /** Number of values up to `value`, by binary search. The numbers must be in ascending order. */
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

  #grow(minLength: number): void {
    const length = Math.max(minLength, Math.ceil(this.#values.length * GROWTH));
    const values = constructors[this.#kind](length);
    values.set(this.#values.subarray(0, this.#length));
    this.#values = values;
  }
}
