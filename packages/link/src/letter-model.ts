/**
 * Predicts each letter of a text from the previous one. It mixes two counts: letters after the same
 * letter, and with less weight letters after any letter.
 */
import type { BitCoder } from "./range-coder.ts";

/** Symbols after the 128 of ASCII: the end of the text, and any other UTF-16 code unit. */
const END = 128;
const OTHER = 129;
const SYMBOL_BITS = 8;
const SYMBOLS = 1 << SYMBOL_BITS;
/** Weight of a count after the same letter, relative to a count after any letter. */
const PAIR_WEIGHT = 8;
/** Maximum sum of the counts after any letter. Above it, they are halved. */
const MAX_SINGLE = 20;

/** Codes a UTF-16 code unit outside of ASCII. */
export type UnitCoder = (coder: BitCoder, unit: number) => number;

export class LetterModel {
  readonly #maxPair: number;
  /** counts of zeros and ones, interleaved, for each node of the symbol tree */
  readonly #singles: Uint16Array;
  readonly #pairs: Uint16Array;

  /**
   * @param maxPair maximum sum of the counts after the same letter, above which they are halved.
   *   Texts of thousands of letters need one, because a count has 16 bits.
   */
  constructor(
    maxPair: number,
    singles = new Uint16Array(SYMBOLS * 2),
    pairs = new Uint16Array(SYMBOLS * SYMBOLS * 2),
  ) {
    this.#maxPair = maxPair;
    this.#singles = singles;
    this.#pairs = pairs;
  }

  /** Returns a model that has counted the same letters. @param maxPair as in the constructor */
  copy(maxPair = this.#maxPair): LetterModel {
    return new LetterModel(maxPair, this.#singles.slice(), this.#pairs.slice());
  }

  /**
   * Encodes or decodes a text and its end.
   * @param maxLength in UTF-16 code units; a decoder stops one unit after it, so that the schema
   *   rejects the text
   */
  codeText(coder: BitCoder, text: string, maxLength: number, codeUnit: UnitCoder): string {
    let coded = "";
    let before = END;
    while (coded.length <= maxLength) {
      const unit = coded.length < text.length ? text.charCodeAt(coded.length) : undefined;
      const expected = unit === undefined ? END : unit < 128 ? unit : OTHER;
      const symbol = this.#code(coder, before, expected);
      if (symbol === END) break;
      coded += String.fromCharCode(symbol < END ? symbol : codeUnit(coder, unit ?? 0));
      before = symbol;
    }
    return coded;
  }

  #code(coder: BitCoder, before: number, symbol: number): number {
    let node = 1;
    for (let shift = SYMBOL_BITS - 1; shift >= 0; shift -= 1) {
      const single = node * 2;
      const pair = (before * SYMBOLS + node) * 2;
      const weightOf = (bit: number): number =>
        1 + (this.#singles[single + bit] ?? 0) + PAIR_WEIGHT * (this.#pairs[pair + bit] ?? 0);
      const bit = coder.bit(weightOf(0), weightOf(1), (symbol >> shift) & 1);
      count(this.#singles, single, bit, MAX_SINGLE);
      count(this.#pairs, pair, bit, this.#maxPair);
      node = node * 2 + bit;
    }
    return node - SYMBOLS;
  }
}

function count(counts: Uint16Array, at: number, bit: number, max: number): void {
  counts[at + bit] = (counts[at + bit] ?? 0) + 1;
  const [zeros = 0, ones = 0] = [counts[at], counts[at + 1]];
  if (zeros + ones <= max) return;
  counts[at] = zeros >> 1;
  counts[at + 1] = ones >> 1;
}
