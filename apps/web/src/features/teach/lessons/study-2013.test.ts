import { parseLesson, type LessonDocument } from "@corridor/challenge";
import { decodeLink, encodeLink } from "@corridor/link";
import { readFileSync } from "node:fs";
import { describe, expect, it } from "vitest";
import { en } from "../../../text/en/index.ts";
import { createI18n, showLanguage } from "../../../text/i18n.ts";
import { languages, type LanguageTag } from "../../../text/languages.ts";
import { study2013 } from "./study-2013.ts";

/** Largest lesson of a short link or a class. */
const MAX_CLASS_BYTES = 64 * 1024;

const table9 = readFileSync(
  new URL("../../../../../../packages/report/src/testing/table-9-survey.csv", import.meta.url),
  "utf8",
);

async function studyIn(tag: LanguageTag): Promise<LessonDocument> {
  const words = createI18n(en);
  await words.loadNamespaces(["missions", "teach"]);
  await showLanguage(words, tag);
  return study2013(words);
}

describe("the 2013 study as a lesson", () => {
  it("has the introduction, the two algorithms and the questions of the paper's table", async () => {
    const study = await studyIn("en");
    expect(study.tasks.map(({ name }) => name)).toEqual([
      "Make it move",
      "How far is the wall?",
      "One line",
      "The first true line",
      "Follow the right wall",
      "The farthest distance",
    ]);
    expect(study.survey.map(({ id }) => id)).toEqual(table9.split(/\r?\n/)[0]?.split(","));
  });

  it.each(languages)("is valid, and fits a link and a class in $name", async ({ tag }) => {
    const study = await studyIn(tag);
    expect(study.language).toBe(tag);
    expect(new Set(study.survey.map(({ question }) => question)).size).toBe(4);
    expect(parseLesson(study)).toEqual({ ok: true, value: study });
    expect(Buffer.byteLength(JSON.stringify(study))).toBeLessThan(MAX_CLASS_BYTES);
    const link = encodeLink({ lesson: study });
    expect(link.ok && decodeLink(link.text)).toEqual({ ok: true, value: { lesson: study } });
  });
});
