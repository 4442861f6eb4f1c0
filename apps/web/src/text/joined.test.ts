import { describe, expect, it } from "vitest";
import { en } from "./en/index.ts";
import { createI18n, showLanguage } from "./i18n.ts";
import { asSentence, joinList, joinSentences } from "./joined.ts";
import type { LanguageTag } from "./languages.ts";

async function wordsIn(tag: LanguageTag) {
  const words = createI18n(en);
  await showLanguage(words, tag);
  return words.t;
}

describe("parts side by side", () => {
  it.each([
    ["en", "a, b, c", "A. B."],
    ["fr", "a, b, c", "A. B."],
    ["ja", "a、b、c", "A。B。"],
    ["zh-Hans", "a，b，c", "A。B。"],
    ["ar", "a، b، c", "A. B."],
  ] as const)("have the signs of %s between them", async (tag, list, sentences) => {
    const t = await wordsIn(tag);
    expect(joinList(t, ["a", "b", "c"])).toBe(list);
    expect(joinSentences(t, [asSentence(t, "A"), asSentence(t, "B")])).toBe(sentences);
  });

  it("stay as they are, whatever is in them", async () => {
    const t = await wordsIn("ar");
    expect(joinList(t, ["<b> {{other}} $t(x)", "1.5"])).toBe("<b> {{other}} $t(x)، 1.5");
  });

  it("are nothing when there are none, and one when there is one", async () => {
    const t = await wordsIn("en");
    expect(joinList(t, [])).toBe("");
    expect(joinSentences(t, ["Alone."])).toBe("Alone.");
  });
});
