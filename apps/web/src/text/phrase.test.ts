import { describe, expect, it } from "vitest";
import { en } from "./en/index.ts";
import { createI18n } from "./i18n.ts";
import { preparePhrase } from "./phrase.ts";

describe("a sentence that is prepared once", () => {
  const { t } = createI18n(en);

  it("reads as one that is looked up each time", () => {
    const phrase = preparePhrase(["x", "y", "facing"], (marks) => t("stage.robotAt", marks));
    for (const values of [
      { x: 50, y: 650, facing: "up" },
      { x: 0, y: 12, facing: "down left" },
    ]) {
      expect(phrase(values)).toBe(t("stage.robotAt", values));
    }
  });

  it("may name a value twice, or not at all", () => {
    const phrase = preparePhrase(["a", "b"], ({ a }) => `${a}, once more ${a}`);
    expect(phrase({ a: 1, b: 2 })).toBe("1, once more 1");
  });
});
