/** The reading level of English sentences: their Flesch-Kincaid grade. */
import { fleschKincaid } from "flesch-kincaid";
import { syllable } from "syllable";

/** Highest US school grade for student texts: readers of 11 or 12 years. */
export const MAX_GRADE = 6;

/** Shorter texts are labels, whose grade would depend on a single word. */
const FEWEST_WORDS = 5;

/** Names and terms that students use all the time: each counts as one syllable. */
const easyWords = new Set(
  `robot sensor program otherwise delayed condition action decision corridor opening timeline
   centimetre internet connection Python JavaScript`
    .toLowerCase()
    .split(/\s+/),
);

/** Example values of placeholders; all others are numbers. */
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

/** @returns key, grade and sentence of each sentence above the grade */
export function hardSentences(texts: Texts): string[] {
  return [...texts].flatMap(([key, text]) =>
    sentencesOf(text)
      .filter(({ grade }) => grade > MAX_GRADE)
      .map(({ sentence, grade }) => `${key}: grade ${grade.toFixed(1)}: ${sentence}`),
  );
}

/** Splits a text into sentences; in this formula, colons and semicolons end a sentence, too. */
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
