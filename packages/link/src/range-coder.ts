/**
 * Adaptive binary range coder whose digits are the characters of a link: six bits at a time.
 *
 * Whole numbers below 2^36 only, so every engine computes the same bits. Encoder and decoder have one
 * shape: `bit` takes the bit to write and gives back the bit that holds. So each part of a document is
 * described once, in one function that writes when it is given an encoder and reads when it is given
 * a decoder.
 */

const DIGIT = 64;
/** The range that a coder starts with: five digits. */
const FULL = DIGIT * DIGIT * DIGIT * DIGIT * DIGIT;
/** Below this the next digit is settled. */
const SMALL = FULL / DIGIT;
/** Digits that a decoder reads past the end of an undamaged link; see `Encoder.finish`. */
const READ_AHEAD = 4;

/** Writes or reads one bit. */
export interface BitCoder {
  /**
   * @param zeros how often a 0 is expected, and `ones` a 1: whole numbers from 1, together below 2^17
   * @param bit what to write; a decoder ignores it
   * @returns the bit written or read, 0 or 1
   */
  bit: (zeros: number, ones: number, bit: number) => number;
}

export class Encoder implements BitCoder {
  #low = 0;
  #range = FULL;
  readonly #digits: number[] = [];

  bit(zeros: number, ones: number, bit: number): number {
    const bound = Math.floor(this.#range / (zeros + ones)) * zeros;
    if (bit === 0) {
      this.#range = bound;
    } else {
      this.#low += bound;
      this.#range -= bound;
    }
    while (this.#range < SMALL) {
      this.#shift();
      this.#range *= DIGIT;
    }
    return bit;
  }

  /**
   * One more digit is enough to name a number within the range, which is at least as wide as a digit
   * is high. The decoder therefore always ends exactly four digits behind the last one.
   * @returns numbers from 0 to 63
   */
  finish(): readonly number[] {
    this.#low = Math.ceil(this.#low / SMALL) * SMALL;
    this.#shift();
    return this.#digits;
  }

  #shift(): void {
    if (this.#low >= FULL) {
      this.#low -= FULL;
      let at = this.#digits.length - 1;
      while (this.#digits[at] === DIGIT - 1) {
        this.#digits[at] = 0;
        at -= 1;
      }
      this.#digits[at] = (this.#digits[at] ?? 0) + 1;
    }
    const digit = Math.floor(this.#low / SMALL);
    this.#digits.push(digit);
    this.#low = (this.#low - digit * SMALL) * DIGIT;
  }
}

export class Decoder implements BitCoder {
  readonly #digits: readonly number[];
  #position = 0;
  #value = 0;
  #range = FULL;

  /** @param digits numbers from 0 to 63; any are accepted, and zeros are read behind them */
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
    while (this.#range < SMALL) {
      this.#shift();
      this.#range *= DIGIT;
    }
    return bit;
  }

  /** Digits still missing (positive) or left over (negative); 0 once all of a link is read. */
  missing(): number {
    return this.#position - READ_AHEAD - this.#digits.length;
  }

  #shift(): void {
    this.#value = this.#value * DIGIT + (this.#digits[this.#position] ?? 0);
    this.#position += 1;
  }
}

/** Halved when a context has seen this much, so that the recent past counts more. */
const MAX_COUNT = 8_192;

/** What has been seen so far in each of several contexts; learns alike while writing and reading. */
export class BitModel {
  readonly #zeros: Uint16Array;
  readonly #ones: Uint16Array;
  readonly #gain: number;

  /** @param gain how much one bit teaches, against 2 + 2 that are believed before the first one */
  constructor(contexts: number, gain: number) {
    this.#zeros = new Uint16Array(contexts).fill(2);
    this.#ones = new Uint16Array(contexts).fill(2);
    this.#gain = gain;
  }

  /** Writes or reads one bit in a context from 0 to `contexts` - 1. */
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
