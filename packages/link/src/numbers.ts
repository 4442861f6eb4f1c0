/** Numbers bit by bit, for an encoder and a decoder alike (see `range-coder.ts`). */
import { BitModel, type BitCoder } from "./range-coder.ts";

/**
 * A whole number from 0 to `limit` - 1, all equally likely; costs log2(limit) bits.
 * @param limit 1 to 65,536
 */
export function codeUniform(coder: BitCoder, limit: number, value: number): number {
  let low = 0;
  let high = limit;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (coder.bit(middle - low, high - middle, value < middle ? 0 : 1) === 0) high = middle;
    else low = middle;
  }
  return low;
}

/** A symbol of a few bits as a path down a binary tree; each fork learns by itself. */
export class SymbolModel {
  readonly #model: BitModel;
  readonly #bits: number;

  constructor(bits: number) {
    this.#bits = bits;
    this.#model = new BitModel(1 << bits, 4);
  }

  code(coder: BitCoder, symbol: number): number {
    let node = 1;
    for (let shift = this.#bits - 1; shift >= 0; shift -= 1) {
      node = node * 2 + this.#model.code(coder, node, (symbol >> shift) & 1);
    }
    return node - (1 << this.#bits);
  }
}

/** No number in a document needs more binary digits. */
const MAX_BITS = 20;
const MAX_WHOLE = (1 << MAX_BITS) - 1;
/** Leading digits that have forks of their own; what follows them is as good as random. */
const LEARNED_PREFIXES = 1_024;

/** Whole numbers from 0 to 2^20 - 2, small ones and those seen before short. */
export class NumberModel {
  readonly #lengths = new BitModel(MAX_BITS, 4);
  readonly #prefixes = new BitModel(LEARNED_PREFIXES, 4);

  code(coder: BitCoder, value: number): number {
    // The length of value + 1 in binary, then its digits behind the first, which is always 1.
    const wanted = value + 1;
    let length = 1;
    while (length < MAX_BITS) {
      const isLonger = wanted >= 1 << length ? 1 : 0;
      if (this.#lengths.code(coder, length, isLonger) === 0) break;
      length += 1;
    }
    let prefix = 1;
    for (let shift = length - 2; shift >= 0; shift -= 1) {
      const digit = (wanted >> shift) & 1;
      const coded =
        prefix < LEARNED_PREFIXES
          ? this.#prefixes.code(coder, prefix, digit)
          : coder.bit(1, 1, digit);
      prefix = prefix * 2 + coded;
    }
    return prefix - 1;
  }
}

/** Any number, exactly; small whole ones and those seen before short. */
export class RealModel {
  readonly #wholes = new NumberModel();
  /** is it no small whole number, is it negative */
  readonly #forms = new BitModel(2, 4);

  code(coder: BitCoder, value: number): number {
    // -0 is a legal number in JSON; its sign would be lost on the short way.
    const isWhole = Number.isInteger(value) && !Object.is(value, -0) && Math.abs(value) < MAX_WHOLE;
    if (this.#forms.code(coder, 0, isWhole ? 0 : 1) === 1) return codeFloat(coder, value);
    const isNegative = this.#forms.code(coder, 1, value < 0 ? 1 : 0) === 1;
    const size = this.#wholes.code(coder, Math.abs(value));
    return isNegative ? -size : size;
  }
}

/** Any number that is not a small whole one: its 64 bits, exactly. */
export function codeFloat(coder: BitCoder, value: number): number {
  const view = new DataView(new ArrayBuffer(8));
  view.setFloat64(0, value);
  for (let at = 0; at < 8; at += 2) {
    view.setUint16(at, codeUniform(coder, 65_536, view.getUint16(at)));
  }
  return view.getFloat64(0);
}
