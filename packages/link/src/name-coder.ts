/**
 * Codes names of documents. An order-1 context model, trained with the names below, predicts each
 * letter from the previous one. A name unlike the training names, such as a password, is coded as
 * plain seven-bit characters.
 */
import { codeUniform } from "./numbers.ts";
import type { BitCoder } from "./range-coder.ts";

/**
 * Part of the format of link version 1. Never change it: existing links would become unreadable.
 */
const TRAINING_NAMES =
  "Maze|Tree|Start|My maze|Right wall|Left wall|Long way round|First steps|Straight corridor|Spiral|" +
  "Comb|Two rooms|Empty|Back and forth|Farthest distance|Left at every wall|Program|Labyrinth|Level 1|" +
  "Level 2|Lesson 3|Random 50 %|New maze|The end of the room|Robot on the line|Untitled|Puzzle 4|" +
  "Class 5b|Corridor with dead ends|Turn right|My program|Test 10|Group A 6|City 7|House 8|Island 9|" +
  "Snake|Garden|Challenge|In and out|Irrgarten|Mein Labyrinth|Klasse 7a|Laberinto|Labyrinthe";

/** Symbols after the 128 of ASCII: the end of the name, and a UTF-16 code unit in 16 bits. */
const END = 128;
const OTHER = 129;
const SYMBOL_BITS = 8;
const SYMBOLS = 1 << SYMBOL_BITS;
/** Weight of a count after the same letter, relative to a count after any letter. */
const PAIR_WEIGHT = 8;
/** Maximum sum of the counts after any letter. Above it, they are halved. */
const MAX_SINGLE = 20;

/** Mixes two models: counts after the same letter, and with less weight counts after any letter. */
class LetterModel {
  /** counts of zeros and ones, interleaved, for each node of the symbol tree */
  readonly #singles: Uint16Array;
  readonly #pairs: Uint16Array;

  constructor(
    singles = new Uint16Array(SYMBOLS * 2),
    pairs = new Uint16Array(SYMBOLS * SYMBOLS * 2),
  ) {
    this.#singles = singles;
    this.#pairs = pairs;
  }

  copy(): LetterModel {
    return new LetterModel(this.#singles.slice(), this.#pairs.slice());
  }

  code(coder: BitCoder, before: number, symbol: number): number {
    let node = 1;
    for (let shift = SYMBOL_BITS - 1; shift >= 0; shift -= 1) {
      const single = node * 2;
      const pair = (before * SYMBOLS + node) * 2;
      const weightOf = (bit: number): number =>
        1 + (this.#singles[single + bit] ?? 0) + PAIR_WEIGHT * (this.#pairs[pair + bit] ?? 0);
      const bit = coder.bit(weightOf(0), weightOf(1), (symbol >> shift) & 1);
      this.#singles[single + bit] = (this.#singles[single + bit] ?? 0) + 1;
      this.#pairs[pair + bit] = (this.#pairs[pair + bit] ?? 0) + 1;
      if ((this.#singles[single] ?? 0) + (this.#singles[single + 1] ?? 0) > MAX_SINGLE) {
        this.#singles[single] = (this.#singles[single] ?? 0) >> 1;
        this.#singles[single + 1] = (this.#singles[single + 1] ?? 0) >> 1;
      }
      node = node * 2 + bit;
    }
    return node - SYMBOLS;
  }
}

/** A coder without output, to train a model. */
const trainer: BitCoder = { bit: (_zeros, _ones, bit) => bit };

/**
 * Encodes or decodes a name.
 * @param maxLength in UTF-16 code units; a decoder stops one unit after it, so that the schema
 *   rejects it
 * @param isPlain whether an encoder uses seven-bit characters; a decoder reads it from the link
 */
export function codeName(
  coder: BitCoder,
  name: string,
  maxLength: number,
  isPlain: boolean,
): string {
  return coder.bit(7, 1, isPlain ? 1 : 0) === 0
    ? codeLetters(coder, name, maxLength)
    : codePlain(coder, name, maxLength);
}

/** Whether a name consists of seven-bit characters. */
export function canBePlain(name: string): boolean {
  for (let at = 0; at < name.length; at += 1) if (name.charCodeAt(at) >= 128) return false;
  return true;
}

function codePlain(coder: BitCoder, name: string, maxLength: number): string {
  const length = codeUniform(coder, maxLength + 1, name.length);
  let coded = "";
  for (let at = 0; at < length; at += 1) {
    coded += String.fromCharCode(codeUniform(coder, 128, name.charCodeAt(at)));
  }
  return coded;
}

function codeLetters(coder: BitCoder, name: string, maxLength: number): string {
  return codeWithModel(coder, trainedModel().copy(), name, maxLength);
}

let trained: LetterModel | null = null;

/** Returns the trained model. It is trained once, because a run can contain two thousand names. */
function trainedModel(): LetterModel {
  if (trained !== null) return trained;
  trained = new LetterModel();
  for (const word of TRAINING_NAMES.split("|")) codeWithModel(trainer, trained, word, word.length);
  return trained;
}

function codeWithModel(
  coder: BitCoder,
  model: LetterModel,
  word: string,
  maxLength: number,
): string {
  let coded = "";
  let before = END;
  while (coded.length <= maxLength) {
    const unit = coded.length < word.length ? word.charCodeAt(coded.length) : undefined;
    const expected = unit === undefined ? END : unit < 128 ? unit : OTHER;
    const symbol = model.code(coder, before, expected);
    if (symbol === END) break;
    coded += String.fromCharCode(symbol < END ? symbol : codeUniform(coder, 65_536, unit ?? 0));
    before = symbol;
  }
  return coded;
}
