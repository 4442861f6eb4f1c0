/** What a student reads after the typical wrong answer, in whole sentences of every language. */
import { describe, expect, it } from "vitest";
import { en } from "../../../text/en/index.ts";
import { createI18n } from "../../../text/i18n.ts";
import { languages } from "../../../text/languages.ts";
import { loadWords } from "../../../text/load-words.ts";
import { checkProgram } from "../../../worker/check-program.ts";
import type { ProgramDocument } from "@corridor/program";
import english from "../../../text/en/missions.json" with { type: "json" };
import { failureText } from "../failure-text.ts";
import type { MissionWords } from "../mission-words.ts";
import { challengeOf } from "./mission.ts";
import { missions } from "./missions.ts";
import { answers } from "./testing/answers.ts";

const noWords = { task: "Task", short: "Task", hints: [] };
const programs = missions.flatMap((mission) => {
  const { attempt, reads } = answers[mission.id].wrong;
  return "rules" in attempt ? [{ id: mission.id, mission, program: attempt, reads }] : [];
});

function reader(language: string, words: object, ownMissions: object): MissionWords {
  const i18n = createI18n(en);
  i18n.addResourceBundle(language, "words", words);
  i18n.addResourceBundle(language, "missions", ownMissions);
  const t = i18n.getFixedT(language, ["missions", "words"]) as MissionWords["t"];
  return { t, i18n: { language } };
}

function feedback(
  words: MissionWords,
  mission: (typeof missions)[number],
  program: ProgramDocument,
): string {
  const challenge = challengeOf(mission, "Mission", noWords);
  const { verdict, blames } = checkProgram({ challenge, program });
  if (verdict.failure === null) throw new Error("no failure");
  return failureText(words, challenge, verdict.failure, blames[verdict.failure.maze ?? -1] ?? null)
    .replaceAll("\u2068", "")
    .replaceAll("\u2069", "");
}

describe("after the typical wrong answer to", () => {
  const words = reader("en", en, english);

  it.each(programs)("$id the student reads which line is to blame, and why", (each) => {
    const text = feedback(words, each.mission, each.program);
    expect(text).toBe(each.reads);
    expect(text).toMatch(/line \d|“otherwise”/i);
    expect(text).toMatch(/\d cm/);
  });
});

describe.each(languages.filter(({ tag }) => tag !== "en"))("in $name", ({ tag }) => {
  it("every feedback is a sentence with all of its values", async () => {
    const [words, own] = await Promise.all([loadWords(tag, "words"), loadWords(tag, "missions")]);
    const theirs = reader(tag, words, own);
    for (const { mission, program, reads } of programs) {
      const text = feedback(theirs, mission, program);
      expect(text).not.toMatch(/\{\{|undefined|NaN|missions:|blame\./);
      expect(text).not.toBe(reads);
    }
  });
});
