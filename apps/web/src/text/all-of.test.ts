// cspell:words افحص المتاهتين allen Labyrinthen prüfen
import i18next from "i18next";
import { describe, expect, it } from "vitest";
import arabic from "./ar/missions.json";
import { allOf } from "./all-of.ts";
import { en } from "./en/index.ts";
import english from "./en/missions.json";
import { createI18n, showLanguage } from "./i18n.ts";

async function check(tag: string, missions: object, count: number): Promise<string> {
  const words = i18next.createInstance();
  await words.init({ lng: tag, ns: ["missions"], resources: { [tag]: { missions } } });
  return words.t("missions:card.check", allOf(count, tag));
}

describe("a text about all mazes of a mission", () => {
  it.each([
    [1, "Check the program"],
    [2, "Check in both mazes"],
    [3, "Check in all 3 mazes"],
    [1001, "Check in all 1,001 mazes"],
  ])("has words for %i", async (count, text) => {
    expect(await check("en", english, count)).toBe(text);
  });

  it("groups the digits as the language does", async () => {
    const words = createI18n(en);
    await words.loadNamespaces("missions");
    await showLanguage(words, "de");
    expect(words.t("missions:card.check", allOf(1001, "de"))).toBe(
      "In allen 1.001 Labyrinthen prüfen",
    );
  });

  it("has the dual of Arabic for 2", async () => {
    expect(await check("ar", arabic, 2)).toBe("افحص في المتاهتين");
  });
});
