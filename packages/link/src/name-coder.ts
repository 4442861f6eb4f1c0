/**
 * Names of documents. A letter is foretold from the one before it, by a model that has first learned
 * the text below; a name that is unlike it (a password, say) goes as plain seven-bit characters.
 */
import { codeUniform } from "./numbers.ts";
import type { BitCoder } from "./range-coder.ts";

/** Part of link version 1 for ever: another text would make every link in the world unreadable. */
const LESSON =
  "Maze|Tree|Start|My maze|Right wall|Left wall|Long way round|First steps|Straight corridor|Spiral|" +
  "Comb|Two rooms|Empty|Back and forth|Farthest distance|Left at every wall|Program|Labyrinth|Level 1|" +
  "Level 2|Lesson 3|Random 50 %|New maze|The end of the room|Robot on the line|Untitled|Puzzle 4|" +
  "Class 5b|Corridor with dead ends|Turn right|My program|Test 10|Group A 6|City 7|House 8|Island 9|" +
  "Snake|Garden|Challenge|In and out|Irrgarten|Mein Labyrinth|Klasse 7a|Laberinto|Labyrinthe";

/** Symbols behind the 128 of ASCII: the end of the name, and a UTF-16 unit in 16 bits. */
const END = 128;
const OTHER = 129;
const SYMBOL_BITS = 8;
const SYMBOLS = 1 << SYMBOL_BITS;
/** What a bit in the same place after the same letter counts more than one after any letter. */
const PAIR_WEIGHT = 8;
/** How many bits after any letter are remembered. */
const MAX_SINGLE = 20;

/** Two models in one: counts after the same letter, and a little of those after any letter. */
class LetterModel {
  /** [zeros, ones] of a fork, one after the other */
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
      const expect = (bit: number): number =>
        1 + (this.#singles[single + bit] ?? 0) + PAIR_WEIGHT * (this.#pairs[pair + bit] ?? 0);
      const bit = coder.bit(expect(0), expect(1), (symbol >> shift) & 1);
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

/** Takes what it is given and keeps nothing: learning is writing without a link. */
const learner: BitCoder = { bit: (_zeros, _ones, bit) => bit };

/**
 * Writes or reads a name.
 * @param maxLength in UTF-16 units; a decoder stops one behind it, so that the schema can refuse it
 * @param isPlain which of the two ways an encoder takes; a decoder is told by the link
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

/** Whether a name can go as seven-bit characters. */
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
  return codeWord(coder, taught().copy(), name, maxLength);
}

let lesson: LetterModel | null = null;

/** Learned once: a link of a run may bring two thousand names. */
function taught(): LetterModel {
  if (lesson !== null) return lesson;
  lesson = new LetterModel();
  for (const word of LESSON.split("|")) codeWord(learner, lesson, word, word.length);
  return lesson;
}

function codeWord(coder: BitCoder, model: LetterModel, word: string, maxLength: number): string {
  let coded = "";
  let before = END;
  while (coded.length <= maxLength) {
    const unit = coded.length < word.length ? word.charCodeAt(coded.length) : undefined;
    const wanted = unit === undefined ? END : unit < 128 ? unit : OTHER;
    const symbol = model.code(coder, before, wanted);
    if (symbol === END) break;
    coded += String.fromCharCode(symbol < END ? symbol : codeUniform(coder, 65_536, unit ?? 0));
    before = symbol;
  }
  return coded;
}
