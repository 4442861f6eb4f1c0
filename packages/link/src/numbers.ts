/** Codes numbers bit by bit, with one function for encoding and decoding (see `range-coder.ts`). */
import { BitModel, type BitCoder } from "./range-coder.ts";

/**
 * Codes a whole number from 0 to `limit` - 1 with a uniform distribution, in log2(limit) bits.
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

/**
 * Codes a symbol of a few bits as a path down a binary tree, with an adaptive model for each node.
 */
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

/** Maximum number of binary digits of a number in a document. */
const MAX_BITS = 20;
const MAX_WHOLE = (1 << MAX_BITS) - 1;
/** Number of prefixes with an adaptive model. The digits after them are coded as random bits. */
const MODELLED_PREFIXES = 1_024;

/** Codes whole numbers from 0 to 2^20 - 2. Small and repeated numbers need few bits. */
export class NumberModel {
  readonly #lengths = new BitModel(MAX_BITS, 4);
  readonly #prefixes = new BitModel(MODELLED_PREFIXES, 4);

  code(coder: BitCoder, value: number): number {
    // The length of value + 1 in binary, then its digits after the first one, which is always 1.
    const target = value + 1;
    let length = 1;
    while (length < MAX_BITS) {
      const isLonger = target >= 1 << length ? 1 : 0;
      if (this.#lengths.code(coder, length, isLonger) === 0) break;
      length += 1;
    }
    let prefix = 1;
    for (let shift = length - 2; shift >= 0; shift -= 1) {
      const digit = (target >> shift) & 1;
      const coded =
        prefix < MODELLED_PREFIXES
          ? this.#prefixes.code(coder, prefix, digit)
          : coder.bit(1, 1, digit);
      prefix = prefix * 2 + coded;
    }
    return prefix - 1;
  }
}

/** Codes any number exactly. Small and repeated whole numbers need few bits. */
export class RealModel {
  readonly #wholes = new NumberModel();
  /** contexts: is it not a small whole number, is it negative */
  readonly #forms = new BitModel(2, 4);

  code(coder: BitCoder, value: number): number {
    // -0 is valid in JSON. The short form would lose its sign.
    const isWhole = Number.isInteger(value) && !Object.is(value, -0) && Math.abs(value) < MAX_WHOLE;
    if (this.#forms.code(coder, 0, isWhole ? 0 : 1) === 1) return codeFloat(coder, value);
    const isNegative = this.#forms.code(coder, 1, value < 0 ? 1 : 0) === 1;
    const size = this.#wholes.code(coder, Math.abs(value));
    return isNegative ? -size : size;
  }
}

/** Codes the 64 bits of a double. */
export function codeFloat(coder: BitCoder, value: number): number {
  const view = new DataView(new ArrayBuffer(8));
  view.setFloat64(0, value);
  for (let at = 0; at < 8; at += 2) {
    view.setUint16(at, codeUniform(coder, 65_536, view.getUint16(at)));
  }
  return view.getFloat64(0);
}
