import { describe, expect, it, onTestFinished, vi } from "vitest";
import { languageOf, languages, matchLanguage } from "./languages.ts";

const tags = ["en", "ar", "de", "es", "fr", "ja", "pt", "zh-Hans"];

describe("the language for a reader", () => {
  it.each([
    { wanted: ["de"], tag: "de" },
    { wanted: ["de-AT", "en"], tag: "de" },
    { wanted: ["pt-BR"], tag: "pt" },
    { wanted: ["zh-CN"], tag: "zh-Hans" },
    { wanted: ["zh"], tag: "zh-Hans" },
    { wanted: ["zh-SG"], tag: "zh-Hans" },
    { wanted: ["zh-TW", "ja"], tag: "ja" },
    { wanted: ["zh-Hant-HK"], tag: null },
    { wanted: ["ar-EG"], tag: "ar" },
    { wanted: ["tlh", "fr-CA", "de"], tag: "fr" },
    { wanted: ["DE-de"], tag: "de" },
    { wanted: ["no tag", "", "es"], tag: "es" },
    { wanted: [], tag: null },
  ])("who wants $wanted gets $tag", ({ wanted, tag }) => {
    expect(matchLanguage(wanted, tags)).toBe(tag);
  });

  // A browser prepares `Intl.Locale` at its first use, which delays the first paint.
  it.each([
    { wanted: ["en-GB"], tag: "en" },
    { wanted: ["pt"], tag: "pt" },
    { wanted: ["zh-CN"], tag: null },
  ])("who wants $wanted is $tag in a browser without Intl.Locale", ({ wanted, tag }) => {
    vi.stubGlobal("Intl", {});
    onTestFinished(() => void vi.unstubAllGlobals());
    expect(matchLanguage(wanted, tags)).toBe(tag);
  });

  it("is never one that is not among those to choose from", () => {
    expect(matchLanguage(["de", "en-GB"], ["en"])).toBe("en");
  });
});

it.each(languages)(
  "$tag runs as its script does, and its name is its own",
  ({ tag, name, dir }) => {
    expect(languageOf(tag).dir).toBe(dir);
    expect(new Intl.Locale(tag).maximize().script === "Arab").toBe(dir === "rtl");
    const own = new Intl.DisplayNames(tag, { type: "language" }).of(tag) ?? "";
    expect(name.toLocaleLowerCase(tag)).toBe(own.toLocaleLowerCase(tag));
  },
);
