import { readdirSync, readFileSync } from "node:fs";
import { describe, expect, it } from "vitest";
import { hardSentences } from "./testing/reading-level.ts";

const folder = new URL("en/", import.meta.url);
const files = readdirSync(folder).filter((name) => name.endsWith(".json"));

function textsOf(value: unknown, path: string): [string, string][] {
  if (typeof value === "string") return [[path, value]];
  return Object.entries(value as object).flatMap(([key, inner]) =>
    textsOf(inner, path === "" ? key : `${path}.${key}`),
  );
}

function hardOf(texts: Record<string, string>): string[] {
  return hardSentences(new Map(Object.entries(texts)));
}

describe("English for students", () => {
  it.each(files)("is read at grade 6 or below in %s", (file) => {
    const texts = textsOf(JSON.parse(readFileSync(new URL(file, folder), "utf8")), "");
    expect(hardSentences(new Map(texts))).toEqual([]);
  });
});

describe("the reading level", () => {
  it("names key, grade and sentence of what is too hard", () => {
    expect(
      hardOf({
        "bump.why": "Bump. The vehicle encountered an impenetrable obstruction immediately.",
        "bump.fine": "The robot hit the wall because line 2 turned too soon.",
      }),
    ).toEqual([
      expect.stringMatching(/^bump\.why: grade 2\d\.\d: The vehicle encountered an impenetrable/),
    ]);
  });

  it("finds a sentence of short words that does not end", () => {
    const long =
      "The robot drives on until it sees that the wall is near and then it turns to the left and drives on until it sees a wall once more.";
    expect(hardOf({ long })).toHaveLength(1);
    expect(hardOf({ short: long.replace(" and then it turns", ". Then it turns") })).toEqual([]);
  });

  it("counts what the gaps of a text hold", () => {
    expect(hardOf({ gap: "The {{count}} of {{action}} {{unknown}} is here." })).toEqual([]);
    expect(hardOf({ gap: "Immediately {{sensor}} is {{number}} extraordinarily." })).toHaveLength(
      1,
    );
  });

  it("takes the words of the field for easy, also in the plural and at the end", () => {
    expect(hardOf({ field: "Otherwise programs read conditions of sensors." })).toEqual([]);
  });

  it("does not judge labels", () => {
    expect(hardOf({ label: "Keyboard accessibility configuration" })).toEqual([]);
  });
});
