/** English texts of missions and diagnoses. */
import reasons from "../../../text/en/diagnosis.json" with { type: "json" };
import { en } from "../../../text/en/index.ts";
import english from "../../../text/en/missions.json" with { type: "json" };
import { createI18n } from "../../../text/i18n.ts";
import type { MissionWords } from "../mission-words.ts";

const i18n = createI18n(en);
i18n.addResourceBundle("en", "diagnosis", reasons);
i18n.addResourceBundle("en", "missions", english);

export const words: MissionWords = {
  t: i18n.getFixedT("en", ["missions", "words"]) as MissionWords["t"],
  i18n: { language: "en" },
};

/** Removes the invisible marks around inserted values. */
export const plain = (text: string): string => text.replaceAll(/[\u2068\u2069]/gu, "");
