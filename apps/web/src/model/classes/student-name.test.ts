import { NAME_WORDS, studentNameSchema } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { studentNameText } from "./student-name.ts";
import { studentWords } from "./student-names.ts";

describe("the name of a student", () => {
  it("is the word with the number that the relay assigned", () => {
    expect(studentNameText({ word: 0, text: null })).toBe("Acorn");
    expect(studentNameText({ word: NAME_WORDS - 1, text: null })).toBe("Zinnia");
  });

  it("is the pseudonym of a teacher who pasted one", () => {
    expect(studentNameText({ word: null, text: "Team 4" })).toBe("Team 4");
  });
});

describe("the list of words", () => {
  it("has a different word for each number", () => {
    expect(studentWords).toHaveLength(NAME_WORDS);
    expect(new Set(studentWords).size).toBe(NAME_WORDS);
  });

  it("has words that fit wherever a pseudonym fits", () => {
    const fits = (text: string) => studentNameSchema.safeParse({ word: null, text }).success;
    expect(studentWords.filter((word) => !fits(word))).toEqual([]);
  });
});
