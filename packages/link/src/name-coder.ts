/**
 * Codes names of documents. A model of letters, trained with the names below, predicts each letter
 * from the previous one. A name unlike the training names, such as a password, is coded as plain
 * seven-bit characters.
 */
import { LetterModel } from "./letter-model.ts";
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
    ? trainedModel().copy().codeText(coder, name, maxLength, codeAnyUnit)
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

let trained: LetterModel | null = null;

/**
 * Returns the model trained with the names. It is trained once, because a run can contain two
 * thousand names.
 */
export function trainedModel(): LetterModel {
  if (trained !== null) return trained;
  trained = new LetterModel(Number.POSITIVE_INFINITY);
  for (const word of TRAINING_NAMES.split("|")) {
    trained.codeText(trainer, word, word.length, codeAnyUnit);
  }
  return trained;
}

function codeAnyUnit(coder: BitCoder, unit: number): number {
  return codeUniform(coder, 65_536, unit);
}
