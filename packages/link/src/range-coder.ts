/**
 * Adaptive binary range coder. Its digits are the characters of a link, six bits each.
 *
 * It uses whole numbers below 2^36 only, so every JavaScript engine computes the same bits. Encoder
 * and decoder share one interface: `bit` receives the bit to encode and returns the coded bit. One
 * function per part of a document therefore encodes or decodes, depending on the coder.
 */

const DIGIT = 64;
/** Initial range: five digits. */
const FULL_RANGE = DIGIT * DIGIT * DIGIT * DIGIT * DIGIT;
/** Below this range, the next digit is determined. */
const MIN_RANGE = FULL_RANGE / DIGIT;
/** Number of digits that a decoder reads after the end of a valid link; see `Encoder.finish`. */
const READ_AHEAD = 4;

/** Encodes or decodes one bit. */
export interface BitCoder {
  /**
   * @param zeros relative frequency of a 0, as `ones` of a 1: whole numbers from 1, in total below
   *   2^17
   * @param bit the bit to encode; a decoder ignores it
   * @returns the coded bit, 0 or 1
   */
  bit: (zeros: number, ones: number, bit: number) => number;
}

export class Encoder implements BitCoder {
  #low = 0;
  #range = FULL_RANGE;
  readonly #digits: number[] = [];

  bit(zeros: number, ones: number, bit: number): number {
    const bound = Math.floor(this.#range / (zeros + ones)) * zeros;
    if (bit === 0) {
      this.#range = bound;
    } else {
      this.#low += bound;
      this.#range -= bound;
    }
    while (this.#range < MIN_RANGE) {
      this.#shift();
      this.#range *= DIGIT;
    }
    return bit;
  }

  /** Number of digits so far. */
  get length(): number {
    return this.#digits.length;
  }

  /**
   * Writes the last digit. One digit is sufficient to identify a number in the range, because the
   * range is at least as wide as the digit's value. The decoder always ends exactly four digits
   * after it.
   * @returns numbers from 0 to 63
   */
  finish(): readonly number[] {
    this.#low = Math.ceil(this.#low / MIN_RANGE) * MIN_RANGE;
    this.#shift();
    return this.#digits;
  }

  #shift(): void {
    if (this.#low >= FULL_RANGE) {
      this.#low -= FULL_RANGE;
      let at = this.#digits.length - 1;
      while (this.#digits[at] === DIGIT - 1) {
        this.#digits[at] = 0;
        at -= 1;
      }
      this.#digits[at] = (this.#digits[at] ?? 0) + 1;
    }
    const digit = Math.floor(this.#low / MIN_RANGE);
    this.#digits.push(digit);
    this.#low = (this.#low - digit * MIN_RANGE) * DIGIT;
  }
}

export class Decoder implements BitCoder {
  readonly #digits: readonly number[];
  #position = 0;
  #value = 0;
  #range = FULL_RANGE;

  /** @param digits any numbers from 0 to 63; zeros follow them */
  constructor(digits: readonly number[]) {
    this.#digits = digits;
    for (let count = 0; count <= READ_AHEAD; count += 1) this.#shift();
  }

  bit(zeros: number, ones: number): number {
    const bound = Math.floor(this.#range / (zeros + ones)) * zeros;
    const bit = this.#value < bound ? 0 : 1;
    if (bit === 0) {
      this.#range = bound;
    } else {
      this.#value -= bound;
      this.#range -= bound;
    }
    while (this.#range < MIN_RANGE) {
      this.#shift();
      this.#range *= DIGIT;
    }
    return bit;
  }

  /** Number of missing digits; negative for extra digits, 0 after a complete link. */
  missing(): number {
    return this.#position - READ_AHEAD - this.#digits.length;
  }

  #shift(): void {
    this.#value = this.#value * DIGIT + (this.#digits[this.#position] ?? 0);
    this.#position += 1;
  }
}

/** Above this sum, the counts of a context are halved, so that recent bits have more weight. */
const MAX_COUNT = 8_192;

/** Adaptive bit counts for several contexts. Encoder and decoder update them identically. */
export class BitModel {
  readonly #zeros: Uint16Array;
  readonly #ones: Uint16Array;
  readonly #gain: number;

  /** @param gain increment of a count per bit; both counts start at 2 */
  constructor(
    contexts: number,
    gain: number,
    zeros = new Uint16Array(contexts).fill(2),
    ones = new Uint16Array(contexts).fill(2),
  ) {
    this.#zeros = zeros;
    this.#ones = ones;
    this.#gain = gain;
  }

  /** Returns a model with the same counts. */
  copy(): BitModel {
    const zeros = this.#zeros.slice();
    return new BitModel(zeros.length, this.#gain, zeros, this.#ones.slice());
  }

  /** Encodes or decodes one bit in a context from 0 to `contexts` - 1. */
  code(coder: BitCoder, context: number, bit: number): number {
    const zeros = this.#zeros[context] ?? 1;
    const ones = this.#ones[context] ?? 1;
    const coded = coder.bit(zeros, ones, bit);
    const counts = coded === 0 ? this.#zeros : this.#ones;
    counts[context] = (coded === 0 ? zeros : ones) + this.#gain;
    if (zeros + ones > MAX_COUNT) {
      this.#zeros[context] = (zeros >> 1) + 1;
      this.#ones[context] = (ones >> 1) + 1;
    }
    return coded;
  }
}
