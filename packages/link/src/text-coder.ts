/**
 * Codes the texts of a lesson with one model, so that each text makes the next ones shorter. A text
 * that repeats a recent one, such as the name of a maze, takes a few bits.
 */
import { trainedModel } from "./name-coder.ts";
import type { LetterModel } from "./letter-model.ts";
import { codeUniform, SymbolModel } from "./numbers.ts";
import { BitModel, type BitCoder } from "./range-coder.ts";

/** Number of texts that can be repeated. */
const RECENT = 16;
/** Maximum sum of the counts after the same letter. */
const MAX_PAIR = 255;

export class TextCoder {
  readonly #letters: LetterModel = trainedModel().copy(MAX_PAIR);
  readonly #units = new UnitModel();
  readonly #repeats = new BitModel(1, 4);
  /** newest first; many texts are empty */
  #recent: readonly string[] = [""];

  /** @param maxLength in UTF-16 code units; a decoder can return a longer text */
  code(coder: BitCoder, text: string, maxLength: number): string {
    const at = this.#recent.indexOf(text);
    const coded =
      this.#repeats.code(coder, 0, at < 0 ? 0 : 1) === 1
        ? (this.#recent[codeUniform(coder, this.#recent.length, at)] ?? "")
        : this.#letters.codeText(coder, text, maxLength, (each, unit) =>
            this.#units.code(each, unit),
          );
    this.#recent = [coded, ...this.#recent.filter((each) => each !== coded)].slice(0, RECENT);
    return coded;
  }
}

/** Codes UTF-16 code units. A text uses few values of the upper byte. */
class UnitModel {
  readonly #uppers = new SymbolModel(8);
  readonly #lowers = new Map<number, SymbolModel>();

  code(coder: BitCoder, unit: number): number {
    const upper = this.#uppers.code(coder, unit >> 8);
    let lowers = this.#lowers.get(upper);
    if (lowers === undefined) {
      lowers = new SymbolModel(8);
      this.#lowers.set(upper, lowers);
    }
    return upper * 256 + lowers.code(coder, unit & 255);
  }
}
