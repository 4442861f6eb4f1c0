// cspell:disable -- words of eight languages
import { NAME_WORDS, studentNameSchema } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { en } from "../../text/en/index.ts";
import { createI18n } from "../../text/i18n.ts";
import { languages, type LanguageTag } from "../../text/languages.ts";
import { loadWords } from "../../text/load-words.ts";
import { studentNameText } from "./student-name.ts";

/** Animals, plants and things that insult a person in the language, or in a country that uses it. */
const insults: Record<LanguageTag, string> = {
  ar: "حمار كلب خنزير قرد بقرة جحش ضبع غراب بومة تيس ثور جاموس فأر خروف حشرة صرصور",
  de: "Esel Sau Schwein Kuh Ochse Gans Ziege Affe Ratte Ferkel Kamel Trampel Zicke Pflaume Pfeife Flasche Möse Specht Gurke",
  en: "Ass Donkey Booby Tit Cock Cow Pig Hog Rat Monkey Ape Beaver Weasel Toad Slug Snake Nut Fruit Pansy Bush Melons Jackass Shrew",
  es: "Burro Cerdo Vaca Foca Zorra Perra Gallina Rata Buitre Concha Papaya Almeja Conejo Bollo Pito Polla Chucha Chivo Cuervo Culebra Pepino Nabo Pájaro Cabra",
  fr: "Chatte Moule Vache Cochon Porc Âne Dinde Thon Baleine Morue Truie Chienne Pie Poule Guenon Abricot Gland Poire Cornichon Courge Patate Navet Bécasse Grue",
  ja: "ブタ サル ゴリラ イヌ キツネ タヌキ ブタノハナ カバ ドブネズミ ハゲタカ ハイエナ ゴキブリ ウジ",
  pt: "Burro Vaca Galinha Perereca Periquita Veado Piranha Porco Baleia Cobra Macaco Anta Égua Cadela Cabra Rata Pinto Rola Pomba Banana Pepino Urubu Jumento",
  "zh-Hans": "乌龟 王八 鸡 鸭 猪 狗 驴 猴子 老鼠 蛇 狐狸 龟 鳖 傻瓜 苦瓜 冬瓜 绿帽 鸡蛋 笨蛋 黄瓜",
};

async function wordsOf(tag: LanguageTag): Promise<string[]> {
  const { words } = await loadWords(tag, "names");
  return Object.values(words as Record<string, string>);
}

describe("the name of a student", () => {
  const pages = async (language: LanguageTag) => {
    const words = createI18n(en);
    await words.changeLanguage(language);
    await words.loadNamespaces("names");
    return words.getFixedT(language, "names");
  };

  it("is the word with the number that the relay assigned, in the language of the page", async () => {
    const [english, german] = [await pages("en"), await pages("de")];
    expect(studentNameText(english, { word: 0, text: null })).toBe("Acorn");
    expect(studentNameText(english, { word: NAME_WORDS - 1, text: null })).toBe("Zinnia");
    expect(studentNameText(german, { word: 136, text: null })).toBe("Wacholder");
  });

  it("is the pseudonym of a teacher who pasted one", async () => {
    expect(studentNameText(await pages("en"), { word: null, text: "Team 4" })).toBe("Team 4");
  });
});

describe.each(languages)("the list of words in $name", ({ tag }) => {
  it("has a different word for each number", async () => {
    const words = await wordsOf(tag);
    expect(words).toHaveLength(NAME_WORDS);
    expect(new Set(words.map((word) => word.toLocaleLowerCase(tag))).size).toBe(NAME_WORDS);
  });

  it("has words that fit wherever a pseudonym fits", async () => {
    const fits = (text: string) => studentNameSchema.safeParse({ word: null, text }).success;
    expect((await wordsOf(tag)).filter((word) => !fits(word))).toEqual([]);
  });

  it("has no word that insults a person", async () => {
    const words = new Set(await wordsOf(tag));
    expect(insults[tag].split(" ").filter((word) => words.has(word))).toEqual([]);
  });
});
