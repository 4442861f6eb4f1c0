import { describe, expect, it } from "vitest";
import { createScreenStore } from "../screen/screen-store.ts";
import { en } from "../../text/en/index.ts";
import { createI18n } from "../../text/i18n.ts";
import { LanguageChoice, sharedSearch } from "./language.ts";
import { MemoryStorage } from "../storage/testing/memory-storage.ts";

function openPage({ search = "", stored = "", preferred = ["en"] }) {
  const storage = new MemoryStorage();
  if (stored !== "") storage.setItem("corridor.language", stored);
  const words = createI18n(en);
  const screen = createScreenStore();
  const location = { pathname: "/", search, hash: "#1maze" };
  const shown: string[] = [];
  const choice = new LanguageChoice({
    words,
    screen,
    storage,
    offered: ["en", "ar", "de"],
    preferred,
    location,
    replaceAddress: (address) => {
      const url = new URL(address, "https://corridor.test");
      Object.assign(location, { search: url.search, hash: url.hash });
    },
    apply: ({ tag, dir, title }) => shown.push(`${tag} ${dir} ${title}`),
  });
  const messages = () => screen.getState().messages.map(({ text }) => text);
  return { choice, words, storage, location, shown, messages };
}

describe("the language at the start", () => {
  it.each([
    { name: "the address", search: "?lang=de", stored: "en", preferred: ["ar"], tag: "de" },
    { name: "the device's choice", search: "", stored: "de", preferred: ["ar"], tag: "de" },
    { name: "the browser's first that there is", preferred: ["tlh", "de-CH", "ar"], tag: "de" },
    { name: "English for want of better", preferred: ["tlh"], tag: "en" },
    {
      name: "the browser's if what was stored is none",
      stored: "xx",
      preferred: ["de"],
      tag: "de",
    },
  ])("is $name", async ({ tag, ...given }) => {
    const page = openPage(given);
    await page.choice.start();
    expect(page.words.language).toBe(tag);
    expect(page.shown.at(-1)).toContain(`${tag} ltr Corridor`);
    expect(page.messages()).toEqual([]);
  });

  it("reports a language in the address that does not exist, and removes it", async () => {
    const page = openPage({ search: "?lang=tlh&x=1", preferred: ["en"] });
    await page.choice.start();
    expect(page.messages()).toEqual([
      "Corridor is not available in the language of this link: “tlh”.",
    ]);
    expect(page.location).toMatchObject({ search: "?x=1", hash: "#1maze" });
  });

  it("stays out of the address until the user chooses a language", async () => {
    const page = openPage({ stored: "de" });
    await page.choice.start();
    expect(page.location.search).toBe("");
  });
});

describe("a chosen language", () => {
  it("is displayed, stored, and in the address beside other parameters", async () => {
    const page = openPage({ search: "?x=1" });
    await page.choice.start();
    await page.choice.choose("ar");
    expect(page.words.t("language.language")).toBe("اللغة");
    expect(page.shown.at(-1)).toMatch(/^ar rtl Corridor/);
    expect(page.storage.getItem("corridor.language")).toBe("ar");
    expect(page.location).toMatchObject({ search: "?x=1&lang=ar", hash: "#1maze" });
  });

  it("is the newest one, in every order of arrival", async () => {
    const page = openPage({});
    await page.choice.start();
    await Promise.all([page.choice.choose("ar"), page.choice.choose("de")]);
    expect(page.words.language).toBe("de");
    expect(page.storage.getItem("corridor.language")).toBe("de");
    expect(page.location.search).toBe("?lang=de");
  });

  it("isolates a value in a sentence of the other direction", async () => {
    const page = openPage({});
    await page.choice.choose("ar");
    expect(page.words.t("language.unknown", { tag: "de-1" })).toContain("\u2068de-1\u2069");
    await page.choice.choose("en");
    expect(page.words.t("language.unknown", { tag: "de-1" })).toContain("“de-1”");
  });
});

it("formats numbers in sentences by the language", async () => {
  const page = openPage({});
  const read = () => page.words.t("remote.quiet", { seconds: "12.5" });
  expect(read()).toContain("12.5");
  await page.choice.choose("de");
  expect(read()).toContain("12,5");
});

describe("a shared link", () => {
  it.each([
    ["", ""],
    ["?x=1", ""],
    ["?x=1&lang=zh-Hans", "?lang=zh-Hans"],
  ])("of a page at %j carries %j", (search, carried) => {
    expect(sharedSearch(search)).toBe(carried);
  });
});
