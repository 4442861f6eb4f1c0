/** How hard English sentences are to read: their grade by the formula of Flesch and Kincaid. */
import { fleschKincaid } from "flesch-kincaid";
import { syllable } from "syllable";

/** Texts for students stay at this grade of US schools or below: a reader of 11 or 12 years. */
export const MAX_GRADE = 6;

/** A shorter sentence is a label or a value; one long word would decide its grade. */
const FEWEST_WORDS = 5;

/** Words of the field that students meet all the time, and names: each counts as one syllable. */
const easyWords = new Set(
  `robot sensor program otherwise delayed condition action decision corridor opening timeline
   centimetre internet connection Python JavaScript`
    .toLowerCase()
    .split(/\s+/),
);

/** What stands in a text's gaps; a number where nothing is said here. */
const values: Readonly<Record<string, string>> = {
  action: "delayed right 90",
  sensor: "front",
  condition: "right > 60",
  side: "right",
  open: "left",
  facing: "up",
  place: "row 2, column 3",
  square: "row 2, column 3",
  maze: "Spiral",
  name: "Spiral",
  program: "Right wall",
  script: "Right wall (Python script)",
  client: "Python script",
  language: "German",
  tag: "tlh",
  when: "5 minutes ago",
  advice: "line 1 is always true.",
  reason: "A file did not load.",
  found: "fly",
  expected: "stop",
  text: "Line 2",
  one: "block",
  other: "goal",
  first: "Bump at 2 s.",
  second: "Line 1 is always true.",
};

/** A text of a catalogue, by its key. */
export type Texts = ReadonlyMap<string, string>;

/** @returns one line for each sentence that is too hard: its key, its grade, the sentence */
export function hardSentences(texts: Texts): string[] {
  return [...texts].flatMap(([key, text]) =>
    sentencesOf(text)
      .filter(({ grade }) => grade > MAX_GRADE)
      .map(({ sentence, grade }) => `${key}: grade ${grade.toFixed(1)}: ${sentence}`),
  );
}

/** As Flesch counts them: a colon and a semicolon end a sentence, too. */
function sentencesOf(text: string): { sentence: string; grade: number }[] {
  const filled = text.replaceAll(/\{\{(\w+)\}\}/g, (_, name: string) => values[name] ?? "12");
  return filled.split(/(?<=[.?!:;]\p{Pf}?)\s+/u).flatMap((sentence) => {
    const words = sentence.match(/[\p{L}\d][\p{L}\d.'’-]*/gu) ?? [];
    if (words.length < FEWEST_WORDS) return [];
    const syllables = words.reduce((sum, word) => sum + syllablesIn(word), 0);
    const grade = fleschKincaid({ sentence: 1, word: words.length, syllable: syllables });
    return [{ sentence, grade }];
  });
}

function syllablesIn(word: string): number {
  const bare = word.toLowerCase().replace(/[.'’-]+$|['’]s$/, "");
  const isEasy = easyWords.has(bare) || easyWords.has(bare.replace(/s$/, ""));
  return isEasy ? 1 : Math.max(1, syllable(bare));
}
