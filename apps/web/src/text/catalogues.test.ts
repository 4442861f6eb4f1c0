// cspell:words geht Stoß Stöße kein Ziel Ziele fertig mehr صدمة
import { readdirSync, readFileSync } from "node:fs";
import { describe, expect, it } from "vitest";
import { en } from "./en/index.ts";
import { languages } from "./languages.ts";
import { loadWords } from "./load-words.ts";
import { catalogueFaults, sourceFaults, type Catalogue } from "./testing/catalogue-faults.ts";

/** The JSON files of a language: one property per file. */
function readCatalogue(tag: string): Catalogue {
  const folder = new URL(`${tag}/`, import.meta.url);
  const files = readdirSync(folder).filter((name) => name.endsWith(".json"));
  return Object.fromEntries(
    files.map((name) => [
      name.replace(".json", ""),
      JSON.parse(readFileSync(new URL(name, folder), "utf8")) as Catalogue,
    ]),
  );
}

const english = readCatalogue("en");
const others = languages.filter(({ tag }) => tag !== "en");

describe("the catalogues", () => {
  it("exist for every language, and for no other", () => {
    const folders = readdirSync(new URL(".", import.meta.url), { withFileTypes: true })
      .filter((entry) => entry.isDirectory() && entry.name !== "testing")
      .map(({ name }) => name);
    expect(folders.toSorted()).toEqual(languages.map(({ tag }) => tag).toSorted());
  });

  it("have valid English texts", () => {
    expect(sourceFaults(english)).toEqual([]);
  });

  it.each(others)("are complete and valid in $name", (language) => {
    const mayLack = "isDraft" in language;
    expect(
      catalogueFaults(english, readCatalogue(language.tag), language.tag, { mayLack }),
    ).toEqual([]);
  });

  it.each(others)("load the texts of the page in $name", async (language) => {
    const files = readCatalogue(language.tag);
    const loaded = await loadWords(language.tag, "words");
    const names = Object.keys("isDraft" in language ? loaded : en);
    expect(loaded).toEqual(Object.fromEntries(names.map((name) => [name, files[name]])));
  });
});

describe("a translation", () => {
  const source = {
    greeting: "Hello {{name}}, how are you?",
    bumps_one: "{{count}} bump",
    bumps_other: "{{count}} bumps",
    goals_zero: "no goal of {{all}}",
    goals_one: "one goal of {{all}}",
    goals_other: "{{count}} goals of {{all}}",
    key: "Key",
    done: "The maze is ready.",
  };
  const german = {
    greeting: "Hallo {{name}}, wie geht es dir?",
    bumps_one: "{{count}} Stoß",
    bumps_other: "{{count}} Stöße",
    goals_zero: "kein Ziel von {{all}}",
    goals_one: "ein Ziel von {{all}}",
    goals_other: "{{count}} Ziele von {{all}}",
    key: "Key",
    done: "Das Labyrinth ist fertig.",
  };

  it("that is complete has no faults", () => {
    expect(catalogueFaults(source, german, "de")).toEqual([]);
  });

  it.each([
    { fault: "greeting: is missing", change: { greeting: undefined } },
    { fault: "more: is not in English", change: { more: "mehr" } },
    { fault: "greeting: {{name}} is missing", change: { greeting: "Hallo, wie geht es dir?" } },
    { fault: "greeting: {{nam}} is not in English", change: { greeting: "{{nam}} und {{name}}" } },
    { fault: "bumps_one: is missing", change: { bumps_one: undefined } },
    { fault: "bumps_many: is not in English", change: { bumps_many: "{{count}} Stöße" } },
    { fault: "goals_zero: is missing", change: { goals_zero: undefined } },
    { fault: "goals_one: {{all}} is missing", change: { goals_one: "ein Ziel" } },
    { fault: "done: is still English: The maze is ready.", change: { done: source.done } },
    { fault: "done: does not end as a sentence", change: { done: "Fertig" } },
    { fault: "done: contains HTML", change: { done: "<b>Fertig</b>." } },
    { fault: "done: is empty", change: { done: "" } },
    { fault: "key: has a broken placeholder", change: { key: "Taste {{" } },
    { fault: "key: has invisible spaces", change: { key: " Taste" } },
  ])("is reported: $fault", ({ fault, change }) => {
    const changed: Record<string, string | undefined> = { ...german, ...change };
    const texts = Object.entries(changed).flatMap(([key, text]) =>
      text === undefined ? [] : [[key, text] as const],
    );
    expect(catalogueFaults(source, Object.fromEntries(texts), "de")).toContain(fault);
  });

  it("requires every plural form of its language", () => {
    const bumps = { bumps_one: source.bumps_one, bumps_other: source.bumps_other };
    expect(catalogueFaults(bumps, { bumps_other: "{{count}} 回" }, "ja")).toEqual([]);
    expect(catalogueFaults(bumps, { bumps_other: "{{count}} صدمة" }, "ar")).toEqual(
      ["zero", "one", "two", "few", "many"].map((form) => `bumps_${form}: is missing`),
    );
  });

  it("uses the script of its language, except for names", () => {
    const words = { key: "Key", python: "Python" };
    expect(catalogueFaults(words, { key: "Key", python: "Python" }, "ja")).toEqual([
      "key: is still English: Key",
    ]);
  });
});
