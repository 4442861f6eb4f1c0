/** The text after the typical wrong answer, in whole sentences of every language. */
import { taskOf } from "@corridor/challenge";
import { describe, expect, it } from "vitest";
import { en } from "../../../text/en/index.ts";
import { createI18n } from "../../../text/i18n.ts";
import { languages } from "../../../text/languages.ts";
import { loadWords } from "../../../text/load-words.ts";
import { checkProgram } from "../testing/check-program.ts";
import reasons from "../../../text/en/diagnosis.json" with { type: "json" };
import english from "../../../text/en/missions.json" with { type: "json" };
import { failureText } from "../failure-text.ts";
import type { MissionWords } from "../mission-words.ts";
import { challengeOf } from "./mission.ts";
import { missions } from "./missions.ts";
import { answers } from "./testing/answers.ts";

const noWords = { task: "Task", short: "Task", hints: [] };
const wrongAnswers = missions.flatMap((mission) => {
  const { attempt, reads } = answers[mission.id].wrong;
  if (!("rules" in attempt)) return [];
  const challenge = challengeOf(mission, "Mission", noWords);
  // Checked once for all languages.
  const { verdict, diagnoses } = checkProgram({ task: taskOf(challenge), program: attempt });
  const { failure } = verdict;
  if (failure === null) throw new Error("no failure");
  const diagnosis = diagnoses[failure.maze ?? -1] ?? null;
  return [{ id: mission.id, challenge, failure, diagnosis, reads }];
});

function reader(
  language: string,
  words: object,
  ownMissions: object,
  ownReasons: object,
): MissionWords {
  const i18n = createI18n(en);
  i18n.addResourceBundle(language, "words", words);
  i18n.addResourceBundle(language, "missions", ownMissions);
  i18n.addResourceBundle(language, "diagnosis", ownReasons);
  const t = i18n.getFixedT(language, ["missions", "words"]) as MissionWords["t"];
  return { t, i18n: { language } };
}

function feedback(
  words: MissionWords,
  { challenge, failure, diagnosis }: (typeof wrongAnswers)[number],
): string {
  return failureText(words, challenge, failure, diagnosis)
    .replaceAll("\u2068", "")
    .replaceAll("\u2069", "");
}

describe("after the typical wrong answer to", () => {
  const words = reader("en", en, english, reasons);

  it.each(wrongAnswers)("$id the student reads which line is the cause, and why", (each) => {
    const text = feedback(words, each);
    expect(text).toBe(each.reads);
    expect(text).toMatch(/line \d|“otherwise”|no line/i);
  });
});

describe.each(languages.filter(({ tag }) => tag !== "en"))("in $name", ({ tag }) => {
  it("every feedback is a sentence with all of its values", async () => {
    const [words, own, why] = await Promise.all([
      loadWords(tag, "words"),
      loadWords(tag, "missions"),
      loadWords(tag, "diagnosis"),
    ]);
    const theirs = reader(tag, words, own, why);
    for (const each of wrongAnswers) {
      const text = feedback(theirs, each);
      expect(text).not.toMatch(/\{\{|undefined|NaN|missions:|diagnosis:/);
      expect(text).not.toBe(each.reads);
    }
  });
});
